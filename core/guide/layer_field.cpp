#include "guide/layer_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/index.h"
#include "guide/beam_bound.h"

namespace liftarm::guide {

namespace {

using base::at;
using lattice::Axis;

constexpr int kWidestDomain = 3 * kLongestBeam;  // between walls, modules
constexpr double kWallOnJunction = 1.5;          // a change there needs a third layer, in beams
constexpr double kTieNoise = 0.01;

//! Whole beams of one part, in edges.
constexpr std::array<int, 8> kBeamEdges{1, 2, 4, 6, 8, 10, 12, 14};

//! A run of a coplanar component, as its direction sees it; whole modules from the component's
//! first node.
struct Span {
  int low = 0;
  int high = 0;
  std::vector<int> junctions;
};

int directionOf(const GuideRun& run) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(run.direction[k]) > 0.5) {
      return k;
    }
  }
  return 0;
}

//! Runs that one wall can serve: parallel to principal axes, with one hole axis, joined by
//! junctions.
std::vector<std::vector<int>> findGroups(const GuidingGraph& graph,
                                         const Orientation& orientation) {
  std::vector<int> leader(graph.runs.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](int r) {
    while (leader[at(r)] != r) {
      r = leader[at(r)] = leader[at(leader[at(r)])];
    }
    return r;
  };
  for (const Junction& junction : graph.junctions) {
    for (const Incidence& a : junction.incident) {
      for (const Incidence& b : junction.incident) {
        const bool both = graph.runs[at(a.run)].principal && graph.runs[at(b.run)].principal;
        if (both && orientation[at(a.run)] == orientation[at(b.run)]) {
          leader[at(std::max(find(a.run), find(b.run)))] = std::min(find(a.run), find(b.run));
        }
      }
    }
  }
  std::map<int, std::vector<int>> byLeader;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    if (graph.runs[r].principal) {
      byLeader[find(static_cast<int>(r))].push_back(static_cast<int>(r));
    }
  }
  std::vector<std::vector<int>> groups;
  for (auto& [key, runs] : byLeader) {
    if (runs.size() > 1) {
      groups.push_back(std::move(runs));
    }
  }
  return groups;
}

class Walls {
 public:
  Walls(const GuidingGraph& graph, const std::vector<int>& runs) : graph_(&graph), runs_(&runs) {
    origin_ = graph.nodes[at(graph.runs[at(runs.front())].nodes.front())];
  }

  [[nodiscard]] int coordinate(int node, int direction) const {
    return static_cast<int>(std::lround(graph_->nodes[at(node)][direction] - origin_[direction]));
  }

  //! Places of the walls that cross lines along `direction`, ascending.
  [[nodiscard]] std::vector<int> place(int direction, base::Rng* rng) const {
    std::vector<Span> spans;
    int low = 0;
    int high = 0;
    for (const int r : *runs_) {
      const GuideRun& run = graph_->runs[at(r)];
      if (directionOf(run) == direction) {
        spans.push_back(spanOf(run, direction));
        low = std::min(low, spans.back().low);
        high = std::max(high, spans.back().high);
      }
    }
    return spans.empty() ? std::vector<int>{} : cheapest(spans, low, high, rng);
  }

 private:
  [[nodiscard]] Span spanOf(const GuideRun& run, int direction) const {
    const int a = coordinate(run.nodes.front(), direction);
    const int b = coordinate(run.nodes.back(), direction);
    Span span{std::min(a, b), std::max(a, b), {}};
    for (const int index : run.junctionIndices) {
      span.junctions.push_back(coordinate(run.nodes[at(index)], direction));
    }
    std::sort(span.junctions.begin(), span.junctions.end());
    return span;
  }

