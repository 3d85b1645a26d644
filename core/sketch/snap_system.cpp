#include "sketch/snap_system.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/index.h"
#include "sketch/point_index.h"

namespace liftarm::sketch {

namespace {

using base::at;
using lattice::Vec3;

//! The common value of numbers that are meant to be equal: the first whole one, else their mean.
class SharedValue {
 public:
  void add(double value) {
    first_ = count_ == 0 ? value : first_;
    allEqual_ = allEqual_ && value == first_;
    sum_ += value;
    ++count_;
    if (!hasWhole_ && value == std::floor(value)) {
      hasWhole_ = true;
      whole_ = value;
    }
  }

  [[nodiscard]] double value() const {
    if (hasWhole_) {
      return whole_;
    }
    return allEqual_ ? first_ : sum_ / static_cast<double>(count_);
  }

 private:
  double first_ = 0.0;
  double whole_ = 0.0;
  double sum_ = 0.0;
  int count_ = 0;
  bool allEqual_ = true;
  bool hasWhole_ = false;
};

//! End points made one where they agree.
struct Vertices {
  std::vector<Vec3> points;
  std::vector<std::array<int, 2>> ends;  //!< line -> vertex of from, of to
};

Vertices weld(const std::vector<Line>& lines, double tolerance) {
  PointIndex index(tolerance);
  Vertices vertices;
  // The first point stands for all that agree with it, coordinate by coordinate unless a later one
  // is whole there. A mean would move, and might come close to points that were told apart.
  const auto vertexOf = [&](const Vec3& point) {
    const int id = index.findOrInsert(point);
    if (id == static_cast<int>(vertices.points.size())) {
      vertices.points.push_back(point);
    }
    Vec3& common = vertices.points[at(id)];
    for (int axis = 0; axis < 3; ++axis) {
      if (common[axis] != std::floor(common[axis]) && point[axis] == std::floor(point[axis])) {
        common[axis] = point[axis];
      }
    }
    return id;
  };
  for (const Line& line : lines) {
    const int from = vertexOf(line.from);
    const int to = vertexOf(line.to);
    vertices.ends.push_back({from, to});
  }
  return vertices;
}

//! Sets of coordinates that are one variable, as a forest of parents.
class CoordinateSets {
 public:
  explicit CoordinateSets(const std::vector<Vec3>& points)
      : parent_(3 * points.size()), low_(parent_.size()), high_(parent_.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      low_[i] = high_[i] = points[i / 3][static_cast<int>(i % 3)];
    }
  }

  int rootOf(int i) {
    while (parent_[at(i)] != i) {
      parent_[at(i)] = parent_[at(parent_[at(i)])];
      i = parent_[at(i)];
    }
    return i;
  }

  //! Joins two sets unless together they would span more than `maxSpan`: a long staircase of lines
  //! that are each nearly level is not level.
  void join(int a, int b, double maxSpan) {
    a = rootOf(a);
    b = rootOf(b);
    const double low = std::min(low_[at(a)], low_[at(b)]);
    const double high = std::max(high_[at(a)], high_[at(b)]);
    if (a == b || high - low > maxSpan) {
      return;
    }
    const int root = std::min(a, b);
    parent_[at(std::max(a, b))] = root;
    low_[at(root)] = low;
    high_[at(root)] = high;
  }

 private:
  std::vector<int> parent_;
  std::vector<double> low_;
  std::vector<double> high_;
};

//! Gives every coordinate of every vertex its variable.
std::vector<std::array<int, 3>> shareCoordinates(const Vertices& vertices,
                                                 double tolerance,
                                                 std::vector<double>& values) {
  CoordinateSets sets(vertices.points);
  for (const auto& [from, to] : vertices.ends) {
    for (int axis = 0; axis < 3; ++axis) {
      const double span = vertices.points[at(to)][axis] - vertices.points[at(from)][axis];
      if (std::abs(span) <= tolerance) {
        sets.join(3 * from + axis, 3 * to + axis, 2.0 * tolerance);
      }
    }
  }
  std::vector<int> variableOfRoot(3 * vertices.points.size(), -1);
  std::vector<SharedValue> shared;
  std::vector<std::array<int, 3>> variables(vertices.points.size());
  for (std::size_t v = 0; v < vertices.points.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const int root = sets.rootOf(3 * static_cast<int>(v) + axis);
      int& variable = variableOfRoot[at(root)];
      if (variable < 0) {
        variable = static_cast<int>(shared.size());
        shared.emplace_back();
      }
      shared[at(variable)].add(vertices.points[v][axis]);
      variables[v][at(axis)] = variable;
    }
  }
  for (const SharedValue& value : shared) {
    values.push_back(value.value());
  }
  return variables;
}

//! A point between two vertices: (1 - share) * from + share * to.
struct Between {
  int from = 0;
  int to = 0;
  double share = 0.0;
};

//! Collects the contacts of a welded drawing.
class ContactFinder {
 public:
  ContactFinder(const std::vector<std::array<int, 3>>& variables,
                const std::vector<double>& values,
                double tolerance)
      : variables_(variables), values_(values), tolerance_(tolerance), index_(tolerance) {
    for (std::size_t v = 0; v < variables.size(); ++v) {
      index_.insert(pointOf(static_cast<int>(v)));
      places_.push_back({static_cast<int>(v), static_cast<int>(v), 0.0});
    }
  }

