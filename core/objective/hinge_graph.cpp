#include "objective/hinge_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "base/index.h"

namespace liftarm::objective {

namespace {

using base::at;
using lattice::Vec3;

// Coordinates are modules from the middle of the lines, rounded to 1e-9 at worst.
constexpr double kZero = 1e-7;

}  // namespace

void HingeGraph::clear() {
  parents_.clear();
  counts_.clear();
  off_.clear();
  hinges_.clear();
  lines_.clear();
  freedoms_ = 0;
}

int HingeGraph::addBody(bool counts) {
  parents_.push_back(static_cast<std::int32_t>(parents_.size()));
  counts_.push_back(counts ? 1 : 0);
  off_.push_back(0);
  return parents_.back();
}

int HingeGraph::rootOf(int body) const {
  while (parents_[at(body)] != body) {
    body = parents_[at(body)];
  }
  return body;
}

void HingeGraph::merge(int a, int b) {
  const int rootA = rootOf(a);
  const int rootB = rootOf(b);
  if (rootA == rootB) {
    return;
  }
  const int root = std::min(rootA, rootB);
  const int other = std::max(rootA, rootB);
  parents_[at(other)] = root;
  counts_[at(root)] = std::max(counts_[at(root)], counts_[at(other)]);
}

void HingeGraph::addHinge(int line, int a, int b) {
  hinges_.push_back({line, {a, b}});
}

//! Every hinge once, with the bodies that its members are part of now; those that share a body and
//! a line are one hinge.
void HingeGraph::gather() {
  std::vector<std::tuple<int, int, int>> seats;  // body, line, hinge
  for (std::size_t h = 0; h < hinges_.size(); ++h) {
    for (int& body : hinges_[h].bodies) {
      body = rootOf(body);
      if (off_[at(body)] == 0) {
        seats.emplace_back(body, hinges_[h].line, static_cast<int>(h));
      }
    }
  }
  std::sort(seats.begin(), seats.end());
  std::vector<int> same(hinges_.size());
  for (std::size_t h = 0; h < same.size(); ++h) {
    same[h] = static_cast<int>(h);
  }
  const auto find = [&](int h) {
    while (same[at(h)] != h) {
      same[at(h)] = same[at(same[at(h)])];
      h = same[at(h)];
    }
    return h;
  };
  for (std::size_t i = 1; i < seats.size(); ++i) {
    const auto& [body, line, hinge] = seats[i];
    const auto& [bodyBefore, lineBefore, hingeBefore] = seats[i - 1];
    if (body == bodyBefore && line == lineBefore) {
      same[at(find(hinge))] = find(hingeBefore);
    }
  }
  std::vector<Hinge> gathered;
  std::vector<int> place(hinges_.size(), -1);
  for (std::size_t i = 0; i < seats.size(); ++i) {
    const auto& [body, line, hinge] = seats[i];
    const int root = find(hinge);
    if (place[at(root)] < 0) {
      place[at(root)] = static_cast<int>(gathered.size());
      gathered.push_back({line, {}});
    }
    std::vector<int>& bodies = gathered[at(place[at(root)])].bodies;
    if (bodies.empty() || bodies.back() != body) {
      bodies.push_back(body);
    }
  }
  gathered.erase(std::remove_if(gathered.begin(),
                                gathered.end(),
                                [](const Hinge& hinge) { return hinge.bodies.size() < 2; }),
                 gathered.end());
  hinges_ = std::move(gathered);
}

//! Two bodies on two lines are one.
bool HingeGraph::mergeShared() {
  std::vector<std::pair<int, int>> pairs;
  for (const Hinge& hinge : hinges_) {
    for (std::size_t i = 0; i < hinge.bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < hinge.bodies.size(); ++j) {
        pairs.emplace_back(hinge.bodies[i], hinge.bodies[j]);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  bool merged = false;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    if (pairs[i] == pairs[i - 1]) {
      merged = true;
      merge(pairs[i].first, pairs[i].second);
    }
  }
  return merged;
}

//! Bodies on one hinge alone: each turns about it, whatever the others do. Connecting parts first:
//! that they turn is no freedom, unless a beam that was taken off hangs on them.
bool HingeGraph::takeLeavesOff() {
  std::vector<int> seats(parents_.size(), 0);
  for (const Hinge& hinge : hinges_) {
    for (const int body : hinge.bodies) {
      ++seats[at(body)];
    }
  }
  bool any = false;
  for (Hinge& hinge : hinges_) {
    std::size_t left = hinge.bodies.size();
    for (const int counts : {0, 1}) {
      for (const int body : hinge.bodies) {
        if (seats[at(body)] != 1 || off_[at(body)] != 0 || counts_[at(body)] != counts ||
            left < 2) {
          continue;
        }
        off_[at(body)] = 1;
        --left;
        any = true;
        freedoms_ += counts;
        if (counts != 0) {
          markHolder(hinge);
        }
      }
    }
  }
  return any;
}

//! What is left on the hinge of a beam that was taken off moves it.
void HingeGraph::markHolder(const Hinge& hinge) {
  int holder = -1;
  for (const int body : hinge.bodies) {
    if (off_[at(body)] == 0 && (holder < 0 || counts_[at(body)] > counts_[at(holder)])) {
      holder = body;
    }
  }
  if (holder >= 0) {
    counts_[at(holder)] = 1;
  }
}

//! Breadth first from each body in turn, so that loops stay short.
void HingeGraph::spanTree(const std::vector<Edge>& edges) {
  std::vector<std::vector<int>> edgesOf(parents_.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    edgesOf[at(edges[e].a)].push_back(static_cast<int>(e));
    edgesOf[at(edges[e].b)].push_back(static_cast<int>(e));
  }
  treeEdge_.assign(parents_.size(), 0);
  treeParent_.assign(parents_.size(), -1);
  depth_.assign(parents_.size(), -1);
  inTree_.assign(edges.size(), 0);
  std::vector<int> queue;
  for (std::size_t first = 0; first < parents_.size(); ++first) {
    if (depth_[first] >= 0 || edgesOf[first].empty()) {
      continue;
    }
    depth_[first] = 0;
    queue.assign(1, static_cast<int>(first));
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const int body = queue[next];
      for (const int e : edgesOf[at(body)]) {
        const Edge& edge = edges[at(e)];
        const int other = edge.a == body ? edge.b : edge.a;
        if (depth_[at(other)] < 0) {
          depth_[at(other)] = depth_[at(body)] + 1;
          treeParent_[at(other)] = body;
          treeEdge_[at(other)] = edge.a == other ? -(e + 1) : e + 1;
          inTree_[at(e)] = 1;
          queue.push_back(other);
        }
      }
    }
  }
}

//! The six conditions about the loop that an edge closes over the tree's edges, when that edge has
//! been eliminated from them: what is left of them in rows_. \pre The edge is none of the tree's.
void HingeGraph::addLoop(const std::vector<Edge>& edges, int closing) {
  const std::size_t columns = treeColumns_;
  const std::size_t base = rows_.size();
  rows_.resize(base + 6 * columns, 0.0);
  const Edge& edge = edges[at(closing)];
  int a = edge.a;
  int b = edge.b;
  while (a != b) {
    int& deeper = depth_[at(a)] >= depth_[at(b)] ? a : b;
    const int tree = treeEdge_[at(deeper)];
    const double way = (&deeper == &a) == (tree > 0) ? 1.0 : -1.0;
    const Screw& screw = screws_[at(std::abs(tree) - 1)];
    for (std::size_t k = 0; k < 6; ++k) {
      rows_[base + k * columns + at(columnOf_[at(std::abs(tree) - 1)])] = way * screw[k];
    }
    deeper = treeParent_[at(deeper)];
  }
  const Screw& own = screws_[at(closing)];
  std::size_t pivot = 0;
  for (std::size_t k = 1; k < 6; ++k) {
    pivot = std::abs(own[k]) > std::abs(own[pivot]) ? k : pivot;
  }
  std::array<std::size_t, 6> order{};
  std::size_t kept = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    if (k == pivot) {
      continue;
    }
    const double factor = own[k] / own[pivot];
    const double* lead = rows_.data() + base + pivot * columns;
    double* row = rows_.data() + base + k * columns;
    bool empty = true;
    for (std::size_t c = 0; c < columns; ++c) {
      row[c] -= factor * lead[c];
      empty = empty && std::abs(row[c]) < kZero;
    }
    order[kept] = k;
    kept += empty ? 0 : 1;
  }
  for (std::size_t i = 0; i < kept; ++i) {
    if (order[i] != i) {
      const double* row = rows_.data() + base + order[i] * columns;
      std::copy_n(row, columns, rows_.data() + base + i * columns);
    }
  }
  rows_.resize(base + kept * columns);
}

