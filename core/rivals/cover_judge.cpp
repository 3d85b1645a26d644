#include "rivals/cover_judge.h"

namespace liftarm::rivals {

Judgement CoverJudge::look(search::PaperLayout* beams) {
  beams->settle();
  for (const int run : beams->touched()) {
    layout_.setCover(run, beams->cover(run));
  }
  const search::PaperSums& sums = beams->sums();
  const layout::Tallies& tallies = layout_.tallies();
  return {
      sums.gaps + sums.ownCollisions + sums.ownFailures + tallies.collisions + tallies.forbidden,
      sums.uncovered,
      sums.beams,
      sums.holes};
}

void CoverJudge::keep(search::PaperLayout* beams) {
  beams->keep();
  layout_.keep();
}

void CoverJudge::revert(search::PaperLayout* beams) {
  beams->revert();
  layout_.revert();
}

}  // namespace liftarm::rivals
