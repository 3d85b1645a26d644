#pragma once

#include <optional>
#include <span>
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
  //! Arms of bent beams that the request fixes lie at both ends of a run that a mirror halves.
  //! \return Nothing when there is no such cover; the layout is then cleared there.
  std::optional<layout::Cover> propose(RunCoverer* coverer,
                                       layout::Layout* layout,
                                       CoverRequest request,
                                       base::Rng* rng) const;

  //! \brief Whether a bent beam on two runs can be carried to all their images. On a run that a
  //! mirror cuts in half it lies at both ends.
  [[nodiscard]] bool mayBend(int run, int mate, lattice::Axis axis, int layer) const;

  //! \brief Whether an arm of a bent beam does not meet its own image on a run that a mirror
  //! cuts in half.
  [[nodiscard]] bool hasRoom(int run, lattice::Axis axis, const layout::Beam& arm) const;

  //! \brief How many layers further than a run its images lie at most.
  [[nodiscard]] int farthestLift(int run, lattice::Axis axis) const;

  void release(int run) { orbits_.release(run); }

  //! \brief Frees a run, and those that bent beams make one with it.
  //! \param covers Of all runs.
  void release(int run, const std::vector<layout::Cover>& covers);

  //! \brief Frees the runs that meet at a junction, and those bound to them.
  void releaseAt(int junction);

  void releaseAll() { orbits_ = {}; }

 private:
  [[nodiscard]] std::optional<int> imageOfMate(int run,
                                               const guide::RunImage& image,
                                               int mate) const;
  [[nodiscard]] bool mayBendUnder(const guide::RunImage& image,
                                  int run,
                                  int mate,
                                  lattice::Axis axis) const;
  [[nodiscard]] layout::Beam middleBeam(int run,
                                        const guide::SelfBinding& binding,
                                        int reach,
                                        base::Rng* rng) const;
  [[nodiscard]] layout::Beam middleBetween(int run,
                                           const layout::Beam& arm,
                                           const guide::SelfBinding& binding,
                                           base::Rng* rng) const;
  [[nodiscard]] std::optional<layout::Beam> reversed(int run,
                                                     lattice::Axis axis,
                                                     const layout::Beam& beam) const;
  [[nodiscard]] std::optional<std::vector<layout::Beam>> armsOfHalf(
      int run, lattice::Axis axis, std::span<const layout::Beam> fixed) const;
  [[nodiscard]] std::optional<layout::Cover> unfolded(int run,
                                                      const layout::Beam& middle,
                                                      const layout::Cover& cover) const;

  const layout::LayoutProblem* problem_;
  std::vector<int> lengths_;
  guide::Orbits orbits_;
};

}  // namespace liftarm::search
