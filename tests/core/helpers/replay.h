#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/helpers/voxel_solids.h"
#include "model/model.h"

namespace liftarm::testing {

//! \brief Parts that leave together along straight legs (modules), one after the other.
struct ReplayMove {
  std::vector<int> parts;
  std::vector<lattice::Vec3> legs;
};

//! \brief Moves real solids (voxels; no prism, no feature, nothing of analysis/) step by step and
//! looks for parts that hit others.
class Replay {
 public:
  //! \pre haveSharedData().
  explicit Replay(const model::Model& model);

  //! \brief Plays moves by which `together` comes apart, each in steps of 1/8 module, and the last
  //! leg of each on in quarter modules until all is clear.
  //! \return One message for each pair that meets.
  std::vector<std::string> play(const std::vector<int>& together,
                                const std::vector<ReplayMove>& moves);

 private:
  struct Bounds {
    lattice::Vec3 min{1e9, 1e9, 1e9};
    lattice::Vec3 max{-1e9, -1e9, -1e9};
  };

  struct Placed {
    const VoxelSolid* solid = nullptr;
    std::vector<lattice::Vec3> surface;  // some of it, world
    Bounds box;
  };

  [[nodiscard]] bool meet(int mover, int fixed, lattice::Vec3 by) const;
  [[nodiscard]] bool near(int mover, int fixed, lattice::Vec3 by) const;
  std::vector<std::string> playMove(const ReplayMove& move, const std::vector<int>& rest) const;

  const model::Model& model_;
  VoxelSolids solids_;
  std::vector<Placed> placed_;
};

}  // namespace liftarm::testing
