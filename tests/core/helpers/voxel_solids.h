#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lattice/vec.h"
#include "model/model.h"

namespace liftarm::testing {

//! The edge of a cube, modules.
inline constexpr double kCube = 0.5 / 20.0;

//! \brief The real solid of one part, eroded by 0.6 LDU, in cubes of half an LDU, in LDraw's frame.
struct VoxelSolid {
  int nx = 0;
  int ny = 0;
  int nz = 0;
  int ox = 0;  //!< first cube spans ox/2 .. (ox+1)/2 LDU
  int oy = 0;
  int oz = 0;
  std::vector<std::uint8_t> bits;

  [[nodiscard]] bool at(int x, int y, int z) const;

  //! \param p A point in the part's own frame (ours), modules. \return Whether its cube is solid.
  [[nodiscard]] bool contains(lattice::Vec3 p) const;

  //! \brief Middles of all solid cubes, in the part's own frame (ours), modules.
  [[nodiscard]] std::vector<lattice::Vec3> points() const;
};

//! \brief The packed solids of ../shared/solids, unpacked on demand.
class VoxelSolids {
 public:
  //! \pre haveSharedData().
  VoxelSolids();

  //! \return Null when there is no solid of that part.
  const VoxelSolid* find(const std::string& part);

 private:
  struct Entry {
    VoxelSolid shape;
    std::size_t offset = 0;
    std::size_t length = 0;
    bool unpacked = false;
  };

  std::string file_;
  std::size_t dataAt_ = 0;
  std::map<std::string, Entry, std::less<>> entries_;
};

//! \brief Two parts of a model whose real solids share space.
struct VoxelOverlap {
  int partA = -1;
  int partB = -1;
  int cubes = 0;     //!< cubes of A whose middles lie in B
  lattice::Vec3 at;  //!< one of them, world
};

//! \brief Judges a model by its real solids alone: no prism, no feature, nothing of analysis/.
std::vector<VoxelOverlap> voxelOverlaps(const model::Model& model, VoxelSolids& solids);

}  // namespace liftarm::testing
