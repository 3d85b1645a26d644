#pragma once

#include "layout/layout.h"
#include "search/paper_layout.h"

namespace liftarm::rivals {

//! \brief What the rivals look at: "specifically for minimal gap and minimal beam counts" (paper,
//! section 6). Collisions, beams where none may be and beams in line that nothing joins count as
//! gaps do.
struct Judgement {
  int faults = 0;
  int uncovered = 0;  //!< edges that a beam could cover and none does
  int beams = 0;
  int holes = 0;

  //! \brief One number for finished layouts: faults first, then beams, then holes.
  [[nodiscard]] double cost() const {
    return 100.0 * static_cast<double>(faults + uncovered) + static_cast<double>(beams) +
           0.01 * static_cast<double>(holes);
  }
};

//! \brief Judges a PaperLayout after each edit, by what the edit touched; beams stay unconnected.
class CoverJudge {
 public:
  //! \pre problem and solver outlive this. The layout judged is empty at first.
  CoverJudge(const layout::LayoutProblem& problem, layout::ConnectionSolver& solver)
      : layout_(problem, solver) {}

  //! \brief Settles the beams and counts.
  Judgement look(search::PaperLayout* beams);

  void keep(search::PaperLayout* beams);
  void revert(search::PaperLayout* beams);

 private:
  layout::Layout layout_;
};

}  // namespace liftarm::rivals
