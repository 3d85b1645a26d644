#include "sketch/sketch_checks.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "sketch/arrangement.h"
#include "sketch/json_text.h"
#include "sketch/point_index.h"
#include "sketch/sketch_json.h"
#include "sketch/snap.h"

namespace liftarm::sketch {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;

//! "x and y": the axes along which a line runs, or those across which it does not.
std::string axesText(const Line& line, bool along) {
  std::string text;
  const Vec3 span = line.to - line.from;
  for (int axis = 0; axis < 3; ++axis) {
    if (!isSnapped(span[axis]) == along) {
      text += (text.empty() ? "" : (along ? " and " : " or ")) +
              std::string(axisName(lattice::axisFromIndex(axis)));
    }
  }
  return text;
}

//! Half modules: parts have their holes a module apart, so the drawing has to grow.
std::string twiceText(double length) {
  const double twice = std::round(2.0 * length);
  return isSnapped(2.0 * length - twice)
             ? "; with the whole drawing twice as large it would be " + shortNumber(twice)
             : "";
}

bool checkWholeLength(Line& line, std::string_view place, FieldReader& fields) {
  const double length = lattice::length(line.to - line.from);
  if (isSnapped(length)) {
    return fields.fail(place, "from and to are the same point; a line is at least 1 module long");
  }
  const double nearest = std::max(1.0, std::round(length));
  if (!isSnapped(length - nearest)) {
    const double below = std::floor(length);
    return fields.fail(place,
                       "length " + shortNumber(length) +
                           " is not a whole number of modules; nearest: " +
                           (below < 1.0 ? "" : shortNumber(below) + " or ") +
                           shortNumber(below + 1.0) + twiceText(length));
  }
  line.length = static_cast<int>(nearest);
  return true;
}

//! The nodes of all lines with, at each point, every line that has a node there.
class NodesOfLines {
 public:
  explicit NodesOfLines(const std::vector<Line>& lines) : index_(kLengthTolerance) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (int k = 0; k <= lines[i].length; ++k) {
        const int point = index_.findOrInsert(nodeOfLine(lines[i], k));
        nodes_.resize(at(index_.size()));
        nodes_[at(point)].push_back({static_cast<int>(i), k});
      }
    }
  }

  //! (line, index) of all nodes at a point, in the order of the lines.
  [[nodiscard]] const std::vector<std::pair<int, int>>& meetingAt(const Vec3& point) const {
    const int found = index_.find(point);
    return found < 0 ? none_ : nodes_[at(found)];
  }

 private:
  PointIndex index_;
  std::vector<std::vector<std::pair<int, int>>> nodes_;
  std::vector<std::pair<int, int>> none_;
};

//! \pre nodes are in the order of their lines.
bool isAmong(const std::vector<std::pair<int, int>>& nodes, int line) {
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), std::pair{line, 0});
  return found != nodes.end() && found->first == line;
}

bool checkGroups(const Joint& joint,
                 const std::vector<std::pair<int, int>>& meeting,
                 std::string_view place,
                 FieldReader& fields) {
  const std::string groupsPlace = memberPlace(place, "between");
  std::vector<int> all;
  for (std::size_t g = 0; g < joint.between.size(); ++g) {
    for (const int line : joint.between[g]) {
      if (!isAmong(meeting, line)) {
        return fields.fail(
            elementPlace(groupsPlace, g),
            "line " + std::to_string(line) + " has no node at " + pointText(joint.at));
      }
      all.push_back(line);
    }
  }
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  return twice == all.end() ||
         fields.fail(groupsPlace,
                     "line " + std::to_string(*twice) +
                         " stands in two groups; a line moves with one of them");
}

