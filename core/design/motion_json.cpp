#include "design/motion_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/coverage.h"
#include "design/design_session.h"
#include "design/json_values.h"
#include "model/model_json.h"

namespace liftarm::design {

namespace {

using analysis::GroundPoint;
using analysis::Twist;
using lattice::Vec3;
using nlohmann::ordered_json;

ordered_json groundJson(GroundPoint p) {
  return ordered_json::array({rounded(p.x), rounded(p.y)});
}

//! The quaternion (x, y, z, w) of a rotation, from its largest component.
std::array<double, 4> quaternionOf(const lattice::Mat3& r) {
  const double trace = r.m[0] + r.m[4] + r.m[8];
  const std::array<double, 4> squares{
      1 + 2 * r.m[0] - trace, 1 + 2 * r.m[4] - trace, 1 + 2 * r.m[8] - trace, 1 + trace};
  const auto largest =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double root = std::sqrt(squares[largest]);
  const double xy = r.m[1] + r.m[3];
  const double xz = r.m[2] + r.m[6];
  const double yz = r.m[5] + r.m[7];
  const double wx = r.m[7] - r.m[5];
  const double wy = r.m[2] - r.m[6];
  const double wz = r.m[3] - r.m[1];
  const std::array<std::array<double, 4>, 4> products{{{squares[0], xy, xz, wx},
                                                       {xy, squares[1], yz, wy},
                                                       {xz, yz, squares[2], wz},
                                                       {wx, wy, wz, squares[3]}}};
  std::array<double, 4> q = products[largest];
  for (double& value : q) {
    value /= 2 * root;
  }
  return q;
}

bool rests(const Twist& twist) {
  return twist.linear == Vec3{} && twist.angular == Vec3{};
}

ordered_json motionsJson(const analysis::Freedoms& freedoms) {
  ordered_json motions = ordered_json::array();
  for (const analysis::FreeMotion& motion : freedoms.motions) {
    ordered_json parts = ordered_json::array();
    ordered_json velocities = ordered_json::array();
    for (std::size_t i = 0; i < motion.twists.size(); ++i) {
      const Twist& t = motion.twists[i];
      if (!rests(t)) {
        parts.push_back(i);
        velocities.push_back({rounded(t.linear.x),
                              rounded(t.linear.y),
                              rounded(t.linear.z),
                              rounded(t.angular.x),
                              rounded(t.angular.y),
                              rounded(t.angular.z)});
      }
    }
    motions.push_back({{"joint", motion.joint < 0 ? ordered_json() : ordered_json(motion.joint)},
                       {"parts", parts},
                       {"velocities", velocities}});
  }
  return motions;
}

ordered_json balanceJson(const analysis::Balance& balance) {
  ordered_json polygon = ordered_json::array();
  for (const GroundPoint p : balance.polygon) {
    polygon.push_back(groundJson(p));
  }
  return {{"stable", balance.stable},
          {"centre", pointJson(balance.centre)},
          {"polygon", polygon},
          {"ground", rounded(balance.ground)},
          {"margin", rounded(balance.margin)},
          {"tippingAngle", rounded(balance.tippingAngle)},
          {"direction", groundJson(balance.direction)}};
}

ordered_json jointsJson(const std::vector<analysis::JointRange>& joints) {
  ordered_json result = ordered_json::array();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const analysis::JointRange& range = joints[j];
    ordered_json row{{"index", j},
                     {"joint", range.joint},
                     {"turns", range.turns},
                     {"from", rounded(range.from.degrees)},
                     {"to", rounded(range.to.degrees)},
                     {"stoppedBy", {{"from", range.from.stoppedBy}, {"to", range.to.stoppedBy}}},
                     {"message", range.message}};
    if (range.pair.has_value()) {
      row["bodies"] = {range.pair->first, range.pair->second};
    }
    result.push_back(std::move(row));
  }
  return result;
}

//! Those trains that a person may want to turn: of two shafts and more, or drawn.
ordered_json trainsJson(const analysis::GearTrains& trains) {
  ordered_json result = ordered_json::array();
  for (int train = 0; train < trains.trains; ++train) {
    ordered_json shafts = ordered_json::array();
    bool wanted = false;
    for (const analysis::GearShaft& shaft : trains.shafts) {
      if (shaft.train == train) {
        wanted = wanted || !shafts.empty() || shaft.drawn.has_value();
        shafts.push_back({{"parts", shaft.parts},
                          {"drawn", shaft.drawn ? ordered_json(*shaft.drawn) : ordered_json()},
                          {"at", pointJson(shaft.at)},
                          {"axis", pointJson(shaft.axis)},
                          {"speed", shaft.speed}});
      }
    }
    if (wanted) {
      const std::string why = analysis::whyTrainIsStiff(trains, train);
      result.push_back({{"index", result.size()},
                        {"turns", why.empty()},
                        {"message", why},
                        {"shafts", std::move(shafts)}});
    }
  }
  return result;
}

//! Position and unit quaternion (x, y, z, w).
ordered_json poseJson(const lattice::Pose& pose) {
  const std::array<double, 4> q = quaternionOf(pose.rotation);
  return {rounded(pose.position.x),
          rounded(pose.position.y),
          rounded(pose.position.z),
          rounded(q[0]),
          rounded(q[1]),
          rounded(q[2]),
          rounded(q[3])};
}

ordered_json pathJson(int index, const analysis::JointMotion& motion) {
  ordered_json angles = ordered_json::array();
  for (const double degrees : motion.path.degrees) {
    angles.push_back(rounded(degrees));
  }
  ordered_json poses = ordered_json::array();
  for (const std::vector<lattice::Pose>& key : motion.path.poses) {
    ordered_json row = ordered_json::array();
    for (const lattice::Pose& pose : key) {
      row.push_back(poseJson(pose));
    }
    poses.push_back(row);
  }
  return {{"index", index},
          {"turns", motion.range.turns},
          {"message", motion.range.message},
          {"parts", motion.path.parts},
          {"angles", angles},
          {"poses", poses}};
}

ordered_json bracesJson(const std::vector<analysis::Brace>& braces) {
  ordered_json result = ordered_json::array();
  for (const analysis::Brace& brace : braces) {
    result.push_back({{"lines", brace.lines},
                      {"from", pointJson(brace.from)},
                      {"to", pointJson(brace.to)},
                      {"message", brace.message}});
  }
  return result;
}

ordered_json freedomsJson(const analysis::MotionReport& report) {
  return {{"free", report.free.internal},
          {"held", report.held.internal},
          {"expected", report.free.jointTurns.size()},
          {"beyondJoints", report.free.beyondJoints},
          {"heldBeyondJoints", report.held.beyondJoints},
          {"spinning", report.free.spinning}};
}

//! Reads a model and moves it. `move` gives nothing where there is no such index.
template <typename Move>
base::Result<std::string> moved(std::string_view modelJson, int index, const Move& move) {
  const base::Result<model::Model> model = model::readModel(modelJson);
  if (!model.ok()) {
    return model.error();
  }
  const analysis::Scene scene = analysis::makeScene(model.value(), parts::Catalogue::builtIn());
  const std::vector<analysis::EdgeCover> coverage = analysis::findCoverage(scene);
  const analysis::JointMover mover(scene, coverage);
  const std::optional<analysis::JointMotion> motion = index < 0 ? std::nullopt : move(mover, index);
  if (!motion.has_value()) {
    return base::Error{base::Status::kInvalidInput,
                       "the model has no motion with the number " + std::to_string(index)};
  }
  return pathJson(index, *motion).dump();
}

}  // namespace

