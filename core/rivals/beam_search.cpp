#include "rivals/beam_search.h"

#include <algorithm>
#include <tuple>

#include "base/index.h"

namespace liftarm::rivals {

namespace {

using base::at;

constexpr double kFault = 20.0;   // against a beam
constexpr double kHole = 0.02;    // so that shorter beams are taken where they do
constexpr double kNoise = 0.005;  // so that seeds differ
constexpr double kOffLineWorth = 0.1;
constexpr std::size_t kLayersTried = 2;

//! The layers with the least costs, best first.
std::vector<int> bestLayers(const std::vector<double>& costs) {
  std::vector<std::pair<double, int>> order;
  for (int layer = -guide::kMaxLayer; layer <= guide::kMaxLayer; ++layer) {
    const double off = kOffLineWorth * static_cast<double>(layer < 0 ? -layer : layer);
    order.emplace_back(costs[at(layer + guide::kMaxLayer)] + off, layer);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> layers;
  for (std::size_t i = 0; i < kLayersTried; ++i) {
    layers.push_back(order[i].second);
  }
  return layers;
}

bool covers(const search::PaperPlacement& p, std::pair<int, int> edge) {
  const auto within = [&](int run, int start, int holes) {
    return run == edge.first && start <= edge.second && start + holes - 1 > edge.second;
  };
  return within(p.run, p.start, p.holes) || within(p.mate, p.mateStart, p.mateHoles);
}

}  // namespace

BeamSearch::BeamSearch(const layout::LayoutProblem& problem,
                       layout::ConnectionSolver& solver,
                       RivalOptions options)
    : RivalSearch(problem, solver, std::move(options)),
      width_(static_cast<std::size_t>(std::max(1.0, this->options().effort * kWidth))) {
  using Place = std::tuple<double, int, int>;
  std::vector<Place> order;
  for (const auto& [run, edge] : paperOperator().edges()) {
    if (beams().coverable(run, edge)) {
      const lattice::Vec3 p = problem.graph.nodes[at(problem.graph.runs[at(run)].nodes[at(edge)])] +
                              0.5 * problem.graph.runs[at(run)].direction;
      order.emplace_back(p.x + p.y + p.z, run, edge);
    }
  }
  std::sort(order.begin(), order.end());
  for (const auto& [along, run, edge] : order) {
    sweep_.emplace_back(run, edge);
  }
  edgesLeft_ = static_cast<int>(sweep_.size());
}

const std::pair<int, int>* BeamSearch::firstUncovered() const {
  const search::PaperLayout& layout = beams();
  const auto found = std::find_if(sweep_.begin(), sweep_.end(), [&](const auto& edge) {
    return !layout.covered(edge.first, edge.second);
  });
  return found == sweep_.end() ? nullptr : &*found;
}

std::vector<BeamSearch::Choice> BeamSearch::choicesAt(std::pair<int, int> edge) {
  std::vector<Choice> choices;
  for (const search::PaperPlacement& p :
       beams().placements({edge.first}, options().paper.corners)) {
    if (covers(p, edge)) {
      for (const int layer : bestLayers(paperOperator().layerCosts(beams(), p))) {
        choices.push_back({p, layer});
      }
    }
  }
  return choices;
}

double BeamSearch::score(const Judgement& judgement) {
  const double longest = static_cast<double>(options().paper.lengths.back() - 1);
  return kFault * static_cast<double>(judgement.faults) + static_cast<double>(judgement.beams) +
         static_cast<double>(judgement.uncovered) / longest +
         kHole * static_cast<double>(judgement.holes) + kNoise * rng()->unit();
}

void BeamSearch::lay(const std::vector<Choice>& choices) {
  for (const Choice& choice : choices) {
    beams().add(choice.placement, choice.layer);
  }
}

void BeamSearch::expand(const Node& node, std::vector<Node>* next) {
  lay(node.choices);
  const std::pair<int, int>* edge = node.whole ? nullptr : firstUncovered();
  const std::vector<Choice> choices = edge == nullptr ? std::vector<Choice>{} : choicesAt(*edge);
  judge().revert(&beams());
  if (choices.empty()) {
    next->push_back(node);
    next->back().whole = true;
    return;
  }
  for (const Choice& choice : choices) {
    Node child = node;
    child.choices.push_back(choice);
    lay(child.choices);
    const Judgement judgement = judge().look(&beams());
    child.score = score(judgement);
    child.whole = judgement.uncovered == 0;
    judge().revert(&beams());
    next->push_back(std::move(child));
  }
}

bool BeamSearch::step() {
  std::vector<Node> level{Node{}};
  for (int depth = 0; depth < kLevels; ++depth) {
    std::vector<Node> next;
    for (const Node& node : level) {
      expand(node, &next);
    }
    std::stable_sort(
        next.begin(), next.end(), [](const Node& a, const Node& b) { return a.score < b.score; });
    if (next.size() > width_) {
      next.resize(width_);
    }
    level = std::move(next);
  }
  const Node& best = level.front();
  const bool stuck = best.choices.empty();
  if (!stuck) {
    lay({best.choices.front()});
  }
  const Judgement judgement = judge().look(&beams());
  judge().keep(&beams());
  edgesLeft_ = judgement.uncovered;
  offer(beams(), judgement);
  return stuck || edgesLeft_ == 0;
}

double BeamSearch::share() const {
  return 1.0 - static_cast<double>(edgesLeft_) / static_cast<double>(sweep_.size() + 1);
}

}  // namespace liftarm::rivals
