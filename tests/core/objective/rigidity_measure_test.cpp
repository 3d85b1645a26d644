#include "objective/rigidity_measure.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "layout/bent_beam.h"

namespace liftarm::objective {
namespace {

using lattice::Axis;
using lattice::Cell;
using layout::Cover;
using layout::JunctionState;
using testing::defaultTable;
using testing::graphOf;
using testing::LayoutBench;

//! The oriented one-part mechanism of this part that has heads in all these cells, placed there.
layout::PlacedMechanism placed(const std::string& part, const std::vector<Cell>& heads) {
  for (std::size_t id = 0; id < defaultTable().size(); ++id) {
    const mechanisms::OrientedMechanism& m = defaultTable().oriented(static_cast<int>(id));
    if (m.shape.parts.size() != 1 || m.shape.parts.front().id != part) {
      continue;
    }
    for (int anchor = 0; anchor < m.heads; ++anchor) {
      const Cell at = heads.front() - m.shape.cells[static_cast<std::size_t>(anchor)].at;
      const auto holds = [&](Cell cell) {
        return std::any_of(m.shape.cells.begin(),
                           m.shape.cells.begin() + m.heads,
                           [&](const auto& c) { return c.at + at == cell; });
      };
      if (std::all_of(heads.begin(), heads.end(), holds)) {
        return {static_cast<std::int32_t>(id), at};
      }
    }
  }
  ADD_FAILURE() << "no " << part << " fits there";
  return {};
}

int subsets(const sketch::Sketch& sketch,
            const std::vector<Cover>& covers,
            const std::vector<std::vector<layout::PlacedMechanism>>& mechanisms) {
  std::vector<JunctionState> junctions;
  for (const auto& list : mechanisms) {
    junctions.emplace_back();
    junctions.back().connection.mechanisms = list;
  }
  return countRigidSubsets(graphOf(sketch), defaultTable(), covers, junctions);
}

TEST(RigidityMeasure, BeamsWithoutConnectionAreApart) {
  EXPECT_EQ(subsets(testing::lineSketch(8), {{Axis::kZ, {{0, 5, 0}, {5, 4, 0}}}}, {}), 2);
}

TEST(RigidityMeasure, TwoAxlesHoldWhatOneLetsTurn) {
  const sketch::Sketch rails = testing::sketchFrom({{{0, 0, 0}, {4, 0, 0}},
                                                    {{0, 4, 0}, {4, 4, 0}},
                                                    {{0, 0, 0}, {0, 4, 0}},
                                                    {{4, 0, 0}, {4, 4, 0}}});
  std::vector<Cover> covers{
      {Axis::kY, {{0, 5, 0}}}, {Axis::kY, {{0, 5, 0}}}, {Axis::kZ, {}}, {Axis::kZ, {}}};
  EXPECT_EQ(subsets(rails, covers, {}), 2);
  covers[2].axle.part = layout::axlePartIndex("44294");
  covers[2].axle.start = -1;
  EXPECT_EQ(subsets(rails, covers, {}), 2);
  covers[3].axle = covers[2].axle;
  EXPECT_EQ(subsets(rails, covers, {}), 1);
}

TEST(RigidityMeasure, ABentBeamAndAFrameAreOneBody) {
  const LayoutBench corner(testing::cornerSketch(4));
  std::vector<layout::Bend> bends;
  layout::addBends(corner.problem.graph, layout::bentBeamIndex("32526"), 0, 1, 0, &bends);
  ASSERT_FALSE(bends.empty());
  EXPECT_EQ(
      subsets(
          testing::cornerSketch(4),
          {{Axis::kZ, {bends.front().arm}}, {Axis::kZ, {bends.front().mateArm}}, {Axis::kX, {}}},
          {}),
      1);
  const sketch::Sketch rectangle = testing::rectangleSketch(4, 6);
  const LayoutBench bench(rectangle);
  std::vector<Cover> covers(4);
  for (const layout::FrameSite& site : bench.problem.sites) {
    for (const layout::SiteArm& arm : site.arms) {
      if (site.arms.size() == 4) {
        covers[static_cast<std::size_t>(arm.run)] = {site.axis, {arm.beam}};
      }
    }
  }
  EXPECT_EQ(subsets(rectangle, covers, {}), 1);
}

TEST(RigidityMeasure, BeamsInLineOnOnePinTurn) {
  EXPECT_EQ(subsets(testing::lineSketch(8), {{Axis::kZ, {{0, 5, 0}, {4, 5, 1}}}}, {}), 2);
}

TEST(RigidityMeasure, BeamsInLineOnTwoPinsAreOne) {
  EXPECT_EQ(subsets(testing::lineSketch(8), {{Axis::kZ, {{0, 5, 0}, {3, 6, 1}}}}, {}), 1);
}

TEST(RigidityMeasure, ChainOfDoublyPinnedBeamsIsOne) {
  EXPECT_EQ(subsets(testing::lineSketch(12), {{Axis::kZ, {{0, 5, 0}, {3, 5, 1}, {6, 7, 0}}}}, {}),
            1);
}

TEST(RigidityMeasure, SquareOnSinglePinsHasFourSubsets) {
  LayoutBench bench(testing::squareSketch(8));
  layout::Layout layout(bench.problem, bench.solver);
  std::vector<Cover> covers;
  std::vector<JunctionState> junctions;
  for (int r = 0; r < 4; ++r) {
    const bool alongX = bench.problem.graph.runs[static_cast<std::size_t>(r)].direction.y == 0.0;
    covers.push_back({Axis::kZ, {{0, 9, alongX ? 0 : 1}}});
    layout.setCover(r, covers.back());
  }
  layout.settle();
  for (int j = 0; j < 4; ++j) {
    junctions.push_back(layout.junction(j));
  }
  EXPECT_EQ(countRigidSubsets(bench.problem.graph, defaultTable(), covers, junctions), 4);
}

TEST(RigidityMeasure, CornerConnectorWithTwoHeadsInEachBeamMakesThemOne) {
  const sketch::Sketch ell =
      testing::sketchFrom({{{0, -6, 0}, {0, 0, 0}}, {{0, 0, -6}, {0, 0, 0}}});
  EXPECT_EQ(subsets(ell,
                    {{Axis::kZ, {{0, 7, 1}}}, {Axis::kY, {{0, 7, 0}}}},
                    {{placed("55615", {{0, -3, 1}, {0, -1, 1}, {0, 0, -2}, {0, 0, 0}})}}),
            1);
}

TEST(RigidityMeasure, CornerConnectorWithOneHeadInABeamIsAHinge) {
  // The beam along y ends before the second head.
  const sketch::Sketch ell =
      testing::sketchFrom({{{0, -6, 0}, {0, 0, 0}}, {{0, 0, -6}, {0, 0, 0}}});
  EXPECT_EQ(subsets(ell,
                    {{Axis::kZ, {{4, 3, 1}}}, {Axis::kY, {{0, 7, 0}}}},
                    {{placed("55615", {{0, -3, 1}, {0, -1, 1}, {0, 0, -2}, {0, 0, 0}})}}),
            2);
}

TEST(RigidityMeasure, PinThroughThreeBeamsIsStillOneHinge) {
  const sketch::Sketch star = testing::sketchFrom(
      {{{-4, 0, 0}, {4, 0, 0}}, {{0, -4, 0}, {0, 4, 0}}, {{-4, 3, 0}, {4, -3, 0}}});
  EXPECT_EQ(subsets(star,
                    {{Axis::kZ, {{0, 9, -1}}}, {Axis::kZ, {{0, 9, 0}}}, {Axis::kZ, {{0, 11, 1}}}},
                    {{placed("6558", {{0, 0, -1}, {0, 0, 0}, {0, 0, 1}})}}),
            3);
}

TEST(RigidityMeasure, ConnectorThatHoldsOneHoleOfEachBeamIsAHinge) {
  // 87082 with a head in a beam on either side: both beams turn on its line.
  const sketch::Sketch pair =
      testing::sketchFrom({{{-4, 0, 0}, {4, 0, 0}}, {{0, -4, 0}, {0, 4, 0}}});
  EXPECT_EQ(subsets(pair,
                    {{Axis::kZ, {{0, 9, -1}}}, {Axis::kZ, {{0, 9, 1}}}},
                    {{placed("87082", {{0, 0, -1}, {0, 0, 1}})}}),
            2);
}

TEST(RigidityMeasure, OfNothingIsZero) {
  EXPECT_EQ(countRigidSubsets({}, defaultTable(), {}, {}), 0);
}

}  // namespace
}  // namespace liftarm::objective
