#include "search/paper_orientation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/det_math.h"
#include "base/index.h"

namespace liftarm::search {

namespace {

using base::at;
using guide::GuidingGraph;
using guide::Orientation;
using lattice::Axis;
using lattice::Vec3;

constexpr double kStartTemperature = 2000.0;
constexpr double kEndTemperature = 0.01;
constexpr double kSlowestRate = 0.5;
constexpr double kSamePlace = 0.1;  // modules; symmetric nodes are off by what snapping left

bool same(Vec3 a, Vec3 b) {
  const Vec3 d = a - b;
  return lattice::dot(d, d) < kSamePlace * kSamePlace;
}

//! A run that must turn with another one: to axes[i] when the other turns to axis i.
struct Tie {
  int run = -1;
  std::array<Axis, 3> axes{};
};

using Ties = std::vector<std::vector<Tie>>;

Axis mapped(const lattice::Mat3& linear, Axis axis) {
  const Vec3 image = linear * lattice::unitVector(axis);
  int main = 0;
  for (int i = 1; i < 3; ++i) {
    main = std::abs(image[i]) > std::abs(image[main]) ? i : main;
  }
  return lattice::axisFromIndex(main);
}

bool isImage(const GuidingGraph& graph, const guide::GuideSymmetry& s, int run, int partner) {
  const std::vector<int>& mine = graph.runs[at(run)].nodes;
  const std::vector<int>& theirs = graph.runs[at(partner)].nodes;
  if (mine.size() != theirs.size()) {
    return false;
  }
  const auto image = [&](int node) { return s.linear * graph.nodes[at(node)] + s.shift; };
  const Vec3 a = graph.nodes[at(mine.front())];
  const Vec3 b = graph.nodes[at(mine.back())];
  const Vec3 p = image(theirs.front());
  const Vec3 q = image(theirs.back());
  return (same(a, p) && same(b, q)) || (same(a, q) && same(b, p));
}

Ties tiesOf(const GuidingGraph& graph) {
  Ties ties(graph.runs.size());
  for (const guide::GuideSymmetry& s : graph.symmetries) {
    for (const int run : s.runs) {
      for (const int partner : s.partners) {
        if (run == partner || !isImage(graph, s, run, partner)) {
          continue;
        }
        Tie there{run, {}};
        Tie back{partner, {}};
        for (int i = 0; i < 3; ++i) {
          const Axis image = mapped(s.linear, lattice::axisFromIndex(i));
          there.axes[at(i)] = image;
          back.axes[at(lattice::index(image))] = lattice::axisFromIndex(i);
        }
        ties[at(partner)].push_back(there);
        ties[at(run)].push_back(back);
      }
    }
  }
  return ties;
}

//! The state of stage one and the one move that it knows.
class StageOne {
 public:
  StageOne(const GuidingGraph& graph, base::Rng* rng)
      : graph_(graph), rng_(rng), ties_(tiesOf(graph)) {
    for (const guide::GuideRun& run : graph.runs) {
      axes_.push_back(run.axes.front());
    }
    for (std::size_t r = 0; r < graph.runs.size(); ++r) {
      const std::vector<Axis>& allowed = graph.runs[r].axes;
      assign(static_cast<int>(r), allowed[rng->below(static_cast<std::uint32_t>(allowed.size()))]);
    }
    cost_ = costOf(allJunctions());
  }

  [[nodiscard]] const Orientation& axes() const { return axes_; }

  [[nodiscard]] int cost() const { return cost_; }

