#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/joint_motion.h"
#include "core/helpers/four_bars.h"

namespace liftarm::analysis {
namespace {

using lattice::Pose;
using lattice::Vec3;
using testing::ClosedRange;
using testing::FourBar;

constexpr double kSameDegrees = 0.5;  // degrees

parts::Feature feature(parts::FeatureKind kind, Vec3 at, double length) {
  parts::Feature result;
  result.kind = kind;
  result.center = at;
  result.axis = {0, 0, 1};
  result.length = length;
  for (double z = 0.5 * (1 - length); z < 0.5 * length; z += 1) {
    result.slots.push_back(at + Vec3{0, 0, z});
  }
  return result;
}

//! Four bars of any lengths and a pin of two modules, none of which takes up space.
parts::Catalogue barsAndPin(const FourBar& linkage) {
  std::vector<parts::Part> all;
  for (std::size_t i = 0; i < 4; ++i) {
    parts::Part bar;
    bar.id = "bar" + std::to_string(i);
    bar.partClass = parts::PartClass::kBeam;
    bar.mass = 1;
    bar.features = {feature(parts::FeatureKind::kPinHole, {}, 1),
                    feature(parts::FeatureKind::kPinHole, {linkage.lengths[i], 0, 0}, 1)};
    all.push_back(bar);
  }
  parts::Part pin;
  pin.id = "pin";
  pin.partClass = parts::PartClass::kPin;
  pin.features = {feature(parts::FeatureKind::kPin, {}, 2)};
  all.push_back(pin);
  return parts::Catalogue(all);
}

//! A four-bar somewhere in space, drawn with a joint between bar `joint - 1` and bar `joint`.
struct BarStage {
  BarStage(const FourBar& linkage, std::size_t joint, const Pose& motion)
      : catalogue(barsAndPin(linkage)) {
    const auto place = [&](std::size_t i) { return linkage.pivots[i % 4]; };
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 along = lattice::normalized(place(i + 1) - place(i));
      const Pose bar{place(i) + Vec3{0, 0, i % 2 == 0 ? 0.0 : 1.0},
                     lattice::fromColumns(along, lattice::cross({0, 0, 1}, along), {0, 0, 1})};
      addPart("bar" + std::to_string(i), testing::after(motion, bar));
      Cover cover;
      cover.part = static_cast<int>(i);
      edges.push_back({cover.part, 0, motion.apply(place(i)), motion.apply(place(i + 1)), {cover}});
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Pose pin{place(i) + Vec3{0, 0, 0.5}, {}};
      addPart("pin", testing::after(motion, pin));
    }
    scene = makeScene(model, catalogue);
    for (ScenePart& part : scene.parts) {
      part.shapes.clear();  // nothing is in the way
      part.box = {};
    }
    const int before = static_cast<int>((joint + 3) % 4);
    scene.sketch = sketch::Sketch{};
    scene.sketch->lines.resize(4);
    scene.sketch->joints.push_back({motion.apply(place(joint)),
                                    motion.rotation * Vec3{0, 0, 1},
                                    {{before}, {static_cast<int>(joint)}}});
  }

  void addPart(const std::string& id, const Pose& pose) {
    model.parts.emplace_back();
    model.parts.back().part = id;
    model.parts.back().pose = pose;
  }

  parts::Catalogue catalogue;
  model::Model model;
  std::vector<EdgeCover> edges;
  Scene scene;
};

//! Lengths of 2 to 15 modules, standing at least two degrees from every dead point.
FourBar randomFourBar(base::Rng& rng) {
  for (;;) {
    std::array<double, 4> lengths{};
    for (double& length : lengths) {
      length = 2 + 13 * rng.unit();
    }
    const std::optional<FourBar> linkage = FourBar::at(lengths, 0.1 + 2.9 * rng.unit());
    bool clear = linkage.has_value();
    for (std::size_t i = 0; i < 4 && clear; ++i) {
      const ClosedRange range = closedRange(*linkage, i);
      clear = range.from < -2 && range.to > 2;
    }
    if (clear) {
      return *linkage;
    }
  }
}

TEST(FourBars, TurnAsFarAsTheClosedFormSaysAnywhereInSpace) {
  base::Rng rng(1);
  int deadPoints = 0;
  for (std::size_t i = 0; i < 500; ++i) {
    const FourBar linkage = randomFourBar(rng);
    const std::size_t joint = i % 4;
    const BarStage stage(linkage, joint, testing::randomMotion(rng, 300));
    const JointRange found = JointMover(stage.scene, stage.edges).turnJoint(0).range;
    const ClosedRange expected = closedRange(linkage, joint);
    EXPECT_NEAR(found.from.degrees, expected.from, kSameDegrees) << i << ": " << found.message;
    EXPECT_NEAR(found.to.degrees, expected.to, kSameDegrees) << i << ": " << found.message;
    deadPoints += (expected.from > -180 ? 1 : 0) + (expected.to < 180 ? 1 : 0);
  }
  EXPECT_GT(deadPoints, 300) << "the draw has both kinds";
}

}  // namespace
}  // namespace liftarm::analysis