  //! Whether one beam reaches from wall to wall: beams come in few lengths, so it may go one module
  //! past a wall, where it lies on its neighbour, unless a junction is there; past the line's own
  //! end it sticks out.
  static bool oneBeamFits(const Span& span, int from, int to) {
    const auto room = [&](int end, int step) {
      const int past = end + step;
      return !std::binary_search(span.junctions.begin(), span.junctions.end(), past) ? 1 : 0;
    };
    const int length = to - from;
    const int most = length + room(from, -1) + room(to, 1);
    return std::any_of(kBeamEdges.begin(), kBeamEdges.end(), [&](int edges) {
      return edges >= length && edges <= most;
    });
  }

  //! Fewest beams between two walls, about.
  static double beamsBetween(const Span& span, int from, int to) {
    const int low = std::max(from, span.low);
    const int high = std::min(to, span.high);
    if (high <= low) {
      return 0.0;
    }
    if (oneBeamFits(span, low, high)) {
      return 1.0;
    }
    // Every junction between the walls wants the same layer: from one long beam to the next a short
    // one leads over, on the other layer.
    const int fewest = std::max(2, (high - low + kLongestBeam - 1) / kLongestBeam);
    return static_cast<double>(2 * fewest - 1);
  }

  static double wallCost(const std::vector<Span>& spans, int place) {
    double cost = 0.0;
    for (const Span& span : spans) {
      const bool onJunction =
          place > span.low && place < span.high &&
          std::binary_search(span.junctions.begin(), span.junctions.end(), place);
      cost += onJunction ? kWallOnJunction : 0.0;
    }
    return cost;
  }

  static std::vector<int> cheapest(const std::vector<Span>& spans,
                                   int low,
                                   int high,
                                   base::Rng* rng) {
    const auto places = at(high - low + 1);
    std::vector<double> value(places, 0.0);
    std::vector<int> before(places, -1);
    for (std::size_t i = 1; i < places; ++i) {
      const int to = low + static_cast<int>(i);
      double best = 1e300;
      const std::size_t first = i > at(kWidestDomain) ? i - at(kWidestDomain) : 0;
      for (std::size_t j = first; j < i; ++j) {
        double cost = value[j];
        for (const Span& span : spans) {
          cost += beamsBetween(span, low + static_cast<int>(j), to);
        }
        if (cost < best) {
          best = cost;
          before[i] = static_cast<int>(j);
        }
      }
      value[i] = best + (i + 1 < places ? wallCost(spans, to) + kTieNoise * rng->unit() : 0.0);
    }
    std::vector<int> walls;
    for (int i = before.back(); i > 0; i = before[at(i)]) {
      walls.push_back(low + i);
    }
    std::reverse(walls.begin(), walls.end());
    return walls;
  }

  const GuidingGraph* graph_;
  const std::vector<int>* runs_;
  lattice::Vec3 origin_;
};

int wallsBelow(const std::vector<int>& walls, int place) {
  return static_cast<int>(std::lower_bound(walls.begin(), walls.end(), place) - walls.begin());
}

}  // namespace

LayerField makeLayerField(const GuidingGraph& graph,
                          const Orientation& orientation,
                          base::Rng* rng) {
  LayerField field(graph.runs.size());
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    field[r].assign(graph.runs[r].junctions.size(), kNoLayer);
  }
  for (const std::vector<int>& runs : findGroups(graph, orientation)) {
    const Walls walls(graph, runs);
    const int k = lattice::index(orientation[at(runs.front())]);
    const std::array<int, 2> directions{(k + 1) % 3, (k + 2) % 3};
    const std::array<std::vector<int>, 2> places{walls.place(directions[0], rng),
                                                 walls.place(directions[1], rng)};
    for (const int r : runs) {
      const GuideRun& run = graph.runs[at(r)];
      const int parity = directionOf(run) == directions[0] ? 0 : 1;
      for (std::size_t j = 0; j < run.junctions.size(); ++j) {
        const int node = run.nodes[at(run.junctionIndices[j])];
        const int crossed = wallsBelow(places[0], walls.coordinate(node, directions[0])) +
                            wallsBelow(places[1], walls.coordinate(node, directions[1]));
        field[at(r)][j] = (crossed + parity) % 2;
      }
    }
  }
  return field;
}

}  // namespace liftarm::guide
