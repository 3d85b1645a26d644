#include "analysis/gear_trains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "analysis/union_find.h"
#include "base/det_math.h"
#include "base/index.h"
#include "parts/gear_teeth.h"
#include "sketch/shaft_json.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;

constexpr double kTeethPerModule = 16.0;
constexpr double kAddendum = 0.125;       // of teeth beyond the pitch circle
constexpr double kSamePlane = 0.5;        // modules along the shafts that gears in mesh are apart
constexpr double kParallelAxes = 0.9998;  // cosine
constexpr double kOnLine = 0.06;          // modules: as far as a head may be off its hole's line

//! A gear as it stands.
struct Wheel {
  int part = -1;
  int shaft = -1;
  int teeth = 0;
  Vec3 middle;
  Vec3 axis;

  [[nodiscard]] double pitch() const { return static_cast<double>(teeth) / kTeethPerModule; }
};

class TrainsFinder {
 public:
  explicit TrainsFinder(const Scene& scene)
      : scene_(scene), rigid_(scene.parts.size()), shaftOf_(scene.parts.size(), -1) {}

  GearTrains find() {
    findShafts();
    findMeshes();
    spreadSpeeds();
    return std::move(trains_);
  }

 private:
  void findShafts() {
    for (const model::Connection& c : scene_.connections) {
      if (c.fit == model::Fit::kRigid) {
        rigid_.join(c.male, c.female);
      }
    }
    std::map<int, int> shaftOfGroup;
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      if (teethOf(static_cast<int>(i)) > 0) {
        shaftOfGroup.emplace(rigid_.find(static_cast<int>(i)), 0);
      }
    }
    const sketch::Shafts drawn = sketch::shaftsOf(scene_.model->sketchJson);
    std::vector<std::optional<int>> axles;
    for (const sketch::Shaft& shaft : drawn.shafts) {
      axles.push_back(axleAlong(scene_, shaft));
      if (axles.back().has_value()) {
        shaftOfGroup.emplace(rigid_.find(*axles.back()), 0);
      }
    }
    int count = 0;
    for (auto& [group, shaft] : shaftOfGroup) {
      shaft = count++;
    }
    trains_.shafts.resize(at(count));
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      const auto found = shaftOfGroup.find(rigid_.find(static_cast<int>(i)));
      if (found != shaftOfGroup.end()) {
        shaftOf_[i] = found->second;
        trains_.shafts[at(found->second)].parts.push_back(static_cast<int>(i));
      }
    }
    takeHandles();
    for (std::size_t i = axles.size(); i-- > 0;) {
      if (axles[i].has_value()) {
        trains_.shafts[at(shaftOf_[at(*axles[i])])].drawn = static_cast<int>(i);
      }
    }
    for (std::size_t s = 0; s < trains_.shafts.size(); ++s) {
      measure(static_cast<int>(s), axles);
    }
  }

  //! Pins that hang on one shaft alone turn with it: handles of cranks.
  void takeHandles() {
    std::vector<std::set<int>> holders(scene_.parts.size());  // shafts, -1 for all else
    for (const model::Connection& c : scene_.connections) {
      if (model::isGood(c.fit)) {
        holders[at(c.male)].insert(shaftOf_[at(c.female)]);
        holders[at(c.female)].insert(shaftOf_[at(c.male)]);
      }
    }
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      const parts::Part* part = scene_.parts[i].part;
      const bool hangs = part != nullptr && part->partClass == parts::PartClass::kPin &&
                         holders[i].size() == 1 && *holders[i].begin() >= 0;
      if (hangs && shaftOf_[i] < 0) {
        std::vector<int>& parts = trains_.shafts[at(*holders[i].begin())].parts;
        parts.insert(std::lower_bound(parts.begin(), parts.end(), static_cast<int>(i)),
                     static_cast<int>(i));
        handles_.emplace_back(static_cast<int>(i), *holders[i].begin());
      }
    }
    for (const auto& [part, shaft] : handles_) {
      shaftOf_[at(part)] = shaft;
    }
  }

  [[nodiscard]] int teethOf(int part) const {
    const parts::Part* known = scene_.parts[at(part)].part;
    return known == nullptr ? 0 : parts::teethOf(*known);
  }

  [[nodiscard]] Wheel wheelOf(int part) const {
    // The solid of a gear is one disc: its middle and axis are the gear's.
    const parts::Prism& disc = scene_.parts[at(part)].part->solid.front();
    const lattice::Pose& pose = scene_.model->parts[at(part)].pose;
    return {part,
            shaftOf_[at(part)],
            teethOf(part),
            pose.apply(disc.from),
            lattice::normalized(pose.rotation * disc.axis)};
  }

  //! Axis, bearings and what keeps the shaft.
  void measure(int index, const std::vector<std::optional<int>>& axles) {
    GearShaft& shaft = trains_.shafts[at(index)];
    const auto gear = std::find_if(
        shaft.parts.begin(), shaft.parts.end(), [&](int part) { return teethOf(part) > 0; });
    if (gear != shaft.parts.end()) {
      const Wheel wheel = wheelOf(*gear);
      shaft.at = wheel.middle;
      shaft.axis = wheel.axis;
    } else {
      const std::size_t axle = at(*axles[at(*shaft.drawn)]);
      const parts::Feature& cross = scene_.parts[axle].part->features.front();
      const lattice::Pose& pose = scene_.model->parts[axle].pose;
      shaft.at = pose.apply(cross.center);
      shaft.axis = lattice::normalized(pose.rotation * cross.axis);
    }
    // Speeds of two shafts compare where their axes point the same way.
    const double sign = shaft.axis.x + shaft.axis.y + shaft.axis.z;
    shaft.axis = sign < 0.0 ? -shaft.axis : shaft.axis;
    shaft.turns = true;
    for (const model::Connection& c : scene_.connections) {
      const bool male = shaftOf_[at(c.male)] == index;
      if (male == (shaftOf_[at(c.female)] == index) || !model::isGood(c.fit)) {
        continue;
      }
      const Vec3 off = c.at - shaft.at;
      const bool onAxis =
          lattice::length(lattice::cross(off, shaft.axis)) < model::kCoaxialDistance;
      shaft.turns = shaft.turns && onAxis && male;
      shaft.bearings += onAxis ? 1 : 0;
      shaft.held = shaft.held || (onAxis && c.fit == model::Fit::kTurn);
    }
  }

  void findMeshes() {
    std::vector<Wheel> wheels;
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      if (teethOf(static_cast<int>(i)) > 0) {
        wheels.push_back(wheelOf(static_cast<int>(i)));
      }
    }
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      for (std::size_t j = i + 1; j < wheels.size(); ++j) {
        if (wheels[i].shaft != wheels[j].shaft) {
          compare(wheels[i], wheels[j]);
        }
      }
    }
  }

  void compare(const Wheel& p, const Wheel& q) {
    if (std::abs(lattice::dot(p.axis, q.axis)) < kParallelAxes) {
      return;
    }
    const Vec3 off = q.middle - p.middle;
    const double along = lattice::dot(off, p.axis);
    const double beyond = lattice::length(off - along * p.axis) - p.pitch() - q.pitch();
    if (std::abs(along) >= kSamePlane || beyond >= 2.0 * kAddendum) {
      return;
    }
    if (std::abs(beyond) > kPitchTolerance) {
      trains_.clashes.emplace_back(p.part, q.part);
      return;
    }
    const double way =
        lattice::dot(trains_.shafts[at(p.shaft)].axis, trains_.shafts[at(q.shaft)].axis) < 0.0
            ? 1.0
            : -1.0;
    trains_.meshes.push_back({p.part,
                              q.part,
                              p.shaft,
                              q.shaft,
                              way * static_cast<double>(p.teeth) / static_cast<double>(q.teeth)});
  }

  void spreadSpeeds() {
    std::vector<bool> known(trains_.shafts.size(), false);
    for (std::size_t root = 0; root < trains_.shafts.size(); ++root) {
      if (known[root]) {
        continue;
      }
      known[root] = true;
      trains_.shafts[root].train = trains_.trains++;
      for (bool changed = true; changed;) {
        changed = false;
        for (const GearMesh& mesh : trains_.meshes) {
          changed = spread(mesh, known) || changed;
        }
      }
    }
    for (std::size_t m = 0; m < trains_.meshes.size(); ++m) {
      const GearMesh& mesh = trains_.meshes[m];
      const double asked = trains_.shafts[at(mesh.shaftA)].speed * mesh.ratio;
      if (std::abs(trains_.shafts[at(mesh.shaftB)].speed - asked) > 1e-9 * std::abs(asked)) {
        trains_.binding.push_back(static_cast<int>(m));
      }
    }
  }

  bool spread(const GearMesh& mesh, std::vector<bool>& known) {
    if (known[at(mesh.shaftA)] == known[at(mesh.shaftB)]) {
      return false;
    }
    const bool forward = known[at(mesh.shaftA)];
    const GearShaft& from = trains_.shafts[at(forward ? mesh.shaftA : mesh.shaftB)];
    const int index = forward ? mesh.shaftB : mesh.shaftA;
    GearShaft& to = trains_.shafts[at(index)];
    to.speed = from.speed * (forward ? mesh.ratio : 1.0 / mesh.ratio);
    to.train = from.train;
    known[at(index)] = true;
    return true;
  }

  const Scene& scene_;
  UnionFind rigid_;
  std::vector<int> shaftOf_;                  // per part
  std::vector<std::pair<int, int>> handles_;  // part, shaft
  GearTrains trains_;
};

}  // namespace

