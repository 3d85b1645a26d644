#include "analysis/frame_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "analysis/frame_contacts.h"
#include "analysis/frame_spin.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using model::Connection;
using model::Fit;

constexpr double kGramsPerKilogram = 1000.0;

//! Axes whose x is the given direction.
lattice::Mat3 axesAlong(Vec3 x) {
  const Vec3 other = std::abs(x.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 y = lattice::normalized(lattice::cross(other, x));
  return lattice::fromColumns(x, y, lattice::cross(x, y));
}

class Builder {
 public:
  Builder(const Scene& scene, const StressOptions& options)
      : scene_(scene), options_(options), idleHolds_(idleHolds(scene)) {}

  base::Result<FrameModel> build() {
    for (std::size_t part = 0; part < scene_.parts.size(); ++part) {
      if (scene_.parts[part].part == nullptr) {
        return base::Error{base::Status::kUnsupported,
                           nameOf(scene_, static_cast<int>(part)) +
                               ": not in the catalogue, so its shape and mass are not known"};
      }
      skeletons_.push_back(skeletonOf(*scene_.parts[part].part));
    }
    base::Result<std::vector<PlacedLoad>> loads = placeLoads(scene_, skeletons_, options_.loads);
    if (!loads.ok()) {
      return loads.error();
    }
    simplifySkeletons(loads.value());
    for (std::size_t part = 0; part < scene_.parts.size(); ++part) {
      addPart(part);
    }
    for (std::size_t c = 0; c < scene_.connections.size(); ++c) {
      addFit(scene_.connections[c], static_cast<int>(c));
    }
    result_.frame.loads.assign(result_.frame.nodes.size(), Six{});
    addWeights();
    addGround(scene_, options_.loads, result_);
    for (const PlacedLoad& load : loads.value()) {
      addLoad(load);
    }
    return std::move(result_);
  }

 private:
  void simplifySkeletons(const std::vector<PlacedLoad>& loads) {
    std::vector<std::vector<bool>> keep;
    for (const Skeleton& skeleton : skeletons_) {
      keep.emplace_back(skeleton.points.size(), false);
    }
    for (const Connection& c : scene_.connections) {
      if (isGood(c.fit)) {
        keep[static_cast<std::size_t>(c.male)]
            [static_cast<std::size_t>(pointOf(c.male, c.maleFeature, c.maleSlot))] = true;
        keep[static_cast<std::size_t>(c.female)]
            [static_cast<std::size_t>(pointOf(c.female, c.femaleFeature, c.femaleSlot))] = true;
      }
    }
    for (const PlacedLoad& load : loads) {
      keep[static_cast<std::size_t>(load.part)][static_cast<std::size_t>(load.point)] = true;
    }
    for (std::size_t part = 0; part < skeletons_.size(); ++part) {
      simplify(skeletons_[part], keep[part]);
    }
  }

  [[nodiscard]] int pointOf(int part, int feature, int slot) const {
    return skeletons_[static_cast<std::size_t>(part)]
        .pointOfSlot[static_cast<std::size_t>(feature)][static_cast<std::size_t>(slot)];
  }

  //! The node of a point; made when it is first asked for.
  int nodeOf(int part, int point) {
    const auto [entry, isNew] =
        nodes_.emplace(std::pair{part, point}, static_cast<int>(result_.frame.nodes.size()));
    if (isNew) {
      const auto p = static_cast<std::size_t>(part);
      const Vec3 at = skeletons_[p].points[static_cast<std::size_t>(point)];
      result_.frame.nodes.push_back(kMillimetresPerModule * scene_.model->parts[p].pose.apply(at));
      result_.nodesOfPart[p].push_back(entry->second);
    }
    return entry->second;
  }

  int sectionOf(const SkeletonEdge& edge) {
    const bool body = edge.kind == StretchKind::kBody;
    const std::pair<int, std::pair<double, double>> key{
        static_cast<int>(edge.kind),
        body ? std::pair{edge.width, edge.depth} : std::pair{0.0, 0.0}};
    const auto [entry, isNew] =
        sections_.emplace(key, static_cast<int>(result_.frame.sections.size()));
    if (isNew) {
      result_.frame.sections.push_back(
          body ? beamSection(edge.width, edge.depth)
               : (edge.kind == StretchKind::kPin ? pinSection() : axleSection()));
    }
    return entry->second;
  }

  void addPart(std::size_t part) {
    const int index = static_cast<int>(part);
    result_.nodesOfPart.emplace_back();
    const lattice::Pose& pose = scene_.model->parts[part].pose;
    for (const SkeletonEdge& edge : skeletons_[part].edges) {
      FrameElement element;
      element.a = nodeOf(index, edge.a);
      element.b = nodeOf(index, edge.b);
      element.up = pose.rotation * edge.up;
      element.section = sectionOf(edge);
      element.part = index;
      element.head = edge.kind != StretchKind::kBody;
      result_.frame.elements.push_back(element);
    }
    if (skeletons_[part].edges.empty()) {
      nodeOf(index, 0);
    }
  }

  void addFit(const Connection& c, int index) {
    if (!isGood(c.fit)) {
      return;
    }
    const auto male = static_cast<std::size_t>(c.male);
    const auto female = static_cast<std::size_t>(c.female);
    const parts::Feature& head =
        scene_.parts[male].part->features[static_cast<std::size_t>(c.maleFeature)];
    const parts::Feature& hole =
        scene_.parts[female].part->features[static_cast<std::size_t>(c.femaleFeature)];
    const double modules = std::min(head.length / static_cast<double>(head.slots.size()),
                                    hole.length / static_cast<double>(hole.slots.size()));
    const double length = modules * kMillimetresPerModule;
    const Play play =
        idleHolds_[static_cast<std::size_t>(index)] ? Play{} : playUnder(options_.friction, c);
    const double across = fitStiffness(length);
    const double rocking = fitRockingStiffness(length);
    const double along = play.shifts ? 0.0 : across;
    double turning = play.turns ? 0.0 : options_.heldStiffness;
    if (c.fit == Fit::kRigid) {
      // The wings bear on the sides of the cross hole, on average a quarter of their span away.
      turning = across * kAxleAcross * kAxleAcross / 16.0;
    }
    FrameSpring spring;
    spring.a = nodeOf(c.male, pointOf(c.male, c.maleFeature, c.maleSlot));
    spring.b = nodeOf(c.female, pointOf(c.female, c.femaleFeature, c.femaleSlot));
    spring.at = kMillimetresPerModule * c.at;
    spring.axes =
        axesAlong(lattice::normalized(scene_.model->parts[female].pose.rotation * hole.axis));
    spring.stiffness = {along, across, across, turning, rocking, rocking};
    result_.frame.springs.push_back(spring);
    result_.connectionOfSpring.push_back(index);
  }

  [[nodiscard]] Play playUnder(FitHold hold, const Connection& c) const {
    switch (hold) {
      case FitHold::kFree:
        return playOf(scene_, c, Friction::kFree);
      case FitHold::kHeld:
        return playOf(scene_, c, Friction::kHeld);
      case FitHold::kLocked:
        break;
    }
    return {};
  }

  void addWeights() {
    std::vector<double> lengths(scene_.parts.size(), 0.0);
    for (const FrameElement& element : result_.frame.elements) {
      lengths[static_cast<std::size_t>(element.part)] += lengthOf(result_.frame, element);
    }
    for (FrameElement& element : result_.frame.elements) {
      const auto part = static_cast<std::size_t>(element.part);
      element.load = {0, 0, -weightOf(part) / lengths[part]};
    }
    for (std::size_t part = 0; part < lengths.size(); ++part) {
      result_.weight += weightOf(part);
      if (lengths[part] == 0.0) {
        result_.frame.loads[static_cast<std::size_t>(result_.nodesOfPart[part].front())][2] -=
            weightOf(part);
      }
    }
  }

  [[nodiscard]] double weightOf(std::size_t part) const {
    return scene_.parts[part].part->mass / kGramsPerKilogram * kGravity;
  }

  void addLoad(const PlacedLoad& load) {
    const int node = nodeOf(load.part, load.point);
    const auto n = static_cast<std::size_t>(node);
    const Vec3 arm = kMillimetresPerModule * load.at - result_.frame.nodes[n];
    const Vec3 moment = lattice::cross(arm, load.force);
    Six& total = result_.frame.loads[n];
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      total[k] += load.force[i];
      total[3 + k] += moment[i];
    }
  }

  const Scene& scene_;
  const StressOptions& options_;
  std::vector<bool> idleHolds_;
  FrameModel result_;
  std::vector<Skeleton> skeletons_;
  std::map<std::pair<int, int>, int> nodes_;  // by part and point
  std::map<std::pair<int, std::pair<double, double>>, int> sections_;
};

}  // namespace

base::Result<FrameModel> makeFrameModel(const Scene& scene, const StressOptions& options) {
  return Builder(scene, options).build();
}

}  // namespace liftarm::analysis
