#include "guide/guiding_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "guide/hole_shift.h"
#include "guide/joint_bodies.h"
#include "sketch/moving_layers.h"
#include "sketch/point_symmetry.h"

namespace liftarm::guide {

namespace {

using lattice::Axis;
using lattice::Vec3;

constexpr double kFlat = 1e-6;
//! Two beams, each up to kMaxLayer off its line and one past its end, touch at most this far apart.
constexpr double kNearRuns = 2.0 * kMaxLayer + 3.5;
//! Mechanisms reach this far from their junction; two of them touch at most twice that apart.
constexpr double kNearJunctions = 8.0;
constexpr double kBucket = 8.0;

//! At least one: a line that snapping left a little off its plane has the axis it leans least to.
std::vector<Axis> perpendicularAxes(Vec3 direction) {
  std::vector<Axis> axes;
  int flattest = 0;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(direction[i]) < kFlat) {
      axes.push_back(lattice::axisFromIndex(i));
    }
    flattest = std::abs(direction[i]) < std::abs(direction[flattest]) ? i : flattest;
  }
  if (axes.empty()) {
    axes.push_back(lattice::axisFromIndex(flattest));
  }
  return axes;
}

//! The piece of an arranged run between two node indices, as a run of its own.
struct Segment {
  int run = -1;
  int first = 0;
  int last = 0;
};

bool sameRules(const sketch::ArrangedEdge& a, const sketch::ArrangedEdge& b) {
  return a.exact == b.exact && a.holeAxis == b.holeAxis;
}

int groupOfEdge(const sketch::ArrangedJoint& joint, const sketch::ArrangedEdge& edge) {
  for (std::size_t g = 0; g < joint.lineGroups.size(); ++g) {
    for (const int line : edge.lines) {
      const std::vector<int>& group = joint.lineGroups[g];
      if (std::find(group.begin(), group.end(), line) != group.end()) {
        return static_cast<int>(g);
      }
    }
  }
  return -1;
}

bool jointSplits(const sketch::Arrangement& arrangement,
                 const sketch::Run& run,
                 std::size_t index) {
  for (const sketch::ArrangedJoint& joint : arrangement.joints) {
    if (joint.node == run.nodes[index] &&
        groupOfEdge(joint, run.edges[index - 1]) != groupOfEdge(joint, run.edges[index])) {
      return true;
    }
  }
  return false;
}

std::vector<Segment> splitRuns(const sketch::Arrangement& arrangement) {
  std::vector<Segment> segments;
  for (std::size_t r = 0; r < arrangement.runs.size(); ++r) {
    const sketch::Run& run = arrangement.runs[r];
    int first = 0;
    for (std::size_t i = 1; i + 1 < run.nodes.size(); ++i) {
      if (!sameRules(run.edges[i - 1], run.edges[i]) || jointSplits(arrangement, run, i)) {
        segments.push_back({static_cast<int>(r), first, static_cast<int>(i)});
        first = static_cast<int>(i);
      }
    }
    segments.push_back({static_cast<int>(r), first, static_cast<int>(run.nodes.size()) - 1});
  }
  return segments;
}

std::vector<Axis> allowedAxes(const sketch::Run& run, const Segment& segment) {
  std::vector<Axis> axes = perpendicularAxes(run.direction);
  const std::optional<Axis> fixed = run.edges[static_cast<std::size_t>(segment.first)].holeAxis;
  if (fixed && std::find(axes.begin(), axes.end(), *fixed) != axes.end()) {
    axes = {*fixed};
  }
  return axes;
}

