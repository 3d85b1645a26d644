#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>

#include "analysis/axle_lines.h"
#include "analysis/coverage.h"
#include "analysis/node_index.h"
#include "analysis/union_find.h"
#include "model/number_text.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

//! A connection at just the reach is within it, wherever rounding leaves it.
constexpr double kSlack = NodeIndex::kSameNode;

//! Finds out whether uncovered edges are bridged.
class Bridges {
 public:
  Bridges(const Scene& scene, const std::vector<EdgeCover>& edges)
      : scene_(scene), edges_(edges), nodes_(edges), axles_(scene) {}

  //! \param first, last Indices of the first and the last of a line's uncovered edges in a row.
  [[nodiscard]] bool bridged(int first, int last) const {
    const int length = last - first + 1;
    if (length <= static_cast<int>(kBridgeReach) && bridgedByMechanism(first, last)) {
      return true;
    }
    // A hole axis is fixed for beams: an axle has none.
    const int line = edge(first).line;
    if (scene_.sketch->lines[static_cast<std::size_t>(line)].holeAxis.has_value()) {
      return false;
    }
    const std::vector<int> axles = axles_.along(edge(first).from, edge(last).to);
    return std::any_of(
        axles.begin(), axles.end(), [&](int axle) { return bridgedByAxle(axle, first, last); });
  }

 private:
  [[nodiscard]] const EdgeCover& edge(int i) const { return edges_[static_cast<std::size_t>(i)]; }

  [[nodiscard]] bool bridgedByMechanism(int first, int last) const {
    const std::set<int> onOneSide = beamsFrom(nodes_.from(first), first, last);
    const std::set<int> onTheOther = beamsFrom(nodes_.to(last), first, last);
    UnionFind groups = groupsNear(first, last);
    return std::any_of(onOneSide.begin(), onOneSide.end(), [&](int a) {
      return std::any_of(onTheOther.begin(), onTheOther.end(), [&](int b) {
        return groups.find(a) == groups.find(b);
      });
    });
  }

  //! Whether an axle along these edges holds a beam, and wherever other lines meet them one of
  //! theirs is joined to it nearby.
  [[nodiscard]] bool bridgedByAxle(int axle, int first, int last) const {
    if (axles_.heldBy(axle).empty()) {
      return false;
    }
    UnionFind groups = groupsNear(first, last);
    std::set<int> nodes{nodes_.from(first)};
    for (int e = first; e <= last; ++e) {
      nodes.insert(nodes_.to(e));
    }
    return std::all_of(nodes.begin(), nodes.end(), [&](int node) {
      const std::vector<int>& meeting = nodes_.edgesAt(node);
      const bool alone = std::all_of(meeting.begin(), meeting.end(), [&](int e) {
        const std::vector<int> along = axles_.along(edge(e).from, edge(e).to);
        return (e >= first && e <= last) ||
               std::find(along.begin(), along.end(), axle) != along.end();
      });
      const std::set<int> beams = beamsFrom(node, first, last);
      return alone || std::any_of(beams.begin(), beams.end(), [&](int beam) {
               return groups.find(beam) == groups.find(axle);
             });
    });
  }

  //! What good connections near these edges join, other than through the length of a beam.
  [[nodiscard]] UnionFind groupsNear(int first, int last) const {
    std::set<int> mechanism;
    for (const model::Connection& c : scene_.connections) {
      if (distance(c.at, edge(first).from, edge(last).to) <= kBridgeReach + kSlack) {
        mechanism.insert({c.male, c.female});
      }
    }
    UnionFind groups(scene_.parts.size());
    for (const model::Connection& c : scene_.connections) {
      if (isGood(c.fit) && c.fit != model::Fit::kSlide &&
          (belongs(mechanism, c.male) || belongs(mechanism, c.female))) {
        groups.join(c.male, c.female);
      }
    }
    return groups;
  }

  //! The beams that one meets first on every way that leads away from a node, not through the edges
  //! first..last, within kBridgeReach edges.
  [[nodiscard]] std::set<int> beamsFrom(int node, int first, int last) const {
    std::set<int> beams;
    std::set<int> seen;
    std::vector<int> front{node};
    for (int step = 0; step < static_cast<int>(kBridgeReach) && !front.empty(); ++step) {
      std::vector<int> next;
      for (const int at : front) {
        for (const int e : nodes_.edgesAt(at)) {
          if ((e >= first && e <= last) || !seen.insert(e).second) {
            continue;
          }
          if (edge(e).covers.empty()) {
            next.push_back(nodes_.from(e) == at ? nodes_.to(e) : nodes_.from(e));
          }
          for (const Cover& cover : edge(e).covers) {
            beams.insert(cover.part);
          }
        }
      }
      front = next;
    }
    return beams;
  }

  //! Beams reach too far to count as near.
  [[nodiscard]] bool belongs(const std::set<int>& mechanism, int part) const {
    return mechanism.count(part) > 0 &&
           scene_.parts[static_cast<std::size_t>(part)].part->partClass != parts::PartClass::kBeam;
  }

  static double distance(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 d = b - a;
    const double t = std::clamp(lattice::dot(p - a, d) / lattice::dot(d, d), 0.0, 1.0);
    return lattice::length(p - a - t * d);
  }

