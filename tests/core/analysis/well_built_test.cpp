#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/analysis/well_built_figures.h"
#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using model::Model;
using nlohmann::json;
using testing::beamAt;
using testing::figure;
using testing::figureOf;
using testing::itemOf;
using testing::judge;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::lights;
using testing::pinAt;

//! A square frame with one more part.
Model squareWith(const model::PlacedPart& part) {
  Model model = testing::squareFrame();
  model.parts.push_back(part);
  return model;
}

constexpr int kAdded = 8;  // its index

TEST(WellBuilt, OneBeamOnItsLineFulfilsAllSix) {
  Model model;
  model.parts = {beamAt("40490", {4, 0, 0}, kX, kZ)};
  model.sketchJson = testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}});
  for (const WellBuiltItem& item : judge(model)) {
    EXPECT_TRUE(item.ok) << item.id << ": " << item.detail;
  }
}

TEST(WellBuilt, ItemsComeInTheOrderOfTheDesign) {
  std::string ids;
  for (const WellBuiltItem& item : judge(testing::squareFrame())) {
    ids += item.id + " ";
  }
  EXPECT_EQ(ids, "faithful stands stiff clean symmetric few ");
}

TEST(WellBuilt, WithoutASketchOnlyThePartsAreJudged) {
  for (const WellBuiltItem& item : judge(testing::cornerOfTwoBeams())) {
    const bool needsNone = item.id == "stiff" || item.id == "clean" || item.id == "few";
    EXPECT_EQ(item.applies, needsNone) << item.id;
    EXPECT_TRUE(item.applies || item.ok) << item.id;
  }
}

// Clean.

TEST(WellBuiltClean, HeadsInHolesAreNotNaked) {
  EXPECT_EQ(figure(testing::squareFrame(), "clean", "nakedHeads"), 0);
  EXPECT_EQ(figure(testing::squareFrame(), "clean", "pinHeads"), 8);
}

TEST(WellBuiltClean, PinThatSticksOutIsFound) {
  const WellBuiltItem item = itemOf(squareWith(pinAt("2780", {4, 0, 0.5}, kZ)), "clean");
  EXPECT_EQ(figureOf(item, "nakedPinHeads"), 1);
  EXPECT_TRUE(lights(item, "nakedHead", kAdded));
  EXPECT_FALSE(item.ok);
}

TEST(WellBuiltClean, ThreeModulePinForTwoBeamsHasANakedHead) {
  Model model = testing::squareFrame();
  model.parts[4] = pinAt("6558", {0, 0, 1}, kZ);
  EXPECT_EQ(figure(model, "clean", "nakedPinHeads"), 1);
}

TEST(WellBuiltClean, HeadOfAConnectorBesideARemovedBeamIsNaked) {
  Model model = testing::cornerOfTwoBeams();
  const double before = figure(model, "clean", "nakedPinHeads");
  model.parts.pop_back();
  EXPECT_EQ(figure(model, "clean", "nakedPinHeads"), before + 2);
}

TEST(WellBuiltClean, ConnectorArmThatHoldsNothingIsToldApart) {
  Model model = testing::bridgedLine();
  const WellBuiltItem whole = itemOf(model, "clean");
  EXPECT_EQ(figureOf(whole, "arms"), 2);
  EXPECT_EQ(figureOf(whole, "idleArms"), 0);
  model.parts.pop_back();
  EXPECT_EQ(figure(model, "clean", "idleArms"), 1);
}

TEST(WellBuiltClean, AxleHasTwoEndsAndNoHeadsBetween) {
  const WellBuiltItem item = itemOf(testing::frameOfAxles(), "clean");
  EXPECT_EQ(figureOf(item, "axleEnds"), 4);
  EXPECT_EQ(figureOf(item, "nakedAxleEnds"), 0);
}

TEST(WellBuiltClean, AxleEndThatHoldsNothingIsFound) {
  EXPECT_EQ(figure(testing::squareWithAxle(), "clean", "nakedAxleEnds"), 1);
}

TEST(WellBuiltClean, AFewHeadsInAHundredAreForgiven) {
  Model model;
  for (int i = 0; i < 10; ++i) {
    for (model::PlacedPart part : testing::squareFrame().parts) {
      part.pose.position = part.pose.position + Vec3{0, 20.0 * i, 0};
      model.parts.push_back(part);
    }
  }
  model.parts.push_back(pinAt("2780", {4, 0, 0.5}, kZ));
  EXPECT_TRUE(itemOf(model, "clean").ok);
}

// Stiff.