void addRuns(const sketch::Sketch& sketch,
             const sketch::Arrangement& arrangement,
             const std::vector<Segment>& segments,
             GuidingGraph* graph) {
  const std::vector<sketch::LayerBits> layers = sketch::movingLayers(sketch, kMaxLayer);
  for (const Segment& segment : segments) {
    const sketch::Run& source = arrangement.runs[static_cast<std::size_t>(segment.run)];
    GuideRun run;
    run.direction = source.direction;
    run.nodes.assign(source.nodes.begin() + segment.first, source.nodes.begin() + segment.last + 1);
    run.axes = allowedAxes(source, segment);
    run.principal = perpendicularAxes(source.direction).size() == 2;
    run.exact = source.edges[static_cast<std::size_t>(segment.first)].exact;
    for (int e = segment.first; e < segment.last && !layers.empty(); ++e) {
      for (const int line : source.edges[static_cast<std::size_t>(e)].lines) {
        run.layers &= layers[static_cast<std::size_t>(line)];
      }
    }
    run.layers = run.exact ? 1U << static_cast<unsigned>(kMaxLayer) : run.layers;
    run.piece = source.piece;
    graph->edges += run.edgeCount();
    run.holeShift = holeShiftOf(graph->nodes, run.nodes);
    graph->runs.push_back(std::move(run));
  }
}

//! Joints about one line are one: their bodies share its pin.
void addJoint(GuideJoint joint, GuidingGraph* graph) {
  const auto same =
      std::find_if(graph->joints.begin(), graph->joints.end(), [&](const GuideJoint& other) {
        return other.node == joint.node && other.axis == joint.axis;
      });
  if (same == graph->joints.end()) {
    graph->joints.push_back(std::move(joint));
  } else {
    partBodies(same->runGroups, joint.runGroups);
  }
}

//! Restricts the runs at a joint to its axis where they can have it (paper 5.1, constraint iii).
void addJoints(const sketch::Arrangement& arrangement,
               const std::vector<Segment>& segments,
               GuidingGraph* graph) {
  for (const sketch::ArrangedJoint& joint : arrangement.joints) {
    GuideJoint guideJoint;
    guideJoint.node = joint.node;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(joint.axis[i]) > 0.9) {
        guideJoint.axis = lattice::axisFromIndex(i);
      }
    }
    guideJoint.runGroups.resize(joint.lineGroups.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
      GuideRun& run = graph->runs[s];
      const auto at = std::find(run.nodes.begin(), run.nodes.end(), joint.node);
      if (at == run.nodes.end()) {
        continue;
      }
      if (std::find(run.axes.begin(), run.axes.end(), guideJoint.axis) != run.axes.end()) {
        run.axes = {guideJoint.axis};
      }
      const sketch::Run& source = arrangement.runs[static_cast<std::size_t>(segments[s].run)];
      const int index = segments[s].first + static_cast<int>(at - run.nodes.begin());
      const int edge = std::min(index, segments[s].last - 1);
      const int group = groupOfEdge(joint, source.edges[static_cast<std::size_t>(edge)]);
      if (group >= 0) {
        guideJoint.runGroups[static_cast<std::size_t>(group)].push_back(static_cast<int>(s));
      }
    }
    addJoint(std::move(guideJoint), graph);
  }
}

std::vector<int> runsOfLines(const sketch::Arrangement& arrangement,
                             const std::vector<Segment>& segments,
                             const std::vector<int>& lines) {
  std::vector<int> runs;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const sketch::Run& source = arrangement.runs[static_cast<std::size_t>(segments[s].run)];
    bool found = false;
    for (int e = segments[s].first; e < segments[s].last && !found; ++e) {
      for (const int line : source.edges[static_cast<std::size_t>(e)].lines) {
        found = found || std::find(lines.begin(), lines.end(), line) != lines.end();
      }
    }
    if (found) {
      runs.push_back(static_cast<int>(s));
    }
  }
  return runs;
}

//! Of a reflection or a rotation.
GuideSymmetry pointMapOf(const sketch::Symmetry& symmetry) {
  const sketch::PointIsometry isometry = sketch::isometryOf(symmetry);
  GuideSymmetry map;
  map.linear = isometry.linear;
  map.shift = isometry.apply({});
  return map;
}

