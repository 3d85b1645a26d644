#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/rng.h"
#include "layout/layout.h"
#include "search/beam_prices.h"
#include "search/cover_request.h"
#include "search/junction_costs.h"

namespace liftarm::search {

//! \brief Covers one run anew, exactly, while all other runs stay: dynamic programming over the
//! run's nodes and layers, in place of the paper's edge-by-edge operator (5.2). \details A state is
//! (last node of the latest beam, its layer). The next beam overlaps it in one to three nodes on a
//! neighbouring layer; at a junction with a run of another hole axis the first edge may be left to
//! a mechanism instead (paper 5.2, uncovered edges). Costs add up over beams and nodes, so the
//! cheapest cover is found in O(nodes * layers * lengths). How well mechanisms will join the result
//! is not additive: noise on the costs makes different proposals, and the caller judges them.
class RunCoverer {
 public:
  //! \pre problem outlives the coverer. \param lengths Allowed numbers of holes, ascending.
  RunCoverer(const layout::LayoutProblem& problem, std::vector<int> lengths, CoverCosts costs);

  //! \return The cheapest cover that a request allows, under its noise; nothing when there is none.
  //! What the sketch keeps on the run (layout/keeps.h) is in it besides.
  //! No request leaves anything behind for the next one.
  std::optional<layout::Cover> propose(const layout::Layout& layout,
                                       const CoverRequest& asked,
                                       base::Rng* rng);

  //! \brief What all proposals took, in beams looked at: a measure of time that is no clock.
  [[nodiscard]] std::uint64_t work() const { return work_ + prices_.work(); }

  [[nodiscard]] const CoverCosts& costs() const { return costs_; }

 private:
  struct Choice {
    int previous = -1;  //!< state that it continues, -1 at the run's start
    int start = 0;
  };

  void prepare(const layout::Layout& layout, const CoverRequest& request, base::Rng* rng);
  void markCrossedHoles(std::span<const layout::Beam> fixed);
  [[nodiscard]] bool isCrossed(int node, int layer) const;
  void relax(int state, int start, int fromLayer, int overlapFrom);
  [[nodiscard]] std::optional<double> jointCost(int first,
                                                int last,
                                                int fromLayer,
                                                int layer) const;
  void extendFrom(int last, int layer);
  [[nodiscard]] bool mayStart(int start) const;
  [[nodiscard]] bool mayEnd(int last) const;
  [[nodiscard]] int cheapestEnd();
  [[nodiscard]] layout::Cover coverTo(int state, lattice::Axis axis) const;

  const layout::LayoutProblem* problem_;
  CoverCosts costs_;
  JunctionCosts junctions_;
  BeamPrices prices_;

  // One run's working set, reused from call to call.
  int reach_ = guide::kMaxLayer;
  int edges_ = 0;
  bool exact_ = false;
  std::vector<double> value_;  // by state
  std::vector<Choice> choice_;
  std::vector<std::uint8_t> crossed_;  // by state: a fixed beam's hole goes another way; or empty
  std::uint64_t work_ = 0;
};

}  // namespace liftarm::search