TEST(WellBuiltStiff, SquareOnFourPinsFoldsButNoBeamHangsOnOneLine) {
  const WellBuiltItem item = itemOf(testing::squareFrame(), "stiff");
  EXPECT_EQ(figureOf(item, "freedomsBeyondJoints"), 1);
  EXPECT_EQ(figureOf(item, "beamsOnOneAxis"), 0);
  EXPECT_TRUE(lights(item, "freedom", 2) || lights(item, "freedom", 0));
  EXPECT_FALSE(item.ok);
}

TEST(WellBuiltStiff, BeamsOfARemovedPinTurnAboutOneLine) {
  Model model = testing::squareFrame();
  model.parts.erase(model.parts.begin() + 4);  // at (0, 0)
  const WellBuiltItem item = itemOf(model, "stiff");
  EXPECT_EQ(figureOf(item, "beamsOnOneAxis"), 2);
  EXPECT_TRUE(lights(item, "oneAxis", 0));
  EXPECT_TRUE(lights(item, "oneAxis", 2));
}

TEST(WellBuiltStiff, PinThatHoldsASpacerOnlyHoldsNoBeam) {
  Model model = testing::squareFrame();
  model.parts.erase(model.parts.begin() + 4);
  model.parts.push_back(pinAt("2780", {4, 0, 0.5}, kZ));
  model.parts.push_back(beamAt("18654", {4, 0, 1}, kX, kZ));
  EXPECT_EQ(figure(model, "stiff", "beamsOnOneAxis"), 2);
}

TEST(WellBuiltStiff, JointOfTheSketchMayTurn) {
  Model model;
  model.parts = {beamAt("40490", {4, 0, 0}, kX, kZ),
                 beamAt("40490", {0, 4, 1}, kY, kZ),
                 pinAt("3673", {0, 0, 0.5}, kZ)};
  const std::vector<std::pair<Vec3, Vec3>> lines{{{0, 0, 0}, {8, 0, 0}}, {{0, 0, 0}, {0, 8, 0}}};
  model.sketchJson = testing::sketchOf(lines);
  EXPECT_EQ(figure(model, "stiff", "beamsOnOneAxis"), 2);
  model.sketchJson = testing::sketchOf(lines, R"(,"joints":[{"at":[0,0,0],"axis":[0,0,1]}])");
  const WellBuiltItem item = itemOf(model, "stiff");
  EXPECT_EQ(figureOf(item, "beamsOnOneAxis"), 0);
  EXPECT_TRUE(item.ok);
}

TEST(WellBuiltStiff, BeamOnAnAxleThatTurnsHangsOnItsLine) {
  Model model = testing::squareWithAxle();
  // The 2-hole beam keeps its axle, which turns in the beam below; its pin goes.
  model.parts.erase(model.parts.begin() + 9);
  model.parts[9] = pinAt("4519", {0, 3, 2}, kZ);
  model.parts.pop_back();
  EXPECT_TRUE(lights(itemOf(model, "stiff"), "oneAxis", kAdded));
}

// Stands.

TEST(WellBuiltStands, SquareOnTheFloorStands) {
  const WellBuiltItem item = itemOf(testing::squareFrame(), "stands");
  EXPECT_TRUE(item.applies);
  EXPECT_TRUE(item.ok) << item.detail;
  EXPECT_EQ(figureOf(item, "feet"), 0);  // it lies on them
}

//! A square on the floor with a post on one corner, drawn and built.
Model squareWithPost() {
  Model model = squareWith(beamAt("32524", {0, 0, 4}, kZ, kY));
  const json post{{"from", {0, 0, 0}}, {"to", {0, 0, 6}}};
  json sketch = json::parse(model.sketchJson);
  sketch["lines"].push_back(post);
  model.sketchJson = sketch.dump();
  return model;
}

TEST(WellBuiltStands, DrawingThatRisesHasFeetAtTheCornersOfItsBase) {
  const WellBuiltItem item = itemOf(squareWithPost(), "stands");
  EXPECT_EQ(figureOf(item, "feet"), 4);
}

TEST(WellBuiltStands, HalfAMillimetreIsLevel) {
  Model model = testing::squareFrame();
  model.parts.push_back(beamAt("32524", {4, 4, -0.05}, kX, kZ));
  EXPECT_EQ(figure(model, "stands", "belowBase"), 0);
  model.parts.back().pose.position.z = -0.1;
  EXPECT_EQ(figure(model, "stands", "belowBase"), 1);
}

TEST(WellBuiltStands, PinBelowTheBaseIsFound) {
  const WellBuiltItem item = itemOf(squareWith(pinAt("2780", {4, 0, -0.5}, kZ)), "stands");
  EXPECT_EQ(figureOf(item, "belowBase"), 1);
  EXPECT_TRUE(lights(item, "belowBase", kAdded));
  EXPECT_FALSE(item.ok);
}

