#include <algorithm>
#include <optional>

#include "search/annealer.h"

// How a search goes on from the layout of an earlier sketch: what was not touched stays as it lies,
// and moves begin at what was.

namespace liftarm::search {

namespace {

constexpr double kEarlierTemperature = 1.5;
constexpr int kPasses = 2;  // over the new runs: those laid first do not see the others

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

//! Lays what an earlier layout had, and covers what is new. \return False when there is nothing
//! to go on from: then the layout is as it was.
bool Annealer::layEarlier() {
  // Orbits and stiffening move runs all over the sketch: what is asked of those is asked afresh.
  if (options_.earlier.empty() || orbits_.active()) {
    return false;
  }
  const KeptRuns kept =
      keepRuns(problem_->graph,
               options_.earlier,
               {options_.lengths, options_.bends, options_.frames, problem_->sites});
  const auto runs = static_cast<int>(problem_->graph.runs.size());
  if (2 * kept.kept < runs) {
    return false;
  }
  mostBeams_ = 0;
  std::vector<int> fresh;
  for (int r = 0; r < runs; ++r) {
    const std::optional<layout::Cover>& cover = kept.covers[at(r)];
    layout_.setCover(r,
                     cover.value_or(layout::Cover{problem_->graph.runs[at(r)].axes.front(), {}}));
    if (!cover) {
      fresh.push_back(r);
      mostBeams_ += fewestBeams_[at(r)] + 1;
      continue;
    }
    for (const layout::Beam& beam : cover->beams) {
      const bool counted = beam.site >= 0 && problem_->sites[at(beam.site)].arms.front().run != r;
      mostBeams_ += counted ? 0 : layout::partsOfBeam(beam.holes);
    }
  }
  layout_.settleAll();
  layout_.keep();
  for (int pass = 0; pass < kPasses; ++pass) {
    for (const int run : fresh) {
      layBestAxis(run);
    }
  }
  energy_ = energy();
  focus_ = kept.touched;
  grown_ = true;
  coldTemperature_ = options_.startTemperature;
  options_.startTemperature = std::min(kEarlierTemperature, coldTemperature_);
  return true;
}

//! Covers a run with the hole axis that suits its neighbours best.
void Annealer::layBestAxis(int run) {
  if (mustHaveAxle_[at(run)] != 0) {
    layAxleOn(run);
    layout_.settle();
    layout_.keep();
    return;
  }
  std::optional<layout::Cover> best;
  double least = 0.0;
  for (const lattice::Axis axis : problem_->graph.runs[at(run)].axes) {
    std::optional<layout::Cover> cover = coverer_.propose(layout_, run, axis, 0.0, &rng_);
    if (!cover) {
      continue;
    }
    layout_.setCover(run, *cover);
    layout_.settle();
    const double now = energy();
    layout_.revert();
    if (!best || now < least) {
      least = now;
      best = std::move(cover);
    }
  }
  if (best) {
    layout_.setCover(run, std::move(*best));
    layout_.settle();
    layout_.keep();
  }
}

//! Whether what came of the earlier layout may stand: whole, and hardly more beams than before.
bool Annealer::keepsUp() const {
  return best_.tallies.violations() + best_.missing == 0 && best_.tallies.beams <= mostBeams_;
}

//! Begins as if there had been no earlier layout: from here on the search is the one that a link
//! does.
void Annealer::startOver() {
  if (grown_) {
    options_.startTemperature = coldTemperature_;
  }
  focus_.clear();
  grown_ = false;
  best_ = {};
  rng_ = base::Rng(options_.seed);
  if (options_.parts.orbits) {
    orbits_ = OrbitCovers(*problem_, options_.lengths);
  }
  layout_.setWeights(std::vector<double>(problem_->graph.junctions.size(), 1.0),
                     std::vector<double>(problem_->graph.runs.size(), 1.0));
  coverer_.setReach(guide::kMaxLayer);
  coverer_.setFixed({});
  iterationsBefore_ += iteration_;
  iteration_ = 0;
  round_ = 0;
  beginAfresh();
}

}  // namespace liftarm::search
