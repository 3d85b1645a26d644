#include "layout/frame_beam.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace liftarm::layout {
namespace {

using lattice::Vec3;
using parts::FeatureKind;

const parts::Part& partOf(const FrameBeam& frame) {
  return *parts::Catalogue::builtIn().find(frame.part);
}

TEST(FrameBeams, AreTheHAndTheTwoWithAnOpenMiddle) {
  std::vector<std::string> parts;
  for (const FrameBeam& frame : frameBeams()) {
    parts.push_back(frame.part);
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"14720", "64178", "64179"}));
}

TEST(FrameBeams, HaveTheHolesOfTheirPart) {
  for (const FrameBeam& frame : frameBeams()) {
    const parts::Part& part = partOf(frame);
    const Vec3 normal = part.solid.front().axis;
    std::size_t nodes = 0;
    for (const FrameBar& bar : frame.bars) {
      for (int i = 0; i < bar.nodes; ++i) {
        const Vec3 at = bar.from + static_cast<double>(i) * bar.direction;
        const bool crossed = (bar.crossed >> static_cast<unsigned>(i) & 1U) != 0U;
        const Vec3 axis = crossed ? lattice::cross(bar.direction, normal) : normal;
        EXPECT_TRUE(std::any_of(part.features.begin(),
                                part.features.end(),
                                [&](const auto& hole) {
                                  return hole.kind == FeatureKind::kPinHole &&
                                         lattice::length(hole.center - at) < 0.01 &&
                                         std::abs(lattice::dot(hole.axis, axis)) > 0.99;
                                }))
            << part.id << " node " << i;
      }
      nodes += static_cast<std::size_t>(bar.nodes);
    }
    EXPECT_EQ(nodes - frame.crossings.size(), part.features.size()) << part.id;
  }
}

TEST(FrameBeams, CrossAtRightAnglesWhereBothBarsHaveTheHole) {
  for (const FrameBeam& frame : frameBeams()) {
    for (const FrameCrossing& crossing : frame.crossings) {
      const FrameBar& a = frame.bars[static_cast<std::size_t>(crossing.barA)];
      const FrameBar& b = frame.bars[static_cast<std::size_t>(crossing.barB)];
      EXPECT_NEAR(lattice::dot(a.direction, b.direction), 0.0, 1e-9) << frame.part;
      EXPECT_LT(lattice::length(a.from + static_cast<double>(crossing.nodeA) * a.direction -
                                b.from - static_cast<double>(crossing.nodeB) * b.direction),
                1e-6)
          << frame.part;
    }
  }
}

TEST(FrameBeams, AreNoPartsWhoseSolidHasMoreThanTheirBars) {
  parts::Part part = *parts::Catalogue::builtIn().find("64179");
  ASSERT_EQ(frameBeamsOf({part}).size(), 1U);
  part.solid.push_back(part.solid.front());
  part.solid.back().to = part.solid.back().from;
  EXPECT_TRUE(frameBeamsOf({part}).empty());
}

TEST(FrameBeams, AreNoPartsWithANodeWithoutAHole) {
  parts::Part part = *parts::Catalogue::builtIn().find("14720");
  part.features.pop_back();
  EXPECT_TRUE(frameBeamsOf({part}).empty());
}

}  // namespace
}  // namespace liftarm::layout
