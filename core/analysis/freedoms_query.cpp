#include "analysis/freedoms_query.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "analysis/axle_lines.h"
#include "analysis/node_index.h"
#include "analysis/union_find.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;

constexpr double kSamePlace = 0.05;  // modules

double distanceToEdge(Vec3 p, const EdgeCover& edge) {
  return std::min(lattice::length(p - edge.from), lattice::length(p - edge.to));
}

//! Lines that have a node at a place, by their first edge there.
std::vector<int> linesAt(const std::vector<EdgeCover>& coverage, Vec3 p) {
  std::vector<int> lines;
  for (const EdgeCover& edge : coverage) {
    const bool isNew = lines.empty() || lines.back() != edge.line;
    if (isNew && distanceToEdge(p, edge) < kSamePlace) {
      lines.push_back(edge.line);
    }
  }
  return lines;
}

//! The lines on the two sides of a joint of two bodies.
std::pair<std::vector<int>, std::vector<int>> sidesOf(const sketch::Joint& joint,
                                                      const std::vector<EdgeCover>& coverage) {
  const std::vector<int> meeting = linesAt(coverage, joint.at);
  if (joint.between.size() == 1) {
    std::vector<int> others;
    for (const int line : meeting) {
      if (std::count(joint.between[0].begin(), joint.between[0].end(), line) == 0) {
        others.push_back(line);
      }
    }
    return {joint.between[0], others};
  }
  if (meeting.empty()) {
    return {};
  }
  return {{meeting.front()}, {meeting.begin() + 1, meeting.end()}};
}

//! The beam that covers one of the lines nearest to a place.
std::optional<int> partOf(const std::vector<int>& lines,
                          Vec3 place,
                          const std::vector<EdgeCover>& coverage) {
  std::optional<int> best;
  double nearest = 1e9;
  for (const EdgeCover& edge : coverage) {
    if (std::count(lines.begin(), lines.end(), edge.line) == 0 || edge.covers.empty()) {
      continue;
    }
    const double distance = distanceToEdge(place, edge);
    if (distance < nearest - kSamePlace) {
      nearest = distance;
      best = edge.covers.front().part;
    }
  }
  return best;
}

//! \brief Lines that the drawing holds together: they meet where no joint is, or a joint names them
//! as one group.
class DrawnBodies {
 public:
  DrawnBodies(const sketch::Sketch& sketch, const std::vector<EdgeCover>& coverage)
      : groups_(sketch.lines.size()) {
    const NodeIndex nodes(coverage);
    for (std::size_t node = 0; node < nodes.points().size(); ++node) {
      const Vec3 place = nodes.points()[node];
      const bool turns =
          std::any_of(sketch.joints.begin(), sketch.joints.end(), [&](const sketch::Joint& joint) {
            return lattice::length(joint.at - place) < kSamePlace;
          });
      const std::vector<int>& edges = nodes.edgesAt(static_cast<int>(node));
      for (const int edge : edges) {
        if (!turns) {
          groups_.join(coverage[at(edge)].line, coverage[at(edges.front())].line);
        }
      }
    }
    for (const sketch::Joint& joint : sketch.joints) {
      for (const std::vector<int>& group : joint.between) {
        for (const int line : group) {
          groups_.join(line, group.front());
        }
      }
    }
  }

  //! Whether a line is of the body of some lines.
  [[nodiscard]] bool isOf(int line, const std::vector<int>& lines) {
    return std::any_of(lines.begin(), lines.end(), [&](int other) {
      return groups_.find(line) == groups_.find(other);
    });
  }

 private:
  UnionFind groups_;
};

bool coversAny(int part,
               const std::vector<int>& lines,
               DrawnBodies& bodies,
               const std::vector<EdgeCover>& coverage) {
  return std::any_of(coverage.begin(), coverage.end(), [&](const EdgeCover& edge) {
    return bodies.isOf(edge.line, lines) &&
           std::any_of(edge.covers.begin(), edge.covers.end(), [&](const Cover& cover) {
             return cover.part == part;
           });
  });
}

