#pragma once

#include <utility>
#include <vector>

#include "rivals/rival_search.h"

namespace liftarm::rivals {

//! \brief "(iii) a beam search method, which builds a three-layered search tree of partial layouts
//! as internal nodes and iteratively updates the layout with the local best choice using a beam
//! search width of 75" (paper, section 6).
//! \details Read: from the layout so far, a tree whose levels are one beam each; of each level the
//! 75 best partial layouts are gone on with; the first beam of the best layout of the third level
//! is laid, and the tree is built anew from there. What a level may add are the placements that
//! cover the first uncovered edge of a sweep across the sketch, so that decisions that depend on
//! each other are made one after the other, each on the two layers that suit it best. Partial
//! layouts are compared by their faults and by their beams with those that the uncovered edges
//! still need at least.
class BeamSearch final : public RivalSearch {
 public:
  static constexpr int kLevels = 3;
  static constexpr int kWidth = 75;

  BeamSearch(const layout::LayoutProblem& problem,
             layout::ConnectionSolver& solver,
             RivalOptions options);

 protected:
  bool step() override;
  [[nodiscard]] double share() const override;

 private:
  struct Choice {
    search::PaperPlacement placement;
    int layer = 0;
  };

  struct Node {
    std::vector<Choice> choices;  // from the layout so far
    double score = 0.0;
    bool whole = false;
  };

  [[nodiscard]] std::vector<Choice> choicesAt(std::pair<int, int> edge);
  [[nodiscard]] const std::pair<int, int>* firstUncovered() const;
  [[nodiscard]] double score(const Judgement& judgement);
  void lay(const std::vector<Choice>& choices);
  void expand(const Node& node, std::vector<Node>* next);

  std::vector<std::pair<int, int>> sweep_;  // all edges that can be covered, in order
  std::size_t width_;
  int edgesLeft_ = 0;
};

}  // namespace liftarm::rivals
