#include "analysis/frame_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>

#include "analysis/union_find.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

struct GroundPoint {
  int part = -1;
  Vec3 at;  // world, modules
};

//! The points of a prism that are lowest for its pose: where it would touch a table.
void addLowPoints(const parts::Prism& prism, int part, std::vector<GroundPoint>& points) {
  constexpr double kUpright = 0.999;
  const Vec3 up{0, 0, 1};
  const Vec3 axis = prism.axis;
  for (const Vec3 end : {prism.from, prism.to}) {
    if (std::abs(axis.z) > kUpright) {
      // Lies on a flat face: the four points around each end.
      const Vec3 side =
          lattice::normalized(std::abs(axis.x) < 0.9 ? lattice::cross(axis, {1, 0, 0})
                                                     : lattice::cross(axis, {0, 1, 0}));
      const Vec3 bottom = end - prism.halfThickness * up;
      for (const Vec3 way : {side, lattice::cross(up, side)}) {
        points.push_back({part, bottom + prism.radius * way});
        points.push_back({part, bottom - prism.radius * way});
      }
    } else {
      const Vec3 down = lattice::normalized(axis.z * axis - up);
      const Vec3 bottom = end + prism.radius * down;
      points.push_back({part, bottom + prism.halfThickness * axis});
      points.push_back({part, bottom - prism.halfThickness * axis});
    }
  }
}

std::vector<GroundPoint> findGroundPoints(const Scene& scene) {
  std::set<std::tuple<int, int, int>> inHoles;
  for (const model::Connection& c : scene.connections) {
    inHoles.insert({c.male, c.maleFeature, c.maleSlot});
  }
  std::vector<GroundPoint> all;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const int part = static_cast<int>(i);
    for (const Shape& shape : scene.parts[i].shapes) {
      const bool free =
          shape.kind == Shape::Kind::kHead && inHoles.count({part, shape.feature, shape.slot}) == 0;
      if (shape.kind == Shape::Kind::kBody || free) {
        addLowPoints(shape.prism, part, all);
      }
    }
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (const GroundPoint& point : all) {
    lowest = std::min(lowest, point.at.z);
  }
  std::vector<GroundPoint> result;
  constexpr double kSame = 1e-6;
  for (const GroundPoint& point : all) {
    const auto isSame = [&](const GroundPoint& other) {
      return other.part == point.part && lattice::length(other.at - point.at) < kSame;
    };
    if (point.at.z < lowest + kGroundTolerance &&
        std::none_of(result.begin(), result.end(), isSame)) {
      result.push_back(point);
    }
  }
  return result;
}

int nearestNode(const FrameModel& model, const GroundPoint& point) {
  const std::vector<int>& nodes = model.nodesOfPart[static_cast<std::size_t>(point.part)];
  const Vec3 at = kMillimetresPerModule * point.at;
  return *std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) {
    return lattice::length(model.frame.nodes[static_cast<std::size_t>(a)] - at) <
           lattice::length(model.frame.nodes[static_cast<std::size_t>(b)] - at);
  });
}

//! The assembly of each node: the least node that it hangs together with.
std::vector<int> assembliesOf(const Frame& frame) {
  UnionFind groups(frame.nodes.size());
  for (const FrameElement& element : frame.elements) {
    groups.join(element.a, element.b);
  }
  for (const FrameSpring& spring : frame.springs) {
    groups.join(spring.a, spring.b);
  }
  std::vector<int> result;
  for (std::size_t node = 0; node < frame.nodes.size(); ++node) {
    result.push_back(groups.find(static_cast<int>(node)));
  }
  return result;
}

double apart(const FrameSpring& a, const FrameSpring& b) {
  return std::hypot(a.at.x - b.at.x, a.at.y - b.at.y);
}

void addHold(FrameModel& model, FrameSpring spring, Six stiffness) {
  spring.stiffness = stiffness;
  model.frame.springs.push_back(spring);
  model.connectionOfSpring.push_back(-1);
}

//! Keeps one assembly from sliding. \param feet Its contacts, at least one.
void holdSideways(FrameModel& model, const std::vector<FrameSpring>& feet) {
  const auto farthest = [&](const FrameSpring& from) {
    return *std::max_element(
        feet.begin(), feet.end(), [&](const FrameSpring& a, const FrameSpring& b) {
          return apart(from, a) < apart(from, b);
        });
  };
  const FrameSpring first = farthest(feet.front());
  FrameSpring second = farthest(first);
  addHold(model, first, {kGroundStiffness, kGroundStiffness, 0, 0, 0, 0});
  const double span = apart(first, second);
  if (span < 1e-6) {
    // One point: a drill in it.
    constexpr double kDrill = kGroundStiffness * kMillimetresPerModule * kMillimetresPerModule;
    addHold(model, first, {0, 0, 0, 0, 0, kDrill});
    return;
  }
  const Vec3 along = (1.0 / span) * Vec3{second.at.x - first.at.x, second.at.y - first.at.y, 0};
  second.axes = lattice::fromColumns(along, lattice::cross({0, 0, 1}, along), {0, 0, 1});
  addHold(model, second, {0, kGroundStiffness, 0, 0, 0, 0});
}

}  // namespace

void addGround(const Scene& scene, FrameModel& model) {
  for (const GroundPoint& point : findGroundPoints(scene)) {
    FrameSpring contact;
    contact.a = nearestNode(model, point);
    contact.at = kMillimetresPerModule * point.at;
    contact.stiffness = {0, 0, kGroundStiffness, 0, 0, 0};
    model.frame.contacts.push_back(contact);
  }
  const std::vector<int> assemblies = assembliesOf(model.frame);
  std::set<int> done;
  for (const FrameSpring& contact : model.frame.contacts) {
    const int assembly = assemblies[static_cast<std::size_t>(contact.a)];
    if (!done.insert(assembly).second) {
      continue;
    }
    std::vector<FrameSpring> feet;
    std::copy_if(model.frame.contacts.begin(),
                 model.frame.contacts.end(),
                 std::back_inserter(feet),
                 [&](const FrameSpring& other) {
                   return assemblies[static_cast<std::size_t>(other.a)] == assembly;
                 });
    holdSideways(model, feet);
  }
}

}  // namespace liftarm::analysis
