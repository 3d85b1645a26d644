#include "analysis/drive_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "analysis/motion_collisions.h"
#include "base/index.h"
#include "model/number_text.h"
#include "parts/gear_teeth.h"
#include "sketch/shaft_json.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;

constexpr double kPi = 3.14159265358979323846;
constexpr int kSteps = 24;          // over a turn of the slowest shaft of a train
constexpr double kRounding = 1e-9;  // of a ratio
constexpr double kOnEnd = 0.1;      // modules

class DriveJudge {
 public:
  DriveJudge(const Scene& scene, const GearTrains& trains)
      : scene_(scene), trains_(trains), shafts_(sketch::shaftsOf(scene.model->sketchJson)) {}

  ItemResult judge() {
    std::vector<std::optional<int>> axles;
    for (std::size_t i = 0; i < shafts_.shafts.size(); ++i) {
      axles.push_back(axleAlong(scene_, shafts_.shafts[i]));
      judgeShaft(static_cast<int>(i), axles.back());
    }
    int turning = 0;
    for (std::size_t i = 0; i < shafts_.drives.size(); ++i) {
      turning += judgeDrive(static_cast<int>(i), axles) ? 1 : 0;
    }
    judgeGears();
    if (result_.problems.empty()) {
      turnAll();
    }
    if (!shafts_.drives.empty()) {
      result_.detail = std::to_string(result_.problems.empty() ? turning : 0) + " of " +
                       std::to_string(shafts_.drives.size()) + " drives turn";
    }
    return std::move(result_);
  }

 private:
  void fail(const std::string& message, Vec3 place, std::vector<int> parts) {
    result_.problems.push_back({"drive", message, place, std::move(parts)});
  }

  //! The shaft with gears that an axle belongs to.
  [[nodiscard]] const GearShaft* shaftWith(std::optional<int> axle) const {
    for (const GearShaft& shaft : trains_.shafts) {
      if (axle.has_value() && std::binary_search(shaft.parts.begin(), shaft.parts.end(), *axle)) {
        return &shaft;
      }
    }
    return nullptr;
  }

  void judgeShaft(int index, std::optional<int> axle) {
    const std::string place = "shafts[" + std::to_string(index) + "]: ";
    const Vec3 from = lattice::toVec3(shafts_.shafts[at(index)].from);
    if (!axle.has_value()) {
      return fail(place + "no axle lies along it", from, {});
    }
    int bearings = 0;
    bool held = false;
    for (const model::Connection& c : scene_.connections) {
      const bool round = c.fit == model::Fit::kTurn || c.fit == model::Fit::kSlide;
      bearings += c.male == *axle && round ? 1 : 0;
      held = held || (c.male == *axle && c.fit == model::Fit::kTurn);
    }
    judgeEnd(index, *axle, shafts_.shafts[at(index)].atFrom, shafts_.shafts[at(index)].from);
    judgeEnd(index, *axle, shafts_.shafts[at(index)].atTo, shafts_.shafts[at(index)].to);
    if (bearings < 2) {
      fail(place + "its axle runs in fewer than two holes", from, {*axle});
    } else if (!held) {
      fail(place + "its axle can slide out", from, {*axle});
    }
  }

  //! What is drawn at an end sits on the axle, within a module of that end.
  void judgeEnd(int index, int axle, sketch::ShaftEnd what, lattice::Cell end) {
    if (what == sketch::ShaftEnd::kNothing) {
      return;
    }
    const bool crank = what == sketch::ShaftEnd::kCrank;
    const Vec3 place = lattice::toVec3(end);
    const bool sits = std::any_of(
        scene_.connections.begin(), scene_.connections.end(), [&](const model::Connection& c) {
          return c.male == axle && c.fit == model::Fit::kRigid &&
                 scene_.model->parts[at(c.female)].part ==
                     (crank ? parts::kCrankArm : parts::kWheel) &&
                 lattice::length(c.at - place) < 1.0 + kOnEnd;
        });
    if (!sits) {
      fail("shafts[" + std::to_string(index) + "]: no " + (crank ? "crank" : "wheel") +
               " sits at its end",
           place,
           {axle});
    }
  }

