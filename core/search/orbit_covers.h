#pragma once

#include <optional>
#include <vector>

#include "base/rng.h"
#include "guide/beam_bound.h"
#include "guide/orbits.h"
#include "search/run_coverer.h"

namespace liftarm::search {

//! \brief Covers that obey the symmetries of a sketch: a run's cover is carried to all its images.
class OrbitCovers {
 public:
  OrbitCovers(const layout::LayoutProblem& problem, std::vector<int> lengths);

  //! \brief Whether anything is bound.
  [[nodiscard]] bool active() const { return !orbits_.empty(); }

  [[nodiscard]] const guide::Orbits& orbits() const { return orbits_; }

  [[nodiscard]] bool binds(int run) const { return active() && !orbits_.images(run).empty(); }

  //! \brief Puts a cover on a run and what it maps to on the run's images.
  void place(layout::Layout* layout, int run, const layout::Cover& cover) const;

  //! \brief Clears a run and its images, and covers the run with what may be carried to them.
  //! Beams that the request fixes give way to the one across the middle of a run that a mirror
  //! cuts in half. \return Nothing when there is no such cover; the layout is then cleared there.
  std::optional<layout::Cover> propose(RunCoverer* coverer,
                                       layout::Layout* layout,
                                       CoverRequest request,
                                       base::Rng* rng) const;

  //! \brief Whether a bent beam on two runs can be carried to all their images.
  [[nodiscard]] bool mayBend(int run, int mate, lattice::Axis axis, int layer) const;

  //! \brief How many layers further than a run its images lie at most.
  [[nodiscard]] int farthestLift(int run, lattice::Axis axis) const;

  void release(int run) { orbits_.release(run); }

  //! \brief Frees the runs that meet at a junction, and those bound to them.
  void releaseAt(int junction);

  void releaseAll() { orbits_ = {}; }

 private:
  [[nodiscard]] std::optional<int> imageOfMate(int run,
                                               const guide::RunImage& image,
                                               int mate) const;
  [[nodiscard]] layout::Beam middleBeam(int run,
                                        const guide::SelfBinding& binding,
                                        int reach,
                                        base::Rng* rng) const;

  const layout::LayoutProblem* problem_;
  std::vector<int> lengths_;
  guide::Orbits orbits_;
};

}  // namespace liftarm::search
