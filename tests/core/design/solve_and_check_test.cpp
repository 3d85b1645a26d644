// One judge: what `solve` says of its model is what `check` says of the file, off the lattice too.

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/four_bars.h"
#include "core/helpers/sketches.h"
#include "core/helpers/solved.h"

namespace liftarm::design {
namespace {

using lattice::Vec3;
using nlohmann::json;

constexpr double kSixty = 1.0471975511965976;

//! Turned about y by an angle, then shifted.
sketch::Sketch moved(sketch::Sketch sketch, double angle, Vec3 shift) {
  const auto image = [&](Vec3 p) {
    return Vec3{std::cos(angle) * p.x + std::sin(angle) * p.z,
                p.y,
                std::cos(angle) * p.z - std::sin(angle) * p.x} +
           shift;
  };
  for (sketch::Line& line : sketch.lines) {
    line.from = image(line.from);
    line.to = image(line.to);
  }
  for (sketch::Joint& joint : sketch.joints) {
    joint.at = image(joint.at);
  }
  return sketch;
}

//! Lines end to end that close, with a joint about y where two of them meet.
sketch::Sketch hinged(const std::vector<Vec3>& corners) {
  testing::Segments lines;
  sketch::Sketch joints;
  const int count = static_cast<int>(corners.size());
  for (int i = 0; i < count; ++i) {
    lines.emplace_back(corners[static_cast<std::size_t>(i)],
                       corners[static_cast<std::size_t>((i + 1) % count)]);
    joints.joints.push_back(
        {corners[static_cast<std::size_t>(i)], {0, 1, 0}, {{(i + count - 1) % count}, {i}}});
  }
  sketch::Sketch sketch = testing::sketchFrom(lines);
  sketch.joints = joints.joints;
  return sketch;
}

sketch::Sketch openHinge() {
  const Vec3 knee{6 * std::cos(kSixty), 0, 6 * std::sin(kSixty)};
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, knee}, {knee, knee + Vec3{6, 0, 0}}});
  sketch.joints.push_back({knee, {0, 1, 0}, {{0}, {1}}});
  return sketch;
}

sketch::Sketch rhombus() {
  const Vec3 up{6 * std::cos(kSixty), 0, 6 * std::sin(kSixty)};
  return hinged({{0, 0, 0}, {6, 0, 0}, up + Vec3{6, 0, 0}, up});
}

sketch::Sketch fourBar() {
  const testing::FourBar linkage = testing::FourBar::at({12, 5, 11, 8}, 1.2).value();
  std::vector<Vec3> corners;
  for (const Vec3 p : linkage.pivots) {
    corners.push_back({p.x, 0, p.y});
  }
  return hinged(corners);
}

//! What turns, how far and why, as both say it.
std::string verdictOf(const json& report) {
  return report.at("items").dump(1) + report.at("problems").dump(1);
}

TEST(SolveAndCheck, SayTheSameOfJointsOffTheLattice) {
  for (const sketch::Sketch& drawn : {openHinge(), rhombus(), fourBar()}) {
    for (const double angle : {0.0, 0.4}) {
      const testing::Solved solved = testing::solve(moved(drawn, angle, {1.0 / 3, 0, 100 * angle}));
      const base::Result<std::string> checked = checkModelJson(solved.text);
      ASSERT_TRUE(checked.ok());
      EXPECT_EQ(verdictOf(solved.report), verdictOf(json::parse(checked.value())));
    }
  }
}

}  // namespace
}  // namespace liftarm::design
