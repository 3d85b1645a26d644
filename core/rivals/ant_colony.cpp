#include "rivals/ant_colony.h"

#include <algorithm>
#include <numeric>

#include "base/index.h"

namespace liftarm::rivals {

namespace {

using base::at;

constexpr double kStay = 0.95;      // of the pheromone, each generation
constexpr double kLeast = 0.01;     // pheromone against the most there may be
constexpr double kLayerCost = 2.0;  // exponent base is 1 + cost
constexpr double kOffLine = 0.05;
constexpr std::size_t kLayers = layout::kLayerCount;

bool coversEdge(const search::PaperPlacement& p, std::pair<int, int> edge) {
  const auto within = [&](int run, int start, int holes) {
    return run == edge.first && start <= edge.second && start + holes - 1 > edge.second;
  };
  return within(p.run, p.start, p.holes) || within(p.mate, p.mateStart, p.mateHoles);
}

layout::Beam firstArm(const layout::Cover& cover, const search::PaperPlacement& p, int layer) {
  const auto found =
      std::find_if(cover.beams.begin(), cover.beams.end(), [&](const layout::Beam& beam) {
        return beam.start == p.start && beam.holes == p.holes && beam.layer == layer &&
               beam.mate == p.mate;
      });
  return *found;
}

}  // namespace

AntColony::AntColony(const layout::LayoutProblem& problem,
                     layout::ConnectionSolver& solver,
                     RivalOptions options)
    : RivalSearch(problem, solver, std::move(options)),
      generations_(
          static_cast<std::uint64_t>(std::max(1.0, this->options().effort * kGenerations))) {
  for (const auto& [run, edge] : paperOperator().edges()) {
    if (beams().coverable(run, edge)) {
      rows_.emplace_back(run, edge);
    }
  }
  std::vector<int> runs(problem.graph.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  columnsOf_.resize(rows_.size());
  for (const search::PaperPlacement& p : beams().placements(runs, this->options().paper.corners)) {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      if (coversEdge(p, rows_[row])) {
        columnsOf_[row].push_back(static_cast<int>(columns_.size()));
      }
    }
    columns_.push_back({p, std::vector<double>(kLayers, 1.0)});
  }
}

void AntColony::clear() {
  for (std::size_t run = 0; run < problem().graph.runs.size(); ++run) {
    while (!beams().cover(static_cast<int>(run)).beams.empty()) {
      beams().remove(static_cast<int>(run),
                     layout::Beam{beams().cover(static_cast<int>(run)).beams.back()});
    }
  }
}

int AntColony::newlyCovered(const search::PaperPlacement& p) const {
  int count = 0;
  for (int e = p.start; e < p.start + p.holes - 1; ++e) {
    count += beams().covered(p.run, e) ? 0 : 1;
  }
  for (int e = p.mateStart; p.mate >= 0 && e < p.mateStart + p.mateHoles - 1; ++e) {
    count += beams().covered(p.mate, e) ? 0 : 1;
  }
  return count;
}

//! One L beam at most joins two runs.
bool AntColony::isTaken(const search::PaperPlacement& p) const {
  const std::vector<layout::Beam>& there = beams().cover(p.run).beams;
  return p.mate >= 0 && std::any_of(there.begin(), there.end(), [&](const layout::Beam& beam) {
           return beam.mate == p.mate;
         });
}

//! The column and layer for an uncovered row; false where none covers it.
bool AntColony::choose(std::size_t row, std::pair<int, int>* chosen) {
  const std::vector<int>& candidates = columnsOf_[row];
  weights_.assign(candidates.size() * kLayers, 0.0);
  double sum = 0.0;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const Column& column = columns_[at(candidates[c])];
    if (isTaken(column.placement)) {
      continue;
    }
    const double covers = static_cast<double>(newlyCovered(column.placement));
    const std::vector<double> costs = paperOperator().layerCosts(beams(), column.placement);
    for (std::size_t layer = 0; layer < kLayers; ++layer) {
      const int off = static_cast<int>(layer) - guide::kMaxLayer;
      const double cost = 1.0 + kLayerCost * costs[layer] + kOffLine * std::abs(off);
      const double worth = covers / (cost * cost);
      weights_[c * kLayers + layer] = column.pheromone[layer] * worth * worth;
      sum += weights_[c * kLayers + layer];
    }
  }
  double draw = rng()->unit() * sum;
  std::size_t last = weights_.size();
  for (std::size_t i = 0; i < weights_.size() && draw >= 0.0; ++i) {
    if (weights_[i] > 0.0) {
      draw -= weights_[i];
      last = i;
    }
  }
  if (last == weights_.size()) {
    return false;
  }
  *chosen = {candidates[last / kLayers], static_cast<int>(last % kLayers)};
  return true;
}

AntColony::Walk AntColony::walk() {
  clear();
  Walk walk;
  std::vector<std::size_t> order(rows_.size());
  std::iota(order.begin(), order.end(), 0U);
  // Rows in random order, those that are covered by then left out: each time a random one.
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[rng()->below(static_cast<std::uint32_t>(i))]);
  }
  for (const std::size_t row : order) {
    std::pair<int, int> chosen;
    if (!beams().covered(rows_[row].first, rows_[row].second) && choose(row, &chosen)) {
      beams().add(columns_[at(chosen.first)].placement, chosen.second - guide::kMaxLayer);
      walk.push_back(chosen);
    }
  }
  return walk;
}

//! Takes off, in random order, each beam without which the layout costs less.
Judgement AntColony::prune(Walk* walk) {
  for (std::size_t i = walk->size(); i > 1; --i) {
    std::swap((*walk)[i - 1], (*walk)[rng()->below(static_cast<std::uint32_t>(i))]);
  }
  Judgement now = judge().look(&beams());
  judge().keep(&beams());
  Walk left;
  for (const auto& [column, layer] : *walk) {
    const search::PaperPlacement& p = columns_[at(column)].placement;
    beams().remove(p.run, firstArm(beams().cover(p.run), p, layer - guide::kMaxLayer));
    const Judgement without = judge().look(&beams());
    if (without.cost() < now.cost()) {
      judge().keep(&beams());
      now = without;
    } else {
      judge().revert(&beams());
      left.emplace_back(column, layer);
    }
  }
  *walk = std::move(left);
  return now;
}

void AntColony::fadeAndLay() {
  for (Column& column : columns_) {
    for (double& amount : column.pheromone) {
      amount = std::max(kLeast, kStay * amount);
    }
  }
  for (const auto& [column, layer] : best_) {
    double& amount = columns_[at(column)].pheromone[at(layer)];
    amount = std::min(1.0, amount + (1.0 - kStay));
  }
}

bool AntColony::step() {
  for (int ant = 0; ant < kAnts; ++ant) {
    Walk found = walk();
    const Judgement judgement = prune(&found);
    if (best_.empty() || judgement.cost() < bestCost_) {
      bestCost_ = judgement.cost();
      best_ = std::move(found);
    }
    offer(beams(), judgement);
  }
  fadeAndLay();
  return iterations() >= generations_;
}

double AntColony::share() const {
  return static_cast<double>(iterations()) / static_cast<double>(generations_);
}

}  // namespace liftarm::rivals
