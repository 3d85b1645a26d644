#pragma once

#include <optional>

#include "base/rng.h"
#include "layout/layout.h"
#include "search/annealing_options.h"
#include "search/axle_runs.h"
#include "search/orbit_covers.h"
#include "search/run_coverer.h"
#include "search/supply.h"

namespace liftarm::search {

//! \brief All that lays covers on runs: beams by the exact coverer, on all images of a run where
//! symmetries bind it, with an eye on the parts owned; axles where they must be.
class Covering {
 public:
  //! \pre problem and table outlive this.
  Covering(const layout::LayoutProblem& problem,
           const AnnealingOptions& options,
           const mechanisms::MechanismTable& table);

  //! \brief Puts a cover on a run, and on those that symmetries bind to it.
  void place(layout::Layout* layout, int run, const layout::Cover& cover) const;

  //! \brief Covers a run anew, as cheaply as the request allows.
  //! \return Whether its cover is another one now. Where there is none, the layout is as it was.
  bool cover(CoverRequest request, layout::Layout* layout, base::Rng* rng);

  //! \brief The cheapest cover of a run alone, whatever binds it and whatever is owned.
  std::optional<layout::Cover> propose(const CoverRequest& request,
                                       const layout::Layout& layout,
                                       base::Rng* rng) {
    return coverer_.propose(layout, request, rng);
  }

  //! \brief Binds again what was freed of its symmetries.
  void bindAgain();

  //! \brief Symmetries do not bind lines that must have an axle: each is laid for itself.
  void releaseAxleRuns();

  [[nodiscard]] OrbitCovers& orbits() { return orbits_; }

  [[nodiscard]] const OrbitCovers& orbits() const { return orbits_; }

  [[nodiscard]] const AxleRuns& axles() const { return axles_; }

  [[nodiscard]] const CoverCosts& costs() const { return coverer_.costs(); }

  //! \brief Parts that a layout needs and nobody owns.
  [[nodiscard]] int missing(const layout::Layout& layout) { return supply_.missing(layout); }

  //! \brief What all covers took, in beams looked at.
  [[nodiscard]] std::uint64_t work() const { return coverer_.work(); }

 private:
  void freeKeptRuns();

  const layout::LayoutProblem* problem_;
  std::vector<int> lengths_;
  bool mayBind_;
  RunCoverer coverer_;
  OrbitCovers orbits_;
  SupplyCounter supply_;
  AxleRuns axles_;
};

}  // namespace liftarm::search
