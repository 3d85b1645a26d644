#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/rng.h"
#include "objective/objective.h"
#include "search/cooling.h"
#include "search/layout_search.h"
#include "search/paper_state.h"

namespace liftarm::search {

struct PaperOptions {
  std::uint64_t seed = 1;
  double startTemperature = 2000.0;  //!< paper 5.3, T_max
  double middleTemperature = 10.0;   //!< T_mid: below it the full objective is used
  double endTemperature = 1e-4;      //!< T_min
  //! \brief r; 0 takes the paper's 0.999 for simple and 0.99997 for complex models, which we tell
  //! apart by kComplexNodes.
  double coolingRate = 0.0;
  //! Another schedule than the exponential one, with as many moves; none: exponential.
  MakeCooling cooling;
  bool corners = true;  //!< whether L beams may be used
  std::vector<int> lengths{2, 3, 5, 6, 7, 9, 11, 13, 15};
  objective::Weights weights = objective::paperWeights(objective::Preset::kSimple);
};

//! \brief Nodes from which on a sketch counts as complex.
inline constexpr int kComplexNodes = 250;

//! \brief The cooling rate of a search: that of the options, or the paper's for such a sketch.
double paperCoolingRate(const layout::LayoutProblem& problem, const PaperOptions& options);

//! \brief The search of \cite xu_2019_computational as written: stage one of 5.1, the layout
//! modification operator of 5.2, Algorithm 1 of 5.3 with its temperatures, and the objective of
//! 4.3. For comparison with the default; on our data structures, mechanisms and connection
//! procedure.
//!
//! Readings (DESIGN 7) where the paper is silent or cannot be meant as printed:
//! - Algorithm 1 minimises; the best layout is kept by (violations, objective), and anew from the
//!   moment the full objective is used.
//! - gap(v) is the range plus 1 less the number of different layers, over all nodes with beams.
//! - "stop at or pass through the edge": beams of the component that cover it, and those with an
//!   end at one of its two nodes.
//! - Candidates are drawn in proportion to the uncovered edges that they cover; the layer is the
//!   one with the fewest occupied nodes and gaps, under noise of up to one and a half gaps.
//! - The simplified objective leaves out the collision term and all that needs connections:
//!   coherence, pin-head ratio and rigidity.
//! - "different valid beam orientations when the layout becomes stable": below T_mid one move in
//!   twenty turns the run of the picked edge before it is covered anew.
//! - Other schedules ("linear, logarithmic, optimum, thermodynamic"; rivals/schedules.h) get as
//! many
//!   moves as the exponential one, and the full objective from the same move on at the latest.
//! - "Beam holes around each group based on a distance threshold of sqrt(3)": of the junction's
//! node
//!   and the uncovered edges beside it; a group is what a junction and those edges are, and is
//!   joined by our connection procedure (layout::LayoutProblem::closeGroups).
//! - The footnote on lines with one interior hole, which a beam of one hole may fill whose hole
//! lies
//!   along the line, is left out: our layouts have no beam across its line.
//! - A failed connection is a cluster too many in a junction's group or in a stack of one run.
class PaperSearch final : public LayoutSearch {
 public:
  //! \pre problem and solver outlive the search.
  PaperSearch(const layout::LayoutProblem& problem,
              layout::ConnectionSolver& solver,
              PaperOptions options);

  bool advance(std::uint32_t iterations) override;

  [[nodiscard]] bool done() const override { return done_; }

  [[nodiscard]] const LayoutSnapshot& best() const override { return best_; }

  [[nodiscard]] std::uint32_t improvements() const override { return improvements_; }

  [[nodiscard]] std::uint64_t iterations() const override { return iteration_; }

  [[nodiscard]] double temperature() const override { return temperature_; }

  [[nodiscard]] double fraction() const override;
  [[nodiscard]] const char* phase() const override;

 private:
  void move();
  void keepBest();
  [[nodiscard]] bool isStable() const;

  const layout::LayoutProblem* problem_;
  layout::ConnectionSolver* solver_;
  PaperOptions options_;
  base::Rng rng_;
  std::optional<PaperState> state_;
  LayoutSnapshot best_;
  std::unique_ptr<Cooling> cooling_;  // none: exponential
  std::uint64_t budget_ = 0;          // moves, where there is a schedule of another kind
  std::uint64_t middle_ = 0;
  bool done_ = false;
  std::uint64_t iteration_ = 0;
  std::uint32_t improvements_ = 0;
  double temperature_ = 0.0;
};

}  // namespace liftarm::search
