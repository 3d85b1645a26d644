#include "sketch/arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "base/index.h"
#include "sketch/crossings.h"
#include "sketch/point_index.h"
#include "sketch/snap.h"

namespace liftarm::sketch {

namespace {

using base::at;
using lattice::Vec3;

//! A unit edge between two nodes, before it belongs to a run.
struct UnitEdge {
  int from = -1;
  int to = -1;
  ArrangedEdge content;
  bool taken = false;  //!< belongs to a run already
};

//! Nodes and unit edges of all lines, each once, found again in constant time.
class UnitEdges {
 public:
  explicit UnitEdges(const std::vector<Line>& lines) : index_(kSamePoint) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      int previous = index_.findOrInsert(lines[i].from);
      for (int k = 1; k <= lines[i].length; ++k) {
        const int next = index_.findOrInsert(nodeOfLine(lines[i], k));
        addLine(previous, next, static_cast<int>(i), lines[i]);
        previous = next;
      }
    }
  }

  //! The edge that leaves `to` in the direction from -> to, or -1.
  [[nodiscard]] int straightOn(int from, int to) const {
    const Vec3 beyond = 2.0 * index_.at(to) - index_.at(from);
    const int next = index_.find(beyond);
    if (next < 0) {
      return -1;
    }
    const auto found = edgeOf_.find(keyOf(to, next));
    return found == edgeOf_.end() ? -1 : found->second;
  }

  std::vector<UnitEdge>& edges() { return edges_; }

  [[nodiscard]] const PointIndex& nodes() const { return index_; }

 private:
  static std::uint64_t keyOf(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) |
           static_cast<std::uint64_t>(std::max(a, b));
  }

  void addLine(int from, int to, int lineIndex, const Line& line) {
    const auto [place, isNew] =
        edgeOf_.try_emplace(keyOf(from, to), static_cast<int>(edges_.size()));
    if (isNew) {
      edges_.push_back({from, to, {}, false});
    }
    ArrangedEdge& content = edges_[at(place->second)].content;
    content.lines.push_back(lineIndex);
    content.exact = content.exact || line.exact;
    if (!content.holeAxis.has_value()) {
      content.holeAxis = line.holeAxis;
    }
  }

  PointIndex index_;
  std::vector<UnitEdge> edges_;
  std::unordered_map<std::uint64_t, int> edgeOf_;
};

//! Groups of a joint: as drawn, or the two lines that meet there.
std::vector<ArrangedJoint> placeJoints(const Sketch& sketch, UnitEdges& units) {
  std::vector<ArrangedJoint> joints;
  std::vector<char> isOpen(at(units.nodes().size()), char{0});
  for (const Joint& joint : sketch.joints) {
    const int node = units.nodes().find(joint.at);
    joints.push_back({node, joint.axis, joint.between});
    if (node >= 0 && joint.between.empty()) {
      isOpen[at(node)] = char{1};
    }
  }
  std::vector<std::vector<int>> linesAtNode(isOpen.size());
  for (const UnitEdge& edge : units.edges()) {
    for (const int node : {edge.from, edge.to}) {
      if (isOpen[at(node)] != 0) {
        const std::vector<int>& lines = edge.content.lines;
        linesAtNode[at(node)].insert(linesAtNode[at(node)].end(), lines.begin(), lines.end());
      }
    }
  }
  for (ArrangedJoint& joint : joints) {
    if (joint.lineGroups.empty() && joint.node >= 0) {
      std::vector<int>& lines = linesAtNode[at(joint.node)];
      std::sort(lines.begin(), lines.end());
      lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
      for (const int line : lines) {
        joint.lineGroups.push_back({line});
      }
    }
  }
  return joints;
}

//! Strings unit edges together to runs.
class RunBuilder {
 public:
  RunBuilder(UnitEdges& units, const std::vector<ArrangedJoint>& joints)
      : units_(units), jointsAtNode_(at(units.nodes().size())) {
    for (const ArrangedJoint& joint : joints) {
      GroupOfLine groups;
      for (std::size_t g = 0; g < joint.lineGroups.size(); ++g) {
        for (const int line : joint.lineGroups[g]) {
          groups.emplace_back(line, static_cast<int>(g));
        }
      }
      std::sort(groups.begin(), groups.end());
      if (joint.node >= 0) {
        jointsAtNode_[at(joint.node)].push_back(std::move(groups));
      }
    }
  }