ordered_json motionJson(const analysis::MotionReport& report) {
  ordered_json json{{"freedoms", freedomsJson(report)},
                    {"groups", report.free.groupOf},
                    {"motions", motionsJson(report.free)},
                    {"joints", jointsJson(report.joints)},
                    {"trains", trainsJson(report.trains)}};
  json["balance"] = report.balance ? balanceJson(*report.balance) : ordered_json();
  json["braces"] = bracesJson(report.braces);
  return json;
}

base::Result<std::string> analyseMotionJson(std::string_view modelJson) {
  const base::Result<model::Model> model = model::readModel(modelJson);
  if (!model.ok()) {
    return model.error();
  }
  const analysis::Scene scene = analysis::makeScene(model.value(), parts::Catalogue::builtIn());
  return motionJson(analysis::analyseMotion(scene, analysis::findCoverage(scene))).dump();
}

base::Result<std::string> jointMotionJson(std::string_view modelJson, int joint) {
  return moved(modelJson, joint, [](const analysis::JointMover& mover, int index) {
    return index < mover.joints() ? std::optional(mover.turnJoint(index)) : std::nullopt;
  });
}

base::Result<std::string> freeMotionJson(std::string_view modelJson, int motion) {
  return moved(modelJson, motion, [](const analysis::JointMover& mover, int index) {
    return index < static_cast<int>(mover.free().motions.size())
               ? std::optional(mover.follow(index))
               : std::nullopt;
  });
}

}  // namespace liftarm::design
