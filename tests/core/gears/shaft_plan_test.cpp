#include "gears/shaft_plan.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "sketch/shaft_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::gears {
namespace {

//! Two plates of one beam each, a cross beam between their ends.
const char* const kPlates = R"({"format": "technic-sketch", "version": 2,
  "lines": [{"from": [0, 0, 0], "to": [14, 0, 0]}, {"from": [0, 4, 0], "to": [14, 4, 0]},
            {"from": [0, 0, 0], "to": [0, 4, 0]}],)";

base::Result<ShaftPlan> planOf(const std::string& members) {
  const std::string text = kPlates + members + "}";
  const auto sketch = sketch::readSketch(text);
  EXPECT_TRUE(sketch.ok()) << sketch.error().message;
  return planShafts(sketch.value(), sketch::shaftsOf(text));
}

std::string messageOf(const std::string& members) {
  const auto plan = planOf(members);
  return plan.ok() ? "" : plan.error().message;
}

//! Two shafts at x = a and b, and a drive between them.
std::string pair(int a, int b, const std::string& ratio) {
  const auto shaft = [](int x) {
    return R"({"from": [)" + std::to_string(x) + R"(, -1, 0], "to": [)" + std::to_string(x) +
           R"(, 5, 0]})";
  };
  return R"("shafts": [)" + shaft(a) + ", " + shaft(b) +
         R"(], "drives": [{"from": 0, "to": 1, "ratio": )" + ratio + "}]";
}

TEST(ShaftPlan, HoldsEachShaftOnBothSidesOfOneOfItsLines) {
  const auto plan = planOf(pair(4, 9, "15"));
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  ASSERT_EQ(plan.value().shafts.size(), 3U);
  for (const PlannedShaft& shaft : plan.value().shafts) {
    const auto takes = [&](int slot) {
      return std::any_of(shaft.seats.begin(), shaft.seats.end(), [slot](const Seat& seat) {
        return seat.slot == slot;
      });
    };
    EXPECT_TRUE(std::any_of(shaft.bearings.begin(), shaft.bearings.end(), [&](int bearing) {
      return takes(bearing - 1) && takes(bearing + 1);
    }));
    for (const Seat& seat : shaft.seats) {
      EXPECT_TRUE(seat.slot >= shaft.first && seat.slot <= shaft.last);
    }
  }
}

TEST(ShaftPlan, GivesShaftsInBetweenTheBearingsThatTheLinesHave) {
  const auto plan = planOf(pair(4, 9, "15"));
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  const PlannedShaft& between = plan.value().shafts.back();
  EXPECT_EQ(between.at.u, 0);  // on the height of the lines
  EXPECT_EQ(between.bearings, (std::vector<int>{0, 4}));
}

TEST(ShaftPlan, MakesBearingsExactLinesWithTheirHolesAlongTheShaft) {
  const auto plan = planOf(pair(4, 7, "5"));
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  const sketch::Sketch& searched = plan.value().sketch;
  EXPECT_TRUE(searched.lines[0].exact && searched.lines[1].exact);
  EXPECT_EQ(searched.lines[0].holeAxis, lattice::Axis::kY);
  EXPECT_FALSE(searched.lines[2].exact);
  EXPECT_FALSE(searched.keepOut.empty());
}

TEST(ShaftPlan, TurnsShaftsSoThatATeethMeetsAGap) {
  const auto plan = planOf(pair(4, 7, "5"));
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  // Shafts along y: the first of the two axes that follow is z, the second x. Where the gears meet,
  // seen from the first shaft, is +x.
  const double toothOfFirst = (M_PI / 2 - plan.value().shafts[0].phase) / (2 * M_PI / 8);
  const double toothOfSecond = (-M_PI / 2 - plan.value().shafts[1].phase) / (2 * M_PI / 40);
  const double sum = toothOfFirst + toothOfSecond;
  EXPECT_NEAR(std::abs(sum - std::round(sum)), 0.5, 1e-9);
}

TEST(ShaftPlan, PutsAWheelBeyondTheLastBearing) {
  const auto plan = planOf(R"("shafts": [{"from": [4, 0, 0], "to": [4, 4, 0], "atTo": "wheel"}])");
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  const PlannedShaft& shaft = plan.value().shafts.front();
  EXPECT_EQ(shaft.last, 5);
  EXPECT_EQ(shaft.seats.back().slot, 5);
  EXPECT_GT(shaft.seats.back().radius, 2.0);
}

TEST(ShaftPlan, PutsACrankWithItsHandleAtTheFirstEnd) {
  const auto plan =
      planOf(R"("shafts": [{"from": [4, -2, 0], "to": [4, 5, 0], "atFrom": "crank"}])");
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  const PlannedShaft& shaft = plan.value().shafts.front();
  ASSERT_EQ(shaft.handles.size(), 1U);
  EXPECT_EQ(shaft.handles[0].slot, -2);
  EXPECT_EQ(shaft.handles[0].side, -1);
}

TEST(ShaftPlan, SaysThatALineIsInTheWayOfAWheel) {
  const std::string between =
      R"("lines": [{"from": [0, 0, 0], "to": [14, 0, 0]}, {"from": [0, 2, 0], "to": [14, 2, 0]},
                   {"from": [5, 3, 0], "to": [5, 3, 6]}],
         "shafts": [{"from": [4, 0, 0], "to": [4, 2, 0], "atTo": "wheel"}]})";
  const std::string text = R"({"format": "technic-sketch", "version": 2, )" + between;
  const auto sketch = sketch::readSketch(text);
  ASSERT_TRUE(sketch.ok()) << sketch.error().message;
  const auto plan = planShafts(sketch.value(), sketch::shaftsOf(text));
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().message, "shafts[0]: a line is in the way of what turns at its end");
}

TEST(ShaftPlan, SaysWhichShaftRunsInTooFewLines) {
  EXPECT_EQ(messageOf(R"("shafts": [{"from": [4, -1, 0], "to": [4, 2, 0]}])"),
            "shafts[0]: runs in the holes of 1 lines; it needs two at least, each at one of its "
            "nodes");
}

TEST(ShaftPlan, SaysWhereLinesMeetInAShaftsWay) {
  EXPECT_EQ(messageOf(R"("shafts": [{"from": [14, -1, 0], "to": [14, 5, 0]},
                                    {"from": [0, -1, 0], "to": [0, 5, 0]}])"),
            "shafts[1]: lines[0] and lines[2] meet at (0, 0, 0); a shaft needs a hole of one line");
}

TEST(ShaftPlan, SaysThatNoGearsCouplePairs) {
  EXPECT_NE(messageOf(pair(4, 5, "7")).find("drives[0]: no gears couple shafts[0] and shafts[1]"),
            std::string::npos);
}

TEST(ShaftPlan, SaysThatAShaftIsCoupledAlready) {
  const std::string twice = pair(4, 7, "5");
  EXPECT_EQ(messageOf(twice.substr(0, twice.size() - 1) + R"(, {"from": 1, "to": 0, "ratio": 1}])"),
            "drives[1]: shafts[1] and shafts[0] are coupled already");
}

}  // namespace
}  // namespace liftarm::gears