TEST(WellBuiltStands, DrawnWheelsMayLieBelowTheBase) {
  Model model = squareWith({"3736", 71, {{4, -3, -1}, {}}, -1, 0, 0});
  EXPECT_EQ(figure(model, "stands", "belowBase"), 1);
  json sketch = json::parse(model.sketchJson);
  sketch["version"] = 2;
  sketch["shafts"] =
      json::array({{{"from", {4, -3, -1}}, {"to", {4, 3, -1}}, {"atFrom", "wheel"}}});
  model.sketchJson = sketch.dump();
  EXPECT_EQ(figure(model, "stands", "belowBase"), 0);
}

TEST(WellBuiltStands, LoweredFootLeavesTheOthersInTheAir) {
  Model model = squareWithPost();
  model.parts[0] = beamAt("40490", {4, 0, -2}, kX, kZ);
  const WellBuiltItem item = itemOf(model, "stands");
  EXPECT_EQ(figureOf(item, "liftedFeet"), 2);
  EXPECT_TRUE(lights(item, "liftedFoot", 1));
  EXPECT_EQ(figureOf(item, "belowBase"), 0);
}

TEST(WellBuiltStands, ModelThatFallsOverWhereTheDrawingStandsIsFound) {
  Model model;
  model.parts = {beamAt("40490", {4, 0, 0}, kX, kZ),
                 beamAt("32278", {14, 0, 1}, kX, kZ),
                 pinAt("2780", {8, 0, 0.5}, kZ),
                 pinAt("2780", {7, 0, 0.5}, kZ)};
  model.sketchJson = testing::squareFrame().sketchJson;
  const WellBuiltItem item = itemOf(model, "stands");
  EXPECT_EQ(figureOf(item, "couldStand"), 1);
  EXPECT_EQ(figureOf(item, "fallsOver"), 1);
  EXPECT_FALSE(item.ok);
}

TEST(WellBuiltStands, DrawingThatStandsOnAPointAsksForNothing) {
  Model model;
  model.parts = {beamAt("40490", {0, 0, 4}, kZ, kY)};
  model.sketchJson = testing::sketchOf({{{0, 0, 0}, {0, 0, 8}}});
  EXPECT_FALSE(itemOf(model, "stands").applies);
}

TEST(WellBuiltStands, UprightFrameHasAFlatBaseButCannotStand) {
  Model model = testing::pythagoreanTriangle();
  const WellBuiltItem item = itemOf(model, "stands");
  EXPECT_EQ(figureOf(item, "flatBase"), 1);
  EXPECT_EQ(figureOf(item, "couldStand"), 0);
}

// Faithful.

TEST(WellBuiltFaithful, MeanLayerIsWeightedByLength) {
  EXPECT_NEAR(figure(testing::squareFrame(), "faithful", "meanLayer"), 0.5, 1e-9);
}

TEST(WellBuiltFaithful, BeamFarOffItsLineIsFound) {
  Model model = testing::squareFrame();
  model.parts[3].pose.position.z = 3;
  const WellBuiltItem item = itemOf(model, "faithful");
  EXPECT_NEAR(figureOf(item, "meanLayer"), 1.0, 1e-9);
  EXPECT_NEAR(figureOf(item, "greatestProtrusion"), 3.0, 1e-9);
  EXPECT_TRUE(lights(item, "farOff", 3));
}

TEST(WellBuiltFaithful, OverhangSticksOut) {
  Model model = testing::squareFrame();
  model.parts[0] = beamAt("32525", {5, 0, 0}, kX, kZ);
  EXPECT_NEAR(figure(model, "faithful", "greatestProtrusion"), 2.0, 1e-9);
}

// Few.

TEST(WellBuiltFew, CountsPartsAndKinds) {
  const WellBuiltItem item = itemOf(testing::squareFrame(), "few");
  EXPECT_EQ(figureOf(item, "parts"), 8);
  EXPECT_EQ(figureOf(item, "kinds"), 2);
  EXPECT_TRUE(item.ok);
}

TEST(WellBuiltFew, PinInOneBeamAloneIsOfNoUse) {
  const WellBuiltItem item = itemOf(squareWith(pinAt("2780", {4, 0, 0.5}, kZ)), "few");
  EXPECT_EQ(figureOf(item, "idleParts"), 1);
  EXPECT_TRUE(lights(item, "idle", kAdded));
}

TEST(WellBuiltFew, BeamThatStandsForNoLineAndJoinsNothingIsOfNoUse) {
  EXPECT_TRUE(
      lights(itemOf(squareWith(beamAt("32316", {4, 4, 5}, kX, kZ)), "few"), "idle", kAdded));
}

}  // namespace
}  // namespace liftarm::analysis