void addSymmetries(const sketch::Sketch& sketch,
                   const sketch::Arrangement& arrangement,
                   const std::vector<Segment>& segments,
                   GuidingGraph* graph) {
  for (const sketch::Symmetry& symmetry : sketch.symmetries) {
    if (symmetry.kind != sketch::Symmetry::Kind::kTranslation) {
      GuideSymmetry map = pointMapOf(symmetry);
      std::vector<int> lines = symmetry.lines;
      for (std::size_t l = 0; symmetry.lines.empty() && l < sketch.lines.size(); ++l) {
        lines.push_back(static_cast<int>(l));
      }
      map.runs = runsOfLines(arrangement, segments, lines);
      map.partners = map.runs;
      graph->symmetries.push_back(std::move(map));
      continue;
    }
    for (const auto& [line, image] : symmetry.pairs) {
      graph->symmetries.push_back({{},
                                   -symmetry.vector,
                                   runsOfLines(arrangement, segments, {line}),
                                   runsOfLines(arrangement, segments, {image})});
    }
  }
}

bool haveCommonAxis(const GuidingGraph& graph, const Junction& junction) {
  for (int i = 0; i < 3; ++i) {
    const bool common = std::all_of(
        junction.incident.begin(), junction.incident.end(), [&](const Incidence& incidence) {
          const std::vector<Axis>& axes = graph.runs[static_cast<std::size_t>(incidence.run)].axes;
          return std::find(axes.begin(), axes.end(), lattice::axisFromIndex(i)) != axes.end();
        });
    if (common) {
      return true;
    }
  }
  return false;
}

bool allEnd(const GuidingGraph& graph, const Junction& junction) {
  return std::all_of(
      junction.incident.begin(), junction.incident.end(), [&](const Incidence& incidence) {
        const GuideRun& run = graph.runs[static_cast<std::size_t>(incidence.run)];
        return incidence.index == 0 || incidence.index == run.edgeCount();
      });
}

void addJunctions(GuidingGraph* graph, Bridging bridging) {
  std::vector<std::vector<Incidence>> incidences(graph->nodes.size());
  graph->degrees.assign(graph->nodes.size(), 0);
  for (std::size_t r = 0; r < graph->runs.size(); ++r) {
    const GuideRun& run = graph->runs[r];
    for (std::size_t i = 0; i < run.nodes.size(); ++i) {
      const auto node = static_cast<std::size_t>(run.nodes[i]);
      incidences[node].push_back({static_cast<int>(r), static_cast<int>(i)});
      graph->degrees[node] += (i > 0 ? 1 : 0) + (i + 1 < run.nodes.size() ? 1 : 0);
    }
  }
  for (std::size_t node = 0; node < incidences.size(); ++node) {
    if (incidences[node].size() < 2) {
      continue;
    }
    Junction junction;
    junction.node = static_cast<int>(node);
    junction.incident = incidences[node];
    for (std::size_t j = 0; j < graph->joints.size(); ++j) {
      if (graph->joints[j].node == junction.node) {
        junction.joint = static_cast<int>(j);
      }
    }
    const bool anyway = bridging == Bridging::kAtEnds && allEnd(*graph, junction);
    junction.bridgeable = junction.joint < 0 && (anyway || !haveCommonAxis(*graph, junction));
    const int id = static_cast<int>(graph->junctions.size());
    for (const Incidence& incidence : junction.incident) {
      graph->runs[static_cast<std::size_t>(incidence.run)].junctions.push_back(id);
      graph->runs[static_cast<std::size_t>(incidence.run)].junctionIndices.push_back(
          incidence.index);
    }
    graph->junctions.push_back(std::move(junction));
  }
  for (GuideRun& run : graph->runs) {
    std::vector<std::pair<int, int>> order;
    for (std::size_t i = 0; i < run.junctions.size(); ++i) {
      order.emplace_back(run.junctionIndices[i], run.junctions[i]);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
      run.junctionIndices[i] = order[i].first;
      run.junctions[i] = order[i].second;
    }
  }
}

using BucketMap = std::map<std::array<int, 3>, std::vector<int>>;

std::array<int, 3> bucketOf(Vec3 p) {
  return {static_cast<int>(std::floor(p.x / kBucket)),
          static_cast<int>(std::floor(p.y / kBucket)),
          static_cast<int>(std::floor(p.z / kBucket))};
}