  std::vector<Run> build() {
    std::vector<Run> runs;
    std::vector<UnitEdge>& edges = units_.edges();
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].taken) {
        continue;
      }
      edges[e].taken = true;
      const std::vector<int> before = walk(static_cast<int>(e), edges[e].to, edges[e].from);
      const std::vector<int> after = walk(static_cast<int>(e), edges[e].from, edges[e].to);
      std::vector<int> chain(before.rbegin(), before.rend());
      chain.push_back(static_cast<int>(e));
      chain.insert(chain.end(), after.begin(), after.end());
      runs.push_back(makeRun(chain));
    }
    return runs;
  }

 private:
  //! (line, group) of one joint, sorted.
  using GroupOfLine = std::vector<std::pair<int, int>>;

  //! Takes the edges that go on straight beyond `to`.
  std::vector<int> walk(int edge, int from, int to) {
    std::vector<int> chain;
    std::vector<UnitEdge>& edges = units_.edges();
    while (true) {
      const int next = units_.straightOn(from, to);
      if (next < 0 || edges[at(next)].taken || jointParts(to, edge, next)) {
        return chain;
      }
      edges[at(next)].taken = true;
      chain.push_back(next);
      from = to;
      to = edges[at(next)].from == to ? edges[at(next)].to : edges[at(next)].from;
      edge = next;
    }
  }

  //! A joint between two collinear lines is a hinge: no run may pass through it.
  [[nodiscard]] bool jointParts(int node, int a, int b) const {
    for (const GroupOfLine& groups : jointsAtNode_[at(node)]) {
      const int groupOfA = groupOf(groups, a);
      const int groupOfB = groupOf(groups, b);
      if (groupOfA >= 0 && groupOfB >= 0 && groupOfA != groupOfB) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] int groupOf(const GroupOfLine& groups, int edge) const {
    for (const int line : units_.edges()[at(edge)].content.lines) {
      const auto found = std::lower_bound(groups.begin(), groups.end(), std::pair{line, 0});
      if (found != groups.end() && found->first == line) {
        return found->second;
      }
    }
    return -1;
  }

  //! \param chain Edges in order, in the direction in which the first line among them was drawn.
  Run makeRun(const std::vector<int>& chain) {
    std::vector<UnitEdge>& edges = units_.edges();
    Run run;
    // Where the chain enters its first edge: at the node that the second one does not share.
    int node = edges[at(chain.front())].from;
    if (chain.size() > 1) {
      const UnitEdge& second = edges[at(chain[1])];
      if (node == second.from || node == second.to) {
        node = edges[at(chain.front())].to;
      }
    }
    run.nodes.push_back(node);
    for (const int e : chain) {
      node = edges[at(e)].from == node ? edges[at(e)].to : edges[at(e)].from;
      run.nodes.push_back(node);
      run.edges.push_back(std::move(edges[at(e)].content));
    }
    const Vec3 span = units_.nodes().at(run.nodes.back()) - units_.nodes().at(run.nodes.front());
    const double length = lattice::length(span);
    run.direction = {span.x / length, span.y / length, span.z / length};
    return run;
  }

  UnitEdges& units_;
  std::vector<std::vector<GroupOfLine>> jointsAtNode_;
};

//! Gives all runs that are connected with `first` the number of its piece.
void floodPiece(Arrangement& arrangement, int first, int piece) {
  std::vector<int> open{first};
  arrangement.runs[at(first)].piece = piece;
  while (!open.empty()) {
    const int run = open.back();
    open.pop_back();
    for (const int node : arrangement.runs[at(run)].nodes) {
      for (const auto& [other, ignored] : arrangement.nodes[at(node)].runs) {
        if (arrangement.runs[at(other)].piece < 0) {
          arrangement.runs[at(other)].piece = piece;
          open.push_back(other);
        }
      }
    }
  }
}

//! Numbers the connected parts in the order of their first runs. \return How many there are.
int numberPieces(Arrangement& arrangement) {
  for (Run& run : arrangement.runs) {
    run.piece = -1;
  }
  int pieces = 0;
  for (std::size_t r = 0; r < arrangement.runs.size(); ++r) {
    if (arrangement.runs[r].piece < 0) {
      floodPiece(arrangement, static_cast<int>(r), pieces++);
    }
  }
  return pieces;
}

}  // namespace

Arrangement arrange(const Sketch& sketch) {
  UnitEdges units(sketch.lines);
  Arrangement arrangement;
  arrangement.joints = placeJoints(sketch, units);
  arrangement.runs = RunBuilder(units, arrangement.joints).build();
  arrangement.nodes.resize(at(units.nodes().size()));
  for (int n = 0; n < units.nodes().size(); ++n) {
    arrangement.nodes[at(n)].position = units.nodes().at(n);
  }
  for (std::size_t r = 0; r < arrangement.runs.size(); ++r) {
    const std::vector<int>& nodes = arrangement.runs[r].nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      arrangement.nodes[at(nodes[i])].runs.emplace_back(static_cast<int>(r), static_cast<int>(i));
    }
  }
  arrangement.pieces = numberPieces(arrangement);
  arrangement.offNodeCrossings = findOffNodeCrossings(arrangement);
  return arrangement;
}

}  // namespace liftarm::sketch
