#include <algorithm>

#include "base/index.h"
#include "layout/layout.h"

// Mechanisms beside those that join a junction's beams: what makes a layout stiff in the end.

namespace liftarm::layout {

namespace {

using base::at;

}  // namespace

//! Beams with holes in a junction's box, those of runs that meet there first.
void Layout::addAllTerminals(int junction) {
  localTerminals_ = terminalsAt(junction);
  for (const RunView& view : problem_->views[at(junction)].runs) {
    const std::vector<Beam>& beams = runs_[at(view.run)].cover.beams;
    for (std::size_t b = 0; b < beams.size(); ++b) {
      const std::pair<int, int> terminal{view.run, static_cast<int>(b)};
      const bool near = static_cast<double>(beams[b].solidLast()) >= view.low &&
                        static_cast<double>(beams[b].solidStart()) <= view.high;
      if (near && localTerminals_.size() < LocalProblem::kMaxTerminals &&
          std::find(localTerminals_.begin(), localTerminals_.end(), terminal) ==
              localTerminals_.end()) {
        localTerminals_.push_back(terminal);
      }
    }
  }
}

std::vector<FurtherJoin> Layout::furtherJoins(int junction,
                                              const std::vector<std::vector<int>>& bodies,
                                              std::size_t most) {
  if (problem_->graph.junctions[at(junction)].joint >= 0) {
    return {};
  }
  addAllTerminals(junction);
  allTerminals_ = true;
  fillProblem(junction);
  allTerminals_ = false;
  fillOwn(junction);
  std::vector<int> known;
  for (std::size_t t = 0; t < localTerminals_.size(); ++t) {
    const auto [run, beam] = localTerminals_[t];
    const int body = bodies[at(run)][at(beam)];
    const auto found = std::find(known.begin(), known.end(), body);
    local_.cluster[t] = static_cast<std::int8_t>(found - known.begin());
    if (found == known.end()) {
      known.push_back(body);
    }
  }
  return known.size() < 2 ? std::vector<FurtherJoin>{} : solver_->joins(local_, most);
}

void Layout::addMechanism(int junction, const FurtherJoin& join) {
  JunctionState& state = junctions_[at(junction)];
  addJunction(state, junction, -1);
  state.connection.mechanisms.push_back(join.placed);
  state.connection.cost += join.cost;
  addJunction(state, junction, 1);
}

}  // namespace liftarm::layout
