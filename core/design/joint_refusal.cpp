#include "design/joint_refusal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/index.h"
#include "layout/axle_collisions.h"
#include "search/axle_sites.h"
#include "sketch/json_text.h"

namespace liftarm::design {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;
using sketch::pointText;

constexpr double kOnePlace = 0.05;    // modules
constexpr double kParallel = 1e-3;    // sine
constexpr double kMostLean = 0.015;   // sine, of a joint's axis: the check lets no pin lean by more
constexpr int kShortestWithHold = 2;  // edges of an axle that something holds at both ends

bool isParallel(Vec3 a, Vec3 b) {
  return lattice::length(lattice::cross(a, b)) < kParallel;
}

bool isOn(const sketch::Line& line, Vec3 p) {
  const Vec3 along = line.to - line.from;
  const double share = lattice::dot(p - line.from, along) / lattice::dot(along, along);
  const double slack = kOnePlace / lattice::length(along);
  return share > -slack && share < 1.0 + slack &&
         lattice::length(p - line.from - share * along) < kOnePlace;
}

//! Whether two lines have a stretch in common.
bool overlap(const sketch::Line& a, const sketch::Line& b) {
  const Vec3 along = lattice::normalized(a.to - a.from);
  const Vec3 offset = b.from - a.from;
  if (!isParallel(along, lattice::normalized(b.to - b.from)) ||
      lattice::length(lattice::cross(offset, along)) > kOnePlace) {
    return false;
  }
  const auto [low, high] =
      std::minmax({lattice::dot(offset, along), lattice::dot(b.to - a.from, along)});
  return std::min(high, lattice::length(a.to - a.from)) - std::max(low, 0.0) > kOnePlace;
}

class Refusal {
 public:
  Refusal(const sketch::Sketch& sketch, const guide::GuidingGraph& graph, int longest)
      : sketch_(sketch), graph_(graph), longest_(longest) {}

  [[nodiscard]] std::optional<std::string> find() const {
    for (std::size_t j = 0; j < sketch_.joints.size(); ++j) {
      for (const std::optional<std::string>& reason :
           {slanted(j), secondAxis(j), sharedStretch(j)}) {
        if (reason.has_value()) {
          return reason;
        }
      }
    }
    for (const guide::GuideJoint& joint : graph_.joints) {
      for (const std::vector<int>& runs : joint.runGroups) {
        if (longest_ > 0 && runs.size() == 1) {
          if (std::optional<std::string> reason = noAxle(joint, runs.front())) {
            return reason;
          }
        }
      }
    }
    return std::nullopt;
  }

 private:
  //! A joint about an axis along which no part of a model on the lattice has holes.
  [[nodiscard]] std::optional<std::string> slanted(std::size_t j) const {
    const Vec3 axis = lattice::normalized(sketch_.joints[j].axis);
    for (int i = 0; i < 3; ++i) {
      const Vec3 unit = lattice::unitVector(lattice::axisFromIndex(i));
      if (lattice::length(lattice::cross(axis, unit)) < kMostLean) {
        return std::nullopt;
      }
    }
    return "joints[" + std::to_string(j) + "].axis: " + pointText(axis) +
           " is not along x, y or z, and holes are; expected one of these";
  }

  //! Another joint at this one's place, before it in the sketch, about another axis.
  [[nodiscard]] std::optional<std::string> secondAxis(std::size_t j) const {
    const sketch::Joint& joint = sketch_.joints[j];
    for (std::size_t i = 0; i < j; ++i) {
      const sketch::Joint& other = sketch_.joints[i];
      if (lattice::length(other.at - joint.at) < kOnePlace && !isParallel(other.axis, joint.axis)) {
        return "joints[" + std::to_string(j) + "]: lines cannot turn about two axes at " +
               pointText(joint.at) + ", this one and that of joints[" + std::to_string(i) +
               "], since no part has pin holes for both at one place; expected joints at two nodes";
      }
    }
    return std::nullopt;
  }

