#pragma once

#include <array>
#include <vector>

#include "base/rng.h"
#include "guide/guiding_graph.h"
#include "guide/orientation.h"

namespace liftarm::guide {

//! \brief What a symmetry makes of a run: which run, in which sense of direction, and how hole axes
//! and layers change.
struct RunImage {
  int run = -1;
  bool reversed = false;
  std::array<int, 3> axes{0, 1, 2};   //!< image of each hole axis
  std::array<int, 3> signs{1, 1, 1};  //!< of the layers along it
  //! Added to the layers along it, after the sign: two beams that meet in the mirror cannot lie on
  //! one layer, so they pass each other as a builder's rafters do.
  std::array<int, 3> lifts{0, 0, 0};

  [[nodiscard]] int layerOf(int layer, std::size_t axis) const {
    return layer * signs[axis] + lifts[axis];
  }

  friend bool operator==(const RunImage& a, const RunImage& b) {
    return a.run == b.run && a.reversed == b.reversed && a.axes == b.axes && a.signs == b.signs &&
           a.lifts == b.lifts;
  }
};

//! \brief How a run with this hole axis is bound to itself.
struct SelfBinding {
  bool allowed = true;   //!< the axis is its own image under all that maps the run onto itself
  bool pinned = false;   //!< layer 0 only
  bool centred = false;  //!< its cover reads the same from both ends ...
  int sign = 1;          //!< ... with the layers of one half times this
};

//! \brief The runs that the confirmed symmetries of a sketch bind together, and how.
//!
//! \details Symmetries may contradict each other, or what parts can do: a shift and a mirror both
//! bring one side of a box onto the other, but only with all beams on layer 0. A symmetry after
//! the first that leaves too many runs without a hole axis is left out whole; single runs that a
//! symmetry would ask the impossible of are left out of it. What is left out is free.
class Orbits {
 public:
  Orbits() = default;

  explicit Orbits(const GuidingGraph& graph);

  //! \brief Whether nothing is bound.
  [[nodiscard]] bool empty() const { return empty_; }

  //! \brief The images of a run, itself included where something maps it onto itself in another
  //! way.
  [[nodiscard]] const std::vector<RunImage>& images(int run) const {
    return images_[static_cast<std::size_t>(run)];
  }

  //! \brief The run with the least number among a run's images and itself.
  [[nodiscard]] int representative(int run) const;

  [[nodiscard]] SelfBinding binding(int run, lattice::Axis axis) const;

  //! \brief Whether a cover of the run with this hole axis can obey the symmetries.
  [[nodiscard]] bool allows(int run, lattice::Axis axis) const {
    return allowed_[static_cast<std::size_t>(run)][static_cast<std::size_t>(lattice::index(axis))];
  }

  //! \brief Frees a run and all its images.
  void release(int run);

 private:
  struct Generator {
    std::vector<RunImage> forward;  // by run; run -1: none
    std::vector<RunImage> backward;
  };

  static Generator makeGenerator(const GuidingGraph& graph,
                                 const std::vector<const GuideSymmetry*>& parts);
  static void drop(Generator* generator, int run);
  static void crossOver(const GuidingGraph& graph, Generator* generator);
  void close(const GuidingGraph& graph);
  [[nodiscard]] bool lost(const GuidingGraph& graph, int run, lattice::Axis axis) const;
  [[nodiscard]] std::vector<int> lostRuns(const GuidingGraph& graph) const;
  [[nodiscard]] int pinnedAxes(const GuidingGraph& graph) const;
  bool accept(const GuidingGraph& graph, Generator generator, bool shift);

  std::vector<Generator> generators_;
  std::vector<std::vector<RunImage>> images_;
  std::vector<std::array<bool, 3>> allowed_;
  bool empty_ = true;
};

//! \brief Stage one (paper 5.1) over orbits: the images of a run have the images of its hole axis.
Orientation estimateOrientation(const GuidingGraph& graph,
                                const Orbits& orbits,
                                int starts,
                                base::Rng* rng);

}  // namespace liftarm::guide
