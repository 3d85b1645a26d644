#pragma once

#include <utility>
#include <vector>

#include "base/rng.h"
#include "layout/layout.h"
#include "search/paper_layout.h"

namespace liftarm::search {

//! \brief The paper's first random layout (5.3) and its layout modification operator (5.2), on the
//! beams of a PaperLayout.
class PaperOperator {
 public:
  //! \param corners Whether L beams may be laid. \pre The others outlive this.
  PaperOperator(const layout::LayoutProblem& problem, bool corners, base::Rng* rng);

  //! \brief The first layout: random uncovered edges, each covered by any placement, all alike
  //! likely.
  void initialise(PaperLayout* beams);

  //! \brief Takes off the beams around a random edge and covers it anew.
  //! \param turning Share of moves that turn the hole axis of the edge's run first.
  void modify(PaperLayout* beams, double turning);

  //! \brief What each layer costs a placement: nodes that are taken and gaps, without noise.
  [[nodiscard]] std::vector<double> layerCosts(const PaperLayout& beams,
                                               const PaperPlacement& placement) const;

  //! \brief All unit edges of the sketch, (run, index).
  [[nodiscard]] const std::vector<std::pair<int, int>>& edges() const { return edges_; }

 private:
  void coverAgain(PaperLayout* beams);
  [[nodiscard]] int pickLayer(const PaperLayout& beams, const PaperPlacement& placement);
  void addLayerCosts(const PaperLayout& beams,
                     const PaperPlacement& arm,
                     std::vector<double>* costs) const;

  const layout::LayoutProblem* problem_;
  bool corners_;
  base::Rng* rng_;
  std::vector<std::pair<int, int>> edges_;
};

}  // namespace liftarm::search