  //! Two lines of different bodies that lie on each other.
  [[nodiscard]] std::optional<std::string> sharedStretch(std::size_t j) const {
    const std::vector<std::vector<int>>& bodies = sketch_.joints[j].between;
    for (std::size_t a = 0; a < bodies.size(); ++a) {
      for (std::size_t b = a + 1; b < bodies.size(); ++b) {
        for (const int one : bodies[a]) {
          for (const int other : bodies[b]) {
            if (overlap(sketch_.lines[at(one)], sketch_.lines[at(other)])) {
              return "joints[" + std::to_string(j) + "]: lines " + std::to_string(one) + " and " +
                     std::to_string(other) +
                     " lie on each other, so they cannot turn against each other";
            }
          }
        }
      }
    }
    return std::nullopt;
  }

  //! A run that turns about itself and cannot be an axle.
  [[nodiscard]] std::optional<std::string> noAxle(const guide::GuideJoint& joint, int run) const {
    const guide::GuideRun& guideRun = graph_.runs[at(run)];
    if (!guideRun.principal || layout::alongAxisOf(guideRun).axis != joint.axis ||
        search::mayHaveAxle(graph_, run, longest_)) {
      return std::nullopt;
    }
    const std::optional<std::string> reason = whyNoAxle(joint.axis, run);
    if (!reason.has_value()) {
      return std::nullopt;
    }
    return "joints[" + std::to_string(jointAt(joint.node, joint.axis)) + "]: " + lineText(run, 0) +
           " turns about itself, so it must be an axle, but " + *reason;
  }

  [[nodiscard]] std::optional<std::string> whyNoAxle(Axis axis, int run) const {
    const guide::GuideRun& guideRun = graph_.runs[at(run)];
    const int edges = guideRun.edgeCount();
    if (edges + 1 > longest_) {
      return "it is " + std::to_string(edges) + " long and the longest axle reaches " +
             std::to_string(longest_ - 1);
    }
    if (edges < kShortestWithHold) {
      return "it is " + std::to_string(edges) + " long, too short for one that stays in its holes";
    }
    for (const int id : guideRun.junctions) {
      for (const guide::Incidence& met : graph_.junctions[at(id)].incident) {
        const std::vector<Axis>& axes = graph_.runs[at(met.run)].axes;
        if (met.run != run && std::find(axes.begin(), axes.end(), axis) == axes.end()) {
          return lineText(met.run, met.index) + ", which meets it at " +
                 pointText(graph_.nodes[at(graph_.junctions[at(id)].node)]) +
                 ", cannot have its holes along it" + otherJoint(axis, met.run);
        }
      }
    }
    return std::nullopt;
  }

  //! The joint that asks a run for holes along another axis than this.
  [[nodiscard]] std::string otherJoint(Axis axis, int run) const {
    for (const guide::GuideJoint& joint : graph_.joints) {
      const std::vector<int>& nodes = graph_.runs[at(run)].nodes;
      if (joint.axis != axis && std::find(nodes.begin(), nodes.end(), joint.node) != nodes.end()) {
        return " because of joints[" + std::to_string(jointAt(joint.node, joint.axis)) + "]";
      }
    }
    return "";
  }

  [[nodiscard]] std::size_t jointAt(int node, Axis axis) const {
    const auto found =
        std::find_if(sketch_.joints.begin(), sketch_.joints.end(), [&](const sketch::Joint& joint) {
          return lattice::length(joint.at - graph_.nodes[at(node)]) < kOnePlace &&
                 isParallel(joint.axis, lattice::unitVector(axis));
        });
    return static_cast<std::size_t>(found - sketch_.joints.begin());
  }

  //! The first line of the sketch that covers the edge of a run next to one of its nodes.
  [[nodiscard]] std::string lineText(int run, int index) const {
    const std::vector<int>& nodes = graph_.runs[at(run)].nodes;
    const int next = index + 1 < static_cast<int>(nodes.size()) ? index + 1 : index - 1;
    const auto found =
        std::find_if(sketch_.lines.begin(), sketch_.lines.end(), [&](const sketch::Line& line) {
          return isOn(line, graph_.nodes[at(nodes[at(index)])]) &&
                 isOn(line, graph_.nodes[at(nodes[at(next)])]);
        });
    return "line " + std::to_string(found - sketch_.lines.begin());
  }

  const sketch::Sketch& sketch_;
  const guide::GuidingGraph& graph_;
  int longest_;
};

}  // namespace

std::optional<std::string> findJointRefusal(const sketch::Sketch& sketch,
                                            const guide::GuidingGraph& graph,
                                            int longest) {
  return Refusal(sketch, graph, longest).find();
}

}  // namespace liftarm::design
