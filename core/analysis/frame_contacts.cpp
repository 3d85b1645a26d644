#include "analysis/frame_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>

#include "analysis/frame_rest.h"
#include "analysis/union_find.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

int nearestNode(const FrameModel& model, const Foot& point) {
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
  return lattice::length(a.at - b.at);
}

void addHold(FrameModel& model, FrameSpring spring, Six stiffness) {
  spring.stiffness = stiffness;
  model.frame.springs.push_back(spring);
  model.connectionOfSpring.push_back(-1);
}

//! Keeps one assembly from sliding. \param feet Its contacts, at least one.
void holdSideways(FrameModel& model, Vec3 up, const std::vector<FrameSpring>& feet) {
  const auto farthest = [&](const FrameSpring& from) {
    return *std::max_element(
        feet.begin(), feet.end(), [&](const FrameSpring& a, const FrameSpring& b) {
          return apart(from, a) < apart(from, b);
        });
  };
  const FrameSpring first = farthest(feet.front());
  FrameSpring second = farthest(first);
  addHold(model, first, {kGroundStiffness, kGroundStiffness, 0, 0, 0, 0});
  Vec3 along = second.at - first.at;
  along = along - lattice::dot(along, up) * up;
  if (lattice::length(along) < 1e-6) {
    // One point: a drill in it.
    constexpr double kDrill = kGroundStiffness * kMillimetresPerModule * kMillimetresPerModule;
    addHold(model, first, {0, 0, 0, 0, 0, kDrill});
    return;
  }
  along = lattice::normalized(along);
  second.axes = lattice::fromColumns(along, lattice::cross(up, along), up);
  addHold(model, second, {0, kGroundStiffness, 0, 0, 0, 0});
}

//! Of the frame's loads so far, which are weights along -z, and of what presses down. Modules.
Vec3 centreOf(const Frame& frame, const std::vector<PointLoad>& loads) {
  Vec3 sum;
  double total = 0.0;
  const auto add = [&](Vec3 at, double weight) {
    sum = sum + weight * at;
    total += weight;
  };
  for (const FrameElement& element : frame.elements) {
    const Vec3 a = frame.nodes[static_cast<std::size_t>(element.a)];
    const Vec3 b = frame.nodes[static_cast<std::size_t>(element.b)];
    add(0.5 * (a + b), -element.load.z * lattice::length(b - a));
  }
  for (std::size_t node = 0; node < frame.nodes.size(); ++node) {
    add(frame.nodes[node], -frame.loads[node][2]);
  }
  for (const PointLoad& load : loads) {
    add(kMillimetresPerModule * load.at, std::max(0.0, -load.force.z));
  }
  return total > 0.0 ? (1.0 / (total * kMillimetresPerModule)) * sum : sum;
}

//! Weights along -z become weights against `up`.
void turnWeights(Frame& frame, Vec3 up) {
  for (FrameElement& element : frame.elements) {
    element.load = element.load.z * up;
  }
  for (Six& load : frame.loads) {
    const Vec3 turned = load[2] * up;
    load = {turned.x, turned.y, turned.z, 0, 0, 0};
  }
}

}  // namespace

void addGround(const Scene& scene, const std::vector<PointLoad>& loads, FrameModel& model) {
  const Rest rest = findRest(scene, centreOf(model.frame, loads));
  model.up = rest.up;
  model.tilt = rest.tilt;
  turnWeights(model.frame, rest.up);
  const Vec3 other = std::abs(rest.up.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 y = lattice::normalized(lattice::cross(rest.up, other));
  for (const Foot& point : rest.feet) {
    FrameSpring contact;
    contact.a = nearestNode(model, point);
    contact.at = kMillimetresPerModule * point.at;
    contact.axes = lattice::fromColumns(lattice::cross(y, rest.up), y, rest.up);
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
                 [&](const FrameSpring& foot) {
                   return assemblies[static_cast<std::size_t>(foot.a)] == assembly;
                 });
    holdSideways(model, rest.up, feet);
  }
}

}  // namespace liftarm::analysis