//! Rank of the conditions about all loops, by elimination with row pivots: an edge that closes a
//! loop stands in that one alone, so one condition of each goes at once.
int HingeGraph::rankOfLoops(const std::vector<Edge>& edges) {
  Vec3 middle;
  for (const Edge& edge : edges) {
    middle = middle + (1.0 / static_cast<double>(edges.size())) * lines_[at(edge.line)].second;
  }
  screws_.clear();
  columnOf_.assign(edges.size(), -1);
  treeColumns_ = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& [axis, through] = lines_[at(edges[e].line)];
    const Vec3 direction = lattice::unitVector(axis);
    const Vec3 moment = lattice::cross(through - middle, direction);
    screws_.push_back({direction.x, direction.y, direction.z, moment.x, moment.y, moment.z});
    columnOf_[e] = inTree_[e] != 0 ? static_cast<int>(treeColumns_++) : -1;
  }
  rows_.clear();
  int rank = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (inTree_[e] == 0) {
      addLoop(edges, static_cast<int>(e));
      ++rank;
    }
  }
  return rank + rankOfRows();
}

int HingeGraph::rankOfRows() {
  const std::size_t columns = treeColumns_;
  const std::size_t rows = columns == 0 ? 0 : rows_.size() / columns;
  std::size_t top = 0;
  for (std::size_t c = 0; c < columns && top < rows; ++c) {
    std::size_t pivot = top;
    for (std::size_t r = top + 1; r < rows; ++r) {
      if (std::abs(rows_[r * columns + c]) > std::abs(rows_[pivot * columns + c])) {
        pivot = r;
      }
    }
    if (std::abs(rows_[pivot * columns + c]) < kZero) {
      continue;
    }
    double* lead = rows_.data() + top * columns;
    if (pivot != top) {
      std::swap_ranges(lead + c, lead + columns, rows_.data() + pivot * columns + c);
    }
    for (std::size_t r = top + 1; r < rows; ++r) {
      double* row = rows_.data() + r * columns;
      if (row[c] == 0.0) {
        continue;
      }
      const double factor = row[c] / lead[c];
      row[c] = 0.0;
      for (std::size_t k = c + 1; k < columns; ++k) {
        row[k] -= factor * lead[k];
      }
    }
    ++top;
  }
  return static_cast<int>(top);
}

int HingeGraph::loopFreedoms() {
  std::vector<Edge> edges;
  for (const Hinge& hinge : hinges_) {
    for (std::size_t i = 1; i < hinge.bodies.size(); ++i) {
      edges.push_back({hinge.bodies.front(), hinge.bodies[i], hinge.line});
    }
  }
  if (edges.empty()) {
    return 0;
  }
  spanTree(edges);
  return static_cast<int>(edges.size()) - rankOfLoops(edges);
}

int HingeGraph::mobility() {
  freedoms_ = 0;
  do {
    gather();
  } while (mergeShared() || takeLeavesOff());
  return freedoms_ + loopFreedoms();
}

}  // namespace liftarm::objective
