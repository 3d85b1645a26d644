#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "layout/layout.h"
#include "layout/stack.h"

namespace liftarm::layout {
namespace {

unsigned stackOf(std::initializer_list<int> layers) {
  unsigned bits = 0;
  for (const int layer : layers) {
    bits |= 1U << static_cast<unsigned>(layer + guide::kMaxLayer);
  }
  return bits;
}

//! Two lines that cross in their middles, in one plane, and what else is wanted.
sketch::Sketch crossing(const testing::Segments& more = {}) {
  testing::Segments lines{{{0, 4, 0}, {8, 4, 0}}, {{4, 0, 0}, {4, 8, 0}}};
  lines.insert(lines.end(), more.begin(), more.end());
  return testing::sketchFrom(lines);
}

//! One beam of nine holes on each of the two lines, on these layers.
void lay(Layout* layout, int first, int second) {
  layout->setCover(0, {lattice::Axis::kZ, {{0, 9, first}}});
  layout->setCover(1, {lattice::Axis::kZ, {{0, 9, second}}});
}

TEST(StackFaults, GapsCanBeFilledWhereOnePinOrAxleHoldsAll) {
  EXPECT_EQ(stackFaults(stackOf({0, 2})).fillable, 1);
  EXPECT_EQ(stackFaults(stackOf({-1, 2})).fillable, 2);
  EXPECT_EQ(stackFaults(stackOf({-1, 0, 2})).fillable, 1);
  EXPECT_EQ(stackFaults(stackOf({0, 1})).fillable, 0);
  EXPECT_EQ(stackFaults(stackOf({-2, 2})).fillable, 0);
  EXPECT_EQ(stackFaults(stackOf({-2, -1, 0, 2})).fillable, 0);
}

TEST(Spacers, FillAGapThatOnePinThenHolds) {
  testing::LayoutBench bench(crossing());
  Layout layout(bench.problem, bench.solver);
  lay(&layout, -1, 1);
  layout.settleAll();
  EXPECT_EQ(layout.tallies().violations(), 0);
  ASSERT_EQ(layout.junction(0).spacers.size(), 1U);
  EXPECT_EQ(layout.junction(0).spacers[0].layer, 0);
  EXPECT_EQ(layout.junction(0).connection.mechanisms.size(), 1U);
  EXPECT_EQ(layout.tallies().connectors, 2);
}

TEST(Spacers, AreNotUsedWhereTheyMayNotBe) {
  testing::LayoutBench bench(crossing());
  bench.problem.spacers = false;
  Layout layout(bench.problem, bench.solver);
  lay(&layout, -1, 1);
  layout.settleAll();
  EXPECT_EQ(layout.tallies().gaps, 1);
  EXPECT_TRUE(layout.junction(0).spacers.empty());
}

TEST(Spacers, DoNotEnterAPlaceThatABeamHas) {
  // The third line passes one module above the first two, where the spacer would be.
  testing::LayoutBench bench(crossing({{{0, 4, 1}, {8, 4, 1}}}));
  Layout layout(bench.problem, bench.solver);
  lay(&layout, 0, 2);
  layout.setCover(2, {lattice::Axis::kY, {{0, 9, 0}}});
  layout.settleAll();
  ASSERT_EQ(layout.tallies().collisions, 0);
  EXPECT_EQ(layout.tallies().gaps, 1);
  EXPECT_TRUE(layout.junction(0).spacers.empty());
}

TEST(Spacers, LeaveGapsThatAreTooWide) {
  testing::LayoutBench bench(crossing());
  Layout layout(bench.problem, bench.solver);
  lay(&layout, -2, 2);
  layout.settleAll();
  EXPECT_EQ(layout.tallies().gaps, 3);
  EXPECT_TRUE(layout.junction(0).spacers.empty());
}

}  // namespace
}  // namespace liftarm::layout
