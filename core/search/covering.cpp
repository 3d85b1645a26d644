#include "search/covering.h"

#include <utility>

#include "search/energy.h"

namespace liftarm::search {

namespace {

CoverCosts coverCosts(const objective::Weights& w) {
  CoverCosts costs;
  costs.beam = weightOf(w, "beams");
  costs.hole = weightOf(w, "holes");
  costs.layerHole = weightOf(w, "layers");
  costs.hinge = weightOf(w, "hinges");
  costs.overhang = weightOf(w, "overhang");
  costs.violation = weightOf(w, "violations");
  return costs;
}

}  // namespace

Covering::Covering(const layout::LayoutProblem& problem,
                   const AnnealingOptions& options,
                   const mechanisms::MechanismTable& table)
    : problem_(&problem),
      lengths_(options.lengths),
      mayBind_(options.parts.orbits),
      coverer_(problem, options.lengths, coverCosts(options.weights)),
      orbits_(problem, options.lengths),
      supply_(options.supply, table),
      axles_(problem, options.parts.axles ? options.axles : std::vector<int>{}) {
  if (!mayBind_) {
    orbits_.releaseAll();
  }
  freeKeptRuns();
}

void Covering::place(layout::Layout* layout, int run, const layout::Cover& cover) const {
  if (orbits_.binds(run)) {
    orbits_.place(layout, run, cover);
  } else {
    layout->setCover(run, cover);
  }
}

bool Covering::cover(CoverRequest request, layout::Layout* layout, base::Rng* rng) {
  const int run = request.run;
  if (axles_.mustHave(run)) {
    return axles_.lay(layout, run);
  }
  std::vector<double> lengthCosts;
  if (supply_.limited()) {
    lengthCosts = supply_.lengthCosts(*layout, run, lengths_, costs().violation);
    request.lengthCosts = lengthCosts;
  }
  if (orbits_.binds(run)) {
    const layout::Cover before = layout->run(run).cover;
    const auto symmetric = orbits_.propose(&coverer_, layout, request, rng);
    place(layout, run, symmetric ? *symmetric : before);
    return symmetric && !(*symmetric == before);
  }
  std::optional<layout::Cover> cover = coverer_.propose(*layout, request, rng);
  if (!cover || *cover == layout->run(run).cover) {
    return false;
  }
  layout->setCover(run, std::move(*cover));
  return true;
}

void Covering::bindAgain() {
  if (mayBind_) {
    orbits_ = OrbitCovers(*problem_, lengths_);
    freeKeptRuns();
  }
}

//! What the sketch keeps on a run need not be on its images.
void Covering::freeKeptRuns() {
  for (int run = 0; run < static_cast<int>(problem_->graph.runs.size()); ++run) {
    if (problem_->keepOf(run) != nullptr && orbits_.binds(run)) {
      orbits_.release(run);
    }
  }
}

void Covering::releaseAxleRuns() {
  for (const int run : axles_.runs()) {
    if (axles_.mustHave(run) && orbits_.binds(run)) {
      orbits_.release(run);
    }
  }
}

}  // namespace liftarm::search