bool checkJoint(const Joint& joint,
                const std::vector<std::pair<int, int>>& meeting,
                std::string_view place,
                FieldReader& fields) {
  if (meeting.empty()) {
    return fields.fail(memberPlace(place, "at"),
                       pointText(joint.at) +
                           " is no node of any line; expected a point a whole "
                           "number of modules from a line's end");
  }
  if (!joint.between.empty()) {
    return checkGroups(joint, meeting, place, fields);
  }
  if (meeting.size() != 2) {
    std::string lines;
    for (std::size_t i = 0; i < std::min<std::size_t>(meeting.size(), 8); ++i) {
      lines += (lines.empty() ? "" : ", ") + std::to_string(meeting[i].first);
    }
    return fields.fail(memberPlace(place, "between"),
                       meeting.size() < 2
                           ? "only line " + lines + " has a node here; a joint needs two lines"
                           : "missing; " + std::to_string(meeting.size()) + " lines meet here (" +
                                 lines + "), so name the groups, such as [[0], [1, 2]]");
  }
  return true;
}

//! All lines of an edge that fix its hole axis fix the same one.
bool checkEdge(const Sketch& sketch, const ArrangedEdge& edge, FieldReader& fields) {
  int fixedBy = -1;
  for (const int line : edge.lines) {
    const std::optional<Axis>& axis = sketch.lines[at(line)].holeAxis;
    if (!axis.has_value()) {
      continue;
    }
    if (fixedBy >= 0 && axis != edge.holeAxis) {
      return fields.fail(memberPlace(elementPlace("lines", at(line)), "holeAxis"),
                         std::string(axisName(*axis)) + ", but line " + std::to_string(fixedBy) +
                             " overlaps it and says " + std::string(axisName(*edge.holeAxis)) +
                             "; expected the same");
    }
    fixedBy = fixedBy < 0 ? line : fixedBy;
  }
  return true;
}

}  // namespace

bool checkLine(Line& line, std::string_view place, FieldReader& fields) {
  const Vec3 span = line.to - line.from;
  const double smallest = std::min({std::abs(span.x), std::abs(span.y), std::abs(span.z)});
  if (!isSnapped(smallest)) {
    return fields.fail(place,
                       "runs " + shortNumber(span.x) + " along x, " + shortNumber(span.y) +
                           " along y and " + shortNumber(span.z) +
                           " along z; a line must lie in a plane parallel to XY, YZ or ZX, so one "
                           "of the three must be 0");
  }
  return checkWholeLength(line, place, fields);
}

bool checkHoleAxis(const Line& line, std::string_view place, FieldReader& fields) {
  if (!line.holeAxis.has_value()) {
    return true;
  }
  const int axis = lattice::index(*line.holeAxis);
  if (isSnapped((line.to - line.from)[axis])) {
    return true;
  }
  return fields.fail(memberPlace(place, "holeAxis"),
                     std::string(axisName(*line.holeAxis)) +
                         " is not perpendicular to the line, which runs along " +
                         axesText(line, true) + "; expected " + axesText(line, false));
}

bool checkJoints(const Sketch& sketch, FieldReader& fields, JointNodes& nodes) {
  if (sketch.joints.empty()) {
    return true;
  }
  const NodesOfLines nodesOfLines(sketch.lines);
  for (std::size_t i = 0; i < sketch.joints.size(); ++i) {
    const Joint& joint = sketch.joints[i];
    const auto& meeting = nodesOfLines.meetingAt(joint.at);
    if (!checkJoint(joint, meeting, elementPlace("joints", i), fields)) {
      return false;
    }
    nodes.line.push_back(meeting.front().first);
    nodes.index.push_back(meeting.front().second);
  }
  return true;
}

bool checkHoleAxesAgree(const Sketch& sketch, FieldReader& fields) {
  const bool anyFixed = std::any_of(sketch.lines.begin(), sketch.lines.end(), [](const Line& line) {
    return line.holeAxis.has_value();
  });
  if (!anyFixed) {
    return true;
  }
  for (const Run& run : arrange(sketch).runs) {
    for (const ArrangedEdge& edge : run.edges) {
      if (!checkEdge(sketch, edge, fields)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace liftarm::sketch
