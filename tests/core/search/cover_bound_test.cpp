#include "search/cover_bound.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "core/helpers/shared_data.h"

namespace liftarm::search {
namespace {

AnnealingOptions straightOnly() {
  AnnealingOptions options;
  options.parts.corners = options.parts.frames = options.parts.axles = false;
  return options;
}

int boundOf(const sketch::Sketch& sketch, const AnnealingOptions& options = {}) {
  return coverLowerBound(
      makeCoverTable(layout::makeLayoutProblem(testing::graphOf(sketch)), options));
}

TEST(CoverBound, OfALongLineIsItsLengthOverFourteen) {
  EXPECT_EQ(boundOf(testing::lineSketch(14)), 1);
  EXPECT_EQ(boundOf(testing::lineSketch(15)), 2);
  EXPECT_EQ(boundOf(testing::lineSketch(29)), 3);
}

TEST(CoverBound, KnowsTheLengthsInUse) {
  AnnealingOptions options;
  options.lengths = {2, 3, 5};
  EXPECT_EQ(boundOf(testing::lineSketch(40), options), 10);
  options.lengths = {6};  // two parts each
  EXPECT_EQ(boundOf(testing::lineSketch(10), options), 4);
}

TEST(CoverBound, OfACubeOfStraightBeamsIsTwelve) {
  EXPECT_EQ(boundOf(testing::cubeSketch(8), straightOnly()), 12);
}

TEST(CoverBound, CountsPiecesTogether) {
  EXPECT_EQ(boundOf(testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{0, 50, 0}, {20, 50, 0}}})), 3);
}

TEST(CoverBound, NeedsOneWhereEveryEdgeCouldBeBridged) {
  EXPECT_EQ(boundOf(testing::cornerSketch(1), straightOnly()), 3);
}

TEST(CoverBound, IsAboutFramesAndBentBeamsToo) {
  EXPECT_EQ(boundOf(testing::rectangleSketch(4, 6)), 1);
  EXPECT_EQ(boundOf(testing::rectangleSketch(4, 6), straightOnly()), 4);
}

TEST(CoverBound, OfALineThatNothingCoversIsNothing) {
  AnnealingOptions options;
  options.lengths = {15};
  sketch::Sketch sketch = testing::lineSketch(5);
  sketch.lines[0].exact = true;
  EXPECT_EQ(boundOf(sketch, options), 0);
}

TEST(CoverBound, EqualsTheProvenOptimumOfTheGridPuzzleWithStraightBeams) {
  LIFTARM_NEED_SHARED_DATA();
  const auto text = testing::readSharedFile("grids.json");
  ASSERT_TRUE(text.has_value());
  const nlohmann::json grids = nlohmann::json::parse(*text, nullptr, false);
  ASSERT_TRUE(grids.is_object());
  for (const nlohmann::json& grid : grids["grids"]) {
    const int n = grid["n"].get<int>();
    EXPECT_EQ(boundOf(testing::gridSketch(n), straightOnly()), grid["straight"].get<int>()) << n;
  }
}

}  // namespace
}  // namespace liftarm::search
