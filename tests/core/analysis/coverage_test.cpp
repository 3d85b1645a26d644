#include "analysis/coverage.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/scene.h"
#include "core/helpers/four_bars.h"
#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using testing::kY;

//! Turns a straight beam along x, its holes along y.
const lattice::Mat3 kAlongX = lattice::fromColumns({0, 0, -1}, {1, 0, 0}, kY);

TEST(CountGaps, LeavesOutAnotherLinesBeamBesideABridgedEdge) {
  // Edge 1 goes on from the node at x = 1, where the first line's beam lies on layer 0. The beam
  // of the third line, three layers off, passes there too.
  model::Model model;
  for (const double y : {0.0, -3.0}) {
    model.parts.push_back({"32523", 71, {{1, y, 0}, kAlongX}, -1, 0, 0});
  }
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  std::vector<EdgeCover> coverage{{0, 0, {0, 0, 0}, {1, 0, 0}, {{0, 0.0, kY, true}}},
                                  {1, 0, {1, 0, 0}, {2, 0, 0}, {{1, -3.0, kY, false}}},
                                  {2, 0, {2, -4, 0}, {3, -4, 0}, {{1, 1.0, kY, true}}}};
  EXPECT_EQ(countGaps(scene, coverage), 0);
  coverage[2].covers[0].said = false;  // now it may be either line's
  EXPECT_GT(countGaps(scene, coverage), 0);
}

TEST(CountGaps, LeavesOutABeamWithoutAHoleThere) {
  // A frame's side along x, its normal along z: at x = 0 its hole goes along y.
  model::Model model;
  const lattice::Mat3 turned = lattice::fromColumns({0, -1, 0}, {1, 0, 0}, {0, 0, 1});
  model.parts.push_back({"64179", 71, {{0, -2, 0}, turned}, -1, 0, 0});
  for (const double z : {1.0, -1.0}) {
    model.parts.push_back({"32523",
                           71,
                           {{0, 0, z}, lattice::fromColumns({1, 0, 0}, {0, 1, 0}, {0, 0, 1})},
                           -1,
                           0,
                           0});
  }
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  const lattice::Vec3 up{0, 0, 1};
  std::vector<EdgeCover> coverage{{0, 0, {0, 0, 0}, {1, 0, 0}, {{0, 0.0, up, true}}},
                                  {1, 0, {0, 0, 0}, {0, 1, 0}, {{1, 1.0, up, true}}}};
  EXPECT_EQ(countGaps(scene, coverage), 0);
  coverage.push_back({2, 0, {0, -1, 0}, {0, 0, 0}, {{2, -1.0, up, true}}});
  EXPECT_EQ(countGaps(scene, coverage), 1);  // no pin passes the frame between them
}

//! Two posts at x = 0 and 1 whose feet a line joins that no beam covers, and a double pin through
//! both three modules above it: just the reach of a bridge.
struct BridgedFeet {
  BridgedFeet() {
    const lattice::Mat3 upright = lattice::fromColumns({-1, 0, 0}, {0, 0, 1}, kY);
    for (const double x : {0.0, 1.0}) {
      model.parts.push_back({"32316", 71, {{x, 0, 2}, upright}, -1, 0, 0});
    }
    const lattice::Mat3 across = lattice::fromColumns(kY, {0, 0, 1}, {1, 0, 0});
    model.parts.push_back({"32138", 71, {{0.5, 1, 3}, across}, -1, 0, 0});
    sketch.lines = {{{0, 0, 0}, {1, 0, 0}, 1, false, {}},
                    {{0, 0, 0}, {0, 0, 4}, 4, false, {}},
                    {{1, 0, 0}, {1, 0, 4}, 4, false, {}}};
  }

  [[nodiscard]] ItemResult checkMoved(const lattice::Pose& motion) const {
    model::Model moved = model;
    for (model::PlacedPart& part : moved.parts) {
      part.pose = testing::after(motion, part.pose);
    }
    Scene scene = makeScene(moved, parts::Catalogue::builtIn());
    scene.sketch = sketch;
    for (sketch::Line& line : scene.sketch->lines) {
      line.from = motion.apply(line.from);
      line.to = motion.apply(line.to);
    }
    return checkCoverage(scene, findCoverage(scene));
  }

  model::Model model;
  sketch::Sketch sketch;
};

TEST(CheckCoverage, BridgesAtJustTheReachWhereverThatStands) {
  const BridgedFeet feet;
  ASSERT_TRUE(feet.checkMoved({}).problems.empty()) << feet.checkMoved({}).problems[0].message;
  for (int k = 0; k < 40; ++k) {
    const double turn = 0.1 * k;
    const lattice::Vec3 x{std::cos(turn), 0, std::sin(turn)};
    const lattice::Vec3 z{-std::sin(turn), 0, std::cos(turn)};
    const lattice::Pose motion{{33.0 / (k + 1), k / 3.0, 0.7 * k}, lattice::fromColumns(x, kY, z)};
    EXPECT_TRUE(feet.checkMoved(motion).problems.empty()) << "motion " << k;
  }
}

}  // namespace
}  // namespace liftarm::analysis