std::optional<int> axleAlong(const Scene& scene, const sketch::Shaft& shaft) {
  const Vec3 from = lattice::toVec3(shaft.from);
  const Vec3 to = lattice::toVec3(shaft.to);
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const parts::Part* part = scene.parts[i].part;
    if (part == nullptr || part->partClass != parts::PartClass::kAxle) {
      continue;
    }
    const parts::Feature& axle = part->features.front();
    const lattice::Pose& pose = scene.model->parts[i].pose;
    const Vec3 middle = pose.apply(axle.center);
    const Vec3 along = lattice::normalized(pose.rotation * axle.axis);
    const auto onIt = [&](Vec3 p) {
      const double place = lattice::dot(p - middle, along);
      return lattice::length(p - middle - place * along) <= kOnLine &&
             std::abs(place) <= 0.5 * axle.length - 0.5 + kOnLine;
    };
    if (onIt(from) && onIt(to)) {
      return static_cast<int>(i);
    }
  }
  return std::nullopt;
}

std::string whyTrainIsStiff(const GearTrains& trains, int train) {
  const auto in = [&](int shaft) { return trains.shafts[at(shaft)].train == train; };
  for (const int mesh : trains.binding) {
    if (in(trains.meshes[at(mesh)].shaftA)) {
      return "Does not turn: its gears ask one shaft for two speeds.";
    }
  }
  const auto holds = [&](int part) {
    return std::any_of(trains.shafts.begin(), trains.shafts.end(), [&](const GearShaft& shaft) {
      return shaft.train == train &&
             std::binary_search(shaft.parts.begin(), shaft.parts.end(), part);
    });
  };
  for (const auto& [a, b] : trains.clashes) {
    if (holds(a) || holds(b)) {
      return "Does not turn: two gears are too near to pass each other and do not mesh.";
    }
  }
  const bool turns =
      std::all_of(trains.shafts.begin(), trains.shafts.end(), [&](const GearShaft& shaft) {
        return shaft.train != train || shaft.turns;
      });
  return turns ? "" : "Does not turn: more than its bearings holds one of its shafts.";
}

GearTrains findGearTrains(const Scene& scene) {
  return TrainsFinder(scene).find();
}

lattice::Pose turned(const GearShaft& shaft, double angle) {
  const double c = base::detCos(angle);
  const double s = base::detSin(angle);
  const Vec3 a = shaft.axis;
  const auto image = [&](Vec3 p) {
    return c * p + s * lattice::cross(a, p) + ((1.0 - c) * lattice::dot(a, p)) * a;
  };
  const lattice::Mat3 rotation =
      lattice::fromColumns(image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1}));
  return {shaft.at - rotation * shaft.at, rotation};
}

}  // namespace liftarm::analysis