  const Scene& scene_;
  const std::vector<EdgeCover>& edges_;
  NodeIndex nodes_;
  AxleLines axles_;
};

//! Where the stack of a node has something in it: layers of beams, and of all holes.
int gapsInStack(const std::set<int>& beamLayers, const std::set<int>& filled) {
  std::set<int> withHoles;
  std::set_intersection(beamLayers.begin(),
                        beamLayers.end(),
                        filled.begin(),
                        filled.end(),
                        std::inserter(withHoles, withHoles.end()));
  if (withHoles.empty()) {
    return 0;
  }
  int gaps = 0;
  for (int layer = *withHoles.begin(); layer <= *withHoles.rbegin(); ++layer) {
    gaps += filled.count(layer) == 0 ? 1 : 0;
  }
  return gaps;
}

//! The layers of a node's axis in which some part has a hole on that axis.
std::set<int> holesAlong(const Scene& scene, Vec3 node, Vec3 axis) {
  std::set<int> layers;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const Box& box = scene.parts[i].box;
    Box reach;
    for (int k = 0; k < 3; ++k) {
      reach.min[k] = node[k] - kMaxLayer * std::abs(axis[k]) - 0.1;
      reach.max[k] = node[k] + kMaxLayer * std::abs(axis[k]) + 0.1;
    }
    if (scene.parts[i].part == nullptr || !meet(box, reach, 0.0)) {
      continue;
    }
    const lattice::Pose& pose = scene.model->parts[i].pose;
    for (const parts::Feature& feature : scene.parts[i].part->features) {
      if (parts::isMale(feature.kind) ||
          std::abs(lattice::dot(pose.rotation * feature.axis, axis)) < model::kCoaxialCosine) {
        continue;
      }
      for (const Vec3 slot : feature.slots) {
        const Vec3 offset = pose.apply(slot) - node;
        const double along = lattice::dot(offset, axis);
        if (lattice::length(offset - along * axis) <= model::kCoaxialDistance) {
          layers.insert(static_cast<int>(std::floor(along + 0.5)));
        }
      }
    }
  }
  return layers;
}

}  // namespace

ItemResult checkCoverage(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  ItemResult result;
  if (!scene.sketchError.empty()) {
    result.problems.push_back(
        {"sketch", "the model's sketch cannot be read: " + scene.sketchError, std::nullopt, {}});
  }
  if (!scene.sketch.has_value()) {
    result.detail = "no sketch in the file: nothing to cover";
    return result;
  }
  const Bridges bridges(scene, coverage);
  int bridged = 0;
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    if (!coverage[i].covers.empty()) {
      continue;
    }
    std::size_t last = i;
    while (last + 1 < coverage.size() && coverage[last + 1].line == coverage[i].line &&
           coverage[last + 1].covers.empty()) {
      ++last;
    }
    const int length = static_cast<int>(last - i) + 1;
    if (bridges.bridged(static_cast<int>(i), static_cast<int>(last))) {
      bridged += length;
    } else {
      const Vec3 middle = 0.5 * (coverage[i].from + coverage[last].to);
      result.problems.push_back(
          {"uncovered",
           "lines[" + std::to_string(coverage[i].line) + "] is neither covered nor bridged from " +
               pointText(coverage[i].from) + " to " + pointText(coverage[last].to),
           middle,
           {}});
    }
    i = last;
  }
  result.detail = "modules of line: " + std::to_string(coverage.size()) +
                  ", bridged by connectors: " + std::to_string(bridged);
  return result;
}

int countGaps(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  const NodeIndex nodes(coverage);
  std::set<int> said;  // beams of which the model says where they belong
  for (const EdgeCover& edge : coverage) {
    for (const Cover& cover : edge.covers) {
      if (cover.said) {
        said.insert(cover.part);
      }
    }
  }
  int gaps = 0;
  for (int node = 0; node < static_cast<int>(nodes.points().size()); ++node) {
    std::map<lattice::Cell, std::set<int>> stacks;  // by hole axis, rounded and signed
    for (const int e : nodes.edgesAt(node)) {
      for (const Cover& cover : coverage[static_cast<std::size_t>(e)].covers) {
        if (!cover.said && said.count(cover.part) > 0) {
          continue;  // another line's beam, beside an edge that is bridged
        }
        Vec3 axis = cover.holeAxis;
        const double sign = axis.x + 2 * axis.y + 4 * axis.z < 0 ? -1.0 : 1.0;
        axis = (sign * 1000.0) * axis;
        stacks[{static_cast<int>(std::lround(axis.x)),
                static_cast<int>(std::lround(axis.y)),
                static_cast<int>(std::lround(axis.z))}]
            .insert(static_cast<int>(std::floor(sign * cover.layer + 0.5)));
      }
    }
    const Vec3 at = nodes.points()[static_cast<std::size_t>(node)];
    for (const auto& [axis, layers] : stacks) {
      if (layers.size() > 1) {
        gaps += gapsInStack(layers, holesAlong(scene, at, 0.001 * lattice::toVec3(axis)));
      }
    }
  }
  return gaps;
}

}  // namespace liftarm::analysis