  void step(double temperature) {
    const Orientation before = axes_;
    const int run = static_cast<int>(rng_->below(static_cast<std::uint32_t>(axes_.size())));
    if (!turn(run)) {
      return;
    }
    std::vector<int> touched;
    for (std::size_t r = 0; r < axes_.size(); ++r) {
      if (axes_[r] != before[r]) {
        touched.insert(
            touched.end(), graph_.runs[r].junctions.begin(), graph_.runs[r].junctions.end());
      }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    const int after = costOf(touched);
    Orientation turned = axes_;
    axes_ = before;
    const int delta = after - costOf(touched);
    if (base::detExp(-static_cast<double>(delta) / temperature) > rng_->unit()) {
      axes_ = std::move(turned);
      cost_ += delta;
    }
  }

 private:
  //! Gives a run another of its axes.
  bool turn(int run) {
    const std::vector<Axis>& allowed = graph_.runs[at(run)].axes;
    return allowed.size() > 1 &&
           assign(run, allowed[0] == axes_[at(run)] ? allowed[1] : allowed[0]);
  }

  //! Gives a run an axis, and those tied to it theirs; false, and nothing done, where one cannot.
  bool assign(int run, Axis axis) {
    const Orientation before = axes_;
    std::vector<int> queue{run};
    axes_[at(run)] = axis;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Tie& tie : ties_[at(queue[i])]) {
        const Axis wanted = tie.axes[at(lattice::index(axes_[at(queue[i])]))];
        if (axes_[at(tie.run)] == wanted) {
          continue;
        }
        const std::vector<Axis>& theirs = graph_.runs[at(tie.run)].axes;
        const bool seen = std::find(queue.begin(), queue.end(), tie.run) != queue.end();
        if (seen || std::find(theirs.begin(), theirs.end(), wanted) == theirs.end()) {
          axes_ = before;
          return false;
        }
        axes_[at(tie.run)] = wanted;
        queue.push_back(tie.run);
      }
    }
    return true;
  }

  [[nodiscard]] std::vector<int> allJunctions() const {
    std::vector<int> all;
    for (std::size_t j = 0; j < graph_.junctions.size(); ++j) {
      all.push_back(static_cast<int>(j));
    }
    return all;
  }

  [[nodiscard]] int costOf(const std::vector<int>& junctions) const {
    int cost = 0;
    for (const int j : junctions) {
      const guide::Junction& junction = graph_.junctions[at(j)];
      cost += axisDifferences(graph_, axes_, junction, junctionAxis(graph_, axes_, junction));
    }
    return cost;
  }

  const GuidingGraph& graph_;
  base::Rng* rng_;
  Ties ties_;
  Orientation axes_;
  int cost_ = 0;
};

}  // namespace

int axisDifferences(const GuidingGraph& graph,
                    const Orientation& runs,
                    const guide::Junction& junction,
                    Axis axis) {
  int differences = 0;
  for (const guide::Incidence& incidence : junction.incident) {
    const int edges = (incidence.index > 0 ? 1 : 0) +
                      (incidence.index < graph.runs[at(incidence.run)].edgeCount() ? 1 : 0);
    differences += runs[at(incidence.run)] == axis ? 0 : edges;
  }
  return differences;
}

Axis junctionAxis(const GuidingGraph& graph,
                  const Orientation& runs,
                  const guide::Junction& junction) {
  if (junction.joint >= 0) {
    return graph.joints[at(junction.joint)].axis;
  }
  Axis best = Axis::kX;
  for (const Axis axis : {Axis::kY, Axis::kZ}) {
    if (axisDifferences(graph, runs, junction, axis) <
        axisDifferences(graph, runs, junction, best)) {
      best = axis;
    }
  }
  return best;
}

PaperOrientation paperStageOne(const GuidingGraph& graph, base::Rng* rng) {
  StageOne state(graph, rng);
  Orientation best = state.axes();
  int bestCost = state.cost();
  const double rate =
      std::max(kSlowestRate, 1.0 - 10.0 / std::max(1.0, static_cast<double>(graph.nodes.size())));
  for (double t = kStartTemperature; t > kEndTemperature && !best.empty(); t *= rate) {
    state.step(t);
    if (state.cost() < bestCost) {
      bestCost = state.cost();
      best = state.axes();
    }
  }
  PaperOrientation result{best, {}};
  for (const guide::Junction& junction : graph.junctions) {
    result.junctions.push_back(junctionAxis(graph, best, junction));
  }
  return result;
}

}  // namespace liftarm::search