  //! Nodes inside a line meet end points and the nodes of earlier lines.
  void addNodes(int from, int to, int length) {
    const Vec3 begin = pointOf(from);
    const Vec3 span = pointOf(to) - begin;
    for (int i = 1; i < length; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(length);
      const Between place{from, to, share};
      const Vec3 point = begin + share * span;
      const int met = index_.find(point);
      if (met < 0) {
        index_.insert(point);
        places_.push_back(place);
        continue;
      }
      const Between& other = places_[at(met)];
      addRows(other.from == other.to ? Contact::kEndPoint : Contact::kCrossing, place, other);
    }
  }

  //! A vertex that two lines of lengths `before` and `after` pass straight through.
  void addIfStraight(int previous, int middle, int next, double share) {
    const Vec3 chordPoint = (1.0 - share) * pointOf(previous) + share * pointOf(next);
    if (lattice::length(chordPoint - pointOf(middle)) <= tolerance_) {
      addRows(Contact::kStraight, {previous, next, share}, {middle, middle, 0.0});
    }
  }

  std::vector<ContactRow> takeRows() { return std::move(rows_); }

 private:
  [[nodiscard]] Vec3 pointOf(int vertex) const {
    const std::array<int, 3>& v = variables_[at(vertex)];
    return {values_[at(v[0])], values_[at(v[1])], values_[at(v[2])]};
  }

  void addRows(Contact kind, const Between& a, const Between& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      LinearRow row;
      addTerm(row, variables_[at(a.from)][axis], 1.0 - a.share);
      addTerm(row, variables_[at(a.to)][axis], a.share);
      addTerm(row, variables_[at(b.from)][axis], b.share - 1.0);
      addTerm(row, variables_[at(b.to)][axis], -b.share);
      const bool says = std::any_of(row.terms.begin(), row.terms.end(), [](const auto& term) {
        return std::abs(term.second) > kNoCoefficient;
      });
      if (says) {
        rows_.push_back({kind, std::move(row)});
      }
    }
  }

  static void addTerm(LinearRow& row, int variable, double coefficient) {
    for (auto& [known, sum] : row.terms) {
      if (known == variable) {
        sum += coefficient;
        return;
      }
    }
    row.terms.emplace_back(variable, coefficient);
  }

  static constexpr double kNoCoefficient = 1e-12;  // what is left of 1 - share - (1 - share)

  const std::vector<std::array<int, 3>>& variables_;
  const std::vector<double>& values_;
  double tolerance_;
  PointIndex index_;
  std::vector<Between> places_;  //!< for each point of the index
  std::vector<ContactRow> rows_;
};

struct Neighbour {
  int vertex = 0;
  int length = 0;
};

//! Lines that run on straight through a shared end point stay straight.
void findStraightLines(const std::vector<std::vector<Neighbour>>& neighbours,
                       ContactFinder& contacts) {
  // A vertex with more lines is a hub of no drawing that people make; pairs would grow as its
  // square.
  constexpr std::size_t kMaxLinesAtVertex = 64;
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    const std::vector<Neighbour>& around = neighbours[v];
    for (std::size_t i = 0; i < around.size() && around.size() <= kMaxLinesAtVertex; ++i) {
      for (std::size_t j = i + 1; j < around.size(); ++j) {
        const double before = around[i].length;
        const double after = around[j].length;
        contacts.addIfStraight(
            around[i].vertex, static_cast<int>(v), around[j].vertex, before / (before + after));
      }
    }
  }
}

}  // namespace

SketchVariables findVariables(const std::vector<Line>& lines, double tolerance) {
  SketchVariables result;
  const Vertices vertices = weld(lines, tolerance);
  const auto variables = shareCoordinates(vertices, tolerance, result.values);

  ContactFinder contacts(variables, result.values, tolerance);
  std::vector<std::vector<Neighbour>> neighbours(vertices.points.size());
  std::vector<std::array<int, 3>> distinct;  // smaller vertex, larger vertex, first line
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [from, to] = vertices.ends[i];
    result.ends.push_back({variables[at(from)], variables[at(to)]});
    distinct.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i)});
  }
  std::sort(distinct.begin(), distinct.end());
  std::vector<int> firstLines;
  for (std::size_t k = 0; k < distinct.size(); ++k) {
    const bool isNew =
        k == 0 || distinct[k][0] != distinct[k - 1][0] || distinct[k][1] != distinct[k - 1][1];
    if (isNew) {
      firstLines.push_back(distinct[k][2]);
    }
  }
  std::sort(firstLines.begin(), firstLines.end());
  for (const int i : firstLines) {
    const auto [from, to] = vertices.ends[at(i)];
    const int length = lines[at(i)].length;
    result.lengths.push_back({variables[at(from)], variables[at(to)], static_cast<double>(length)});
    contacts.addNodes(from, to, length);
    neighbours[at(from)].push_back({to, length});
    neighbours[at(to)].push_back({from, length});
  }
  findStraightLines(neighbours, contacts);
  result.contacts = contacts.takeRows();
  return result;
}

}  // namespace liftarm::sketch