//! For lines without a beam, which an axle stands for: the nearest beam that it goes through, of
//! those that the drawing holds together with these lines and not with the other side's. The axle
//! itself where there is none: then it is the axle that turns, as that of two wheels does in both
//! rails of a chassis.
std::optional<int> partOnAxle(const AxleLines& axles,
                              const std::vector<int>& lines,
                              const std::vector<int>& others,
                              Vec3 place,
                              DrawnBodies& bodies,
                              const std::vector<EdgeCover>& coverage) {
  std::optional<int> best;
  double nearest = 1e9;
  for (const int axle : axles.ofLines(lines, coverage)) {
    best = best.value_or(axle);
    for (const model::Connection* c : axles.heldBy(axle)) {
      const double distance = lattice::length(c->at - place);
      if (distance < nearest - kSamePlace && coversAny(c->female, lines, bodies, coverage) &&
          !coversAny(c->female, others, bodies, coverage)) {
        nearest = distance;
        best = c->female;
      }
    }
  }
  return best;
}

//! The line of the head that a joint turns on, where one lies there, those of its own parts first:
//! what a file has rounded may be off the drawing, and a driver beside its pin would lock it.
void layOnHead(const Scene& scene, JointLine& line) {
  const JointLine drawn = line;
  bool own = false;
  for (const model::Connection& c : scene.connections) {
    if (!model::isGood(c.fit) || own) {
      continue;
    }
    const lattice::Pose& pose = scene.model->parts[at(c.male)].pose;
    const parts::Feature& head = scene.parts[at(c.male)].part->features[at(c.maleFeature)];
    const Vec3 axis = lattice::normalized(pose.rotation * head.axis);
    const double cosine = lattice::dot(axis, drawn.axis);
    const Vec3 offset = drawn.at - pose.apply(head.center);
    const Vec3 aside = offset - lattice::dot(offset, axis) * axis;
    if (std::abs(cosine) >= model::kCoaxialCosine &&
        lattice::length(aside) <= model::kCoaxialDistance) {
      line.at = drawn.at - aside;
      line.axis = cosine < 0 ? -axis : axis;
      own = c.male == line.a || c.male == line.b || c.female == line.a || c.female == line.b;
    }
  }
}

}  // namespace

std::vector<JointLine> findJointLines(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  std::vector<JointLine> lines;
  if (!scene.sketch.has_value() || scene.sketch->joints.empty()) {
    return lines;
  }
  const AxleLines axles(scene);
  DrawnBodies bodies(*scene.sketch, coverage);
  const auto add = [&](int index,
                       const std::vector<int>& first,
                       const std::vector<int>& second,
                       std::optional<JointPair> pair) {
    const sketch::Joint& joint = scene.sketch->joints[at(index)];
    JointLine line{joint.at,
                   joint.axis,
                   partOf(first, joint.at, coverage),
                   partOf(second, joint.at, coverage),
                   index,
                   pair};
    if (!line.a.has_value()) {
      line.a = partOnAxle(axles, first, second, joint.at, bodies, coverage);
    }
    if (!line.b.has_value()) {
      line.b = partOnAxle(axles, second, first, joint.at, bodies, coverage);
    }
    layOnHead(scene, line);
    lines.push_back(line);
  };
  for (int j = 0; j < static_cast<int>(scene.sketch->joints.size()); ++j) {
    const std::vector<std::vector<int>>& between = scene.sketch->joints[at(j)].between;
    const int groups = static_cast<int>(between.size());
    if (groups < 2) {
      const auto [first, second] = sidesOf(scene.sketch->joints[at(j)], coverage);
      add(j, first, second, std::nullopt);
    }
    for (int a = 0; a < groups; ++a) {
      for (int b = a + 1; b < groups; ++b) {
        add(j,
            between[at(a)],
            between[at(b)],
            groups > 2 ? std::optional(JointPair{a, b}) : std::nullopt);
      }
    }
  }
  return lines;
}

FreedomsQuery makeFreedomsQuery(const Scene& scene,
                                const std::vector<EdgeCover>& coverage,
                                Friction friction) {
  FreedomsQuery query;
  query.linkage = linkageOf(scene, friction);
  for (const ScenePart& part : scene.parts) {
    query.frame.push_back(part.part != nullptr && part.part->partClass == parts::PartClass::kBeam &&
                          part.part->features.size() > 1);
    query.weight.push_back(part.part != nullptr ? part.part->mass : 0.0);
  }
  query.joints = findJointLines(scene, coverage);
  for (const JointLine& joint : query.joints) {
    for (const std::optional<int> part : {joint.a, joint.b}) {
      if (part.has_value()) {
        query.frame[at(*part)] = true;  // an axle that is one side of a joint
      }
    }
  }
  return query;
}

}  // namespace liftarm::analysis
