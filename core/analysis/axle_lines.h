#pragma once

#include <vector>

#include "analysis/coverage.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief Finds axles that lie along lines of the sketch: such an axle stands for its line as a
//! beam would, and the parts that it goes through are what it is held by.
class AxleLines {
 public:
  //! \pre scene outlives this.
  explicit AxleLines(const Scene& scene);

  //! \brief Axles on the line through two points that reach at least half a module past both.
  [[nodiscard]] std::vector<int> along(lattice::Vec3 a, lattice::Vec3 b) const;

  //! \brief Axles along any of the uncovered edges of some lines, each once.
  [[nodiscard]] std::vector<int> ofLines(const std::vector<int>& lines,
                                         const std::vector<EdgeCover>& coverage) const;

  //! \brief Beams that an axle holds, where it cannot slide out of them.
  [[nodiscard]] std::vector<const model::Connection*> heldBy(int axle) const;

 private:
  struct Shaft {
    int part = -1;
    lattice::Vec3 middle;  //!< world
    lattice::Vec3 axis;
    double half = 0.0;  //!< of its length
  };

  const Scene& scene_;
  std::vector<Shaft> shafts_;
};

}  // namespace liftarm::analysis
