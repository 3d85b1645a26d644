#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "rivals/rival_search.h"

namespace liftarm::rivals {

//! \brief "(iv) an ant colony optimization method, which generalizes the set cover model in [Ren et
//! al. 2010] to handle beam layering" (paper, section 6).
//! \details Read: the rows of the set cover are the edges that can be covered, its columns the
//! placements, each on each layer. As in \cite ren_2010_new an ant takes a random uncovered row and
//! only then one of the columns that cover it, by pheromone and by a heuristic that is brought up
//! to date: here the edges that the column would newly cover over what its layer costs, in place of
//! Lagrangian duals, which know no layers. Redundant beams go at the end of each ant's walk (its
//! local search). Pheromone as in the max-min ant system: it fades, the best walk so far lays new,
//! and both ends are bounded. The colony is 20 ants, as usual there; the number of generations is
//! ours.
class AntColony final : public RivalSearch {
 public:
  static constexpr int kAnts = 20;
  static constexpr double kGenerations = 150.0;

  AntColony(const layout::LayoutProblem& problem,
            layout::ConnectionSolver& solver,
            RivalOptions options);

 protected:
  bool step() override;
  [[nodiscard]] double share() const override;

 private:
  //! A column: a placement, and the pheromone on it by layer.
  struct Column {
    search::PaperPlacement placement;
    std::vector<double> pheromone;
  };

  using Walk = std::vector<std::pair<int, int>>;  // (column, layer index)

  void clear();
  Walk walk();
  bool choose(std::size_t edge, std::pair<int, int>* chosen);
  [[nodiscard]] int newlyCovered(const search::PaperPlacement& placement) const;
  [[nodiscard]] bool isTaken(const search::PaperPlacement& placement) const;
  Judgement prune(Walk* walk);
  void fadeAndLay();

  std::vector<std::pair<int, int>> rows_;
  std::vector<Column> columns_;
  std::vector<std::vector<int>> columnsOf_;  // by row
  std::vector<double> weights_;              // of one choice
  Walk best_;
  double bestCost_ = 0.0;
  std::uint64_t generations_;
};

}  // namespace liftarm::rivals