  bool judgeDrive(int index, const std::vector<std::optional<int>>& axles) {
    const sketch::Drive& drive = shafts_.drives[at(index)];
    const std::string place = "drives[" + std::to_string(index) + "]: ";
    const Vec3 from = lattice::toVec3(shafts_.shafts[at(drive.from)].from);
    const GearShaft* a = shaftWith(axles[at(drive.from)]);
    const GearShaft* b = shaftWith(axles[at(drive.to)]);
    if (a == nullptr || b == nullptr || a->train != b->train) {
      fail(place + "no gears couple its shafts", from, {});
      return false;
    }
    const double ratio = std::abs(a->speed / b->speed);
    if (std::abs(ratio / drive.ratio - 1.0) > drive.tolerance / 100.0 + kRounding) {
      fail(place + "its ratio is " + model::numberText(ratio, 3) + ", not " +
               model::numberText(drive.ratio, 3) + " within " +
               model::numberText(drive.tolerance, 1) + " %",
           from,
           {});
      return false;
    }
    return true;
  }

  //! Gears that lock each other, and shafts that cannot turn.
  void judgeGears() {
    for (const int mesh : trains_.binding) {
      tell(trains_.meshes[at(mesh)].a,
           trains_.meshes[at(mesh)].b,
           " bind: other gears ask their shafts for another ratio");
    }
    for (const auto& [a, b] : trains_.clashes) {
      tell(a, b, " are too near to pass each other and do not mesh");
    }
    for (const GearShaft& shaft : trains_.shafts) {
      const bool meshes =
          std::any_of(trains_.meshes.begin(), trains_.meshes.end(), [&](const GearMesh& mesh) {
            return &trains_.shafts[at(mesh.shaftA)] == &shaft ||
                   &trains_.shafts[at(mesh.shaftB)] == &shaft;
          });
      if (meshes && !shafts_.drives.empty() && (!shaft.turns || !shaft.held)) {
        fail(nameOf(scene_, shaft.parts.front()) +
                 (shaft.turns ? ": its shaft can slide" : ": its shaft cannot turn"),
             shaft.at,
             shaft.parts);
      }
    }
  }

  void tell(int a, int b, const std::string& what) {
    fail(nameOf(scene_, a) + " and " + nameOf(scene_, b) + what,
         scene_.model->parts[at(a)].pose.position,
         {a, b});
  }

  //! Turns each train once round by its slowest shaft.
  void turnAll() {
    if (shafts_.empty()) {
      return;
    }
    std::vector<int> bodyOf(scene_.parts.size(), 0);
    std::vector<double> slowest(at(trains_.trains), 0.0);
    for (std::size_t s = 0; s < trains_.shafts.size(); ++s) {
      const GearShaft& shaft = trains_.shafts[s];
      for (const int part : shaft.parts) {
        bodyOf[at(part)] = static_cast<int>(s) + 1;
      }
      double& least = slowest[at(shaft.train)];
      least = least == 0.0 ? std::abs(shaft.speed) : std::min(least, std::abs(shaft.speed));
    }
    MotionCollisions collisions(scene_, bodyOf);
    for (int step = 1; step < kSteps; ++step) {
      std::vector<lattice::Pose> poses(trains_.shafts.size() + 1);
      for (std::size_t s = 0; s < trains_.shafts.size(); ++s) {
        const GearShaft& shaft = trains_.shafts[s];
        const double turns = static_cast<double>(step) / kSteps * shaft.speed;
        poses[s + 1] = turned(shaft, 2.0 * kPi * turns / slowest[at(shaft.train)]);
      }
      if (const auto hit = collisions.find(poses)) {
        return tell(hit->first, hit->second, " run into each other when the shafts turn");
      }
    }
  }

  const Scene& scene_;
  const GearTrains& trains_;
  sketch::Shafts shafts_;
  ItemResult result_;
};

}  // namespace

ItemResult checkDrives(const Scene& scene, const GearTrains& trains) {
  return DriveJudge(scene, trains).judge();
}

}  // namespace liftarm::analysis