template <typename Visit>
void forNeighbours(const BucketMap& buckets, Vec3 p, Visit visit) {
  const std::array<int, 3> home = bucketOf(p);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const auto found = buckets.find({home[0] + dx, home[1] + dy, home[2] + dz});
        if (found != buckets.end()) {
          for (const int id : found->second) {
            visit(id);
          }
        }
      }
    }
  }
}

bool closer(Vec3 a, Vec3 b, double distance) {
  const Vec3 d = a - b;
  return std::abs(d.x) <= distance && std::abs(d.y) <= distance && std::abs(d.z) <= distance;
}

//! Fills the lists of what is near what. Bucket lists hold (run, node) pairs as node-of-run
//! indices.
void addNeighbours(GuidingGraph* graph) {
  BucketMap nodeBuckets;
  std::vector<std::pair<int, Vec3>> runNodes;
  for (std::size_t r = 0; r < graph->runs.size(); ++r) {
    for (const int node : graph->runs[r].nodes) {
      const Vec3 p = graph->nodes[static_cast<std::size_t>(node)];
      nodeBuckets[bucketOf(p)].push_back(static_cast<int>(runNodes.size()));
      runNodes.emplace_back(static_cast<int>(r), p);
    }
  }
  std::vector<std::set<int>> nearRuns(graph->runs.size());
  for (const auto& [run, p] : runNodes) {
    forNeighbours(nodeBuckets, p, [&, run = run, p = p](int other) {
      const auto& [otherRun, q] = runNodes[static_cast<std::size_t>(other)];
      if (otherRun != run && closer(p, q, kNearRuns)) {
        nearRuns[static_cast<std::size_t>(run)].insert(otherRun);
      }
    });
  }
  for (std::size_t r = 0; r < graph->runs.size(); ++r) {
    graph->runs[r].near.assign(nearRuns[r].begin(), nearRuns[r].end());
  }
  BucketMap junctionBuckets;
  for (std::size_t j = 0; j < graph->junctions.size(); ++j) {
    const int node = graph->junctions[j].node;
    junctionBuckets[bucketOf(graph->nodes[static_cast<std::size_t>(node)])].push_back(
        static_cast<int>(j));
  }
  for (std::size_t j = 0; j < graph->junctions.size(); ++j) {
    Junction& junction = graph->junctions[j];
    const Vec3 p = graph->nodes[static_cast<std::size_t>(junction.node)];
    std::set<int> runs;
    forNeighbours(nodeBuckets, p, [&](int other) {
      const auto& [run, q] = runNodes[static_cast<std::size_t>(other)];
      if (closer(p, q, kNearRuns)) {
        runs.insert(run);
      }
    });
    junction.nearRuns.assign(runs.begin(), runs.end());
    forNeighbours(junctionBuckets, p, [&](int other) {
      const int node = graph->junctions[static_cast<std::size_t>(other)].node;
      const Vec3 q = graph->nodes[static_cast<std::size_t>(node)];
      if (other != static_cast<int>(j) && closer(p, q, kNearJunctions)) {
        junction.nearJunctions.push_back(other);
      }
    });
    std::sort(junction.nearJunctions.begin(), junction.nearJunctions.end());
  }
}

}  // namespace

GuidingGraph buildGuidingGraph(const sketch::Sketch& sketch, Bridging bridging) {
  const sketch::Arrangement arrangement = sketch::arrange(sketch);
  GuidingGraph graph;
  graph.lines = static_cast<int>(sketch.lines.size());
  graph.pieces = arrangement.pieces;
  graph.keepOut = sketch.keepOut;
  graph.ground = sketch.ground;
  for (const sketch::ArrangedNode& node : arrangement.nodes) {
    graph.nodes.push_back(node.position);
  }
  const std::vector<Segment> segments = splitRuns(arrangement);
  addRuns(sketch, arrangement, segments, &graph);
  addJoints(arrangement, segments, &graph);
  addSymmetries(sketch, arrangement, segments, &graph);
  addJunctions(&graph, bridging);
  addNeighbours(&graph);
  return graph;
}

}  // namespace liftarm::guide
