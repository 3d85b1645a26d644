#include "analysis/check.h"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/models.h"
#include "core/helpers/shared_data.h"
#include "core/helpers/voxel_solids.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using model::Model;
using testing::beamAt;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::partAt;
using testing::pinAt;
using testing::squareFrame;

CheckReport check(const Model& model) {
  return checkModel(model, parts::Catalogue::builtIn());
}

std::string failures(const CheckReport& report) {
  std::string text;
  for (const CheckItem& item : report.items) {
    text += item.ok ? "" : item.id + " ";
  }
  return text;
}

std::string messages(const CheckReport& report) {
  std::string text;
  for (const Problem& problem : report.problems) {
    text += problem.kind + ": " + problem.message + "\n";
  }
  return text;
}

struct GoodModel : ::testing::TestWithParam<Model> {};

TEST_P(GoodModel, IsBuildable) {
  const CheckReport report = check(GetParam());
  EXPECT_TRUE(report.buildable) << messages(report);
  EXPECT_GE(report.items.size(), 6U);
}

TEST_P(GoodModel, IsSoWithoutAReport) {
  const parts::Catalogue& catalogue = parts::Catalogue::builtIn();
  EXPECT_TRUE(isBuildable(GetParam(), catalogue));
}

TEST_P(GoodModel, HasRealSolidsThatShareNoSpace) {
  LIFTARM_NEED_SHARED_DATA();
  testing::VoxelSolids solids;
  for (const testing::VoxelOverlap& o : testing::voxelOverlaps(GetParam(), solids)) {
    ADD_FAILURE() << "parts " << o.partA << " and " << o.partB << ": " << o.cubes << " cubes, at "
                  << o.at.x << " " << o.at.y << " " << o.at.z;
  }
}

INSTANTIATE_TEST_SUITE_P(All, GoodModel, ::testing::ValuesIn(testing::buildableModels()));

struct BadCase {
  const char* what;
  const char* failingItem;
  const char* problemKind;
  std::function<Model()> make;
};

Model changed(Model model, const std::function<void(Model&)>& change) {
  change(model);
  return model;
}

Model withSketch(const std::string& more) {
  return changed(squareFrame(), [&](Model& m) {
    m.sketchJson.pop_back();
    const std::size_t ground = m.sketchJson.rfind(",\"ground\"");
    m.sketchJson.resize(ground);
    m.sketchJson += more + "}";
  });
}

Model withExtra(const std::vector<model::PlacedPart>& extra) {
  return changed(squareFrame(),
                 [&](Model& m) { m.parts.insert(m.parts.end(), extra.begin(), extra.end()); });
}

void mirrorFirstBeam(Model& m) {
  for (const std::size_t i : {0U, 3U, 6U}) {
    m.parts[0].pose.rotation.m[i] *= -1.0;
  }
}

model::PlacedPart turned(model::PlacedPart part, Vec3 axis, double degrees) {
  testing::turn(part, axis, degrees);
  return part;
}

const std::vector<BadCase>& badCases() {
  static const std::vector<BadCase> kCases{
      {"UnknownPart",
       "realParts ",
       "unknownPart",
       [] {
         return withExtra({partAt("99999", {4, 4, 9})});
       }},
      {"MirroredPart",
       "realParts ",
       "rotation",
       [] { return changed(squareFrame(), mirrorFirstBeam); }},
      {"TwoBodiesInOnePlace",
       "interpenetration ",
       "collision",
       [] {
         return withExtra({beamAt("32523", {0, 1, 0}, kY, kZ), pinAt("2780", {0, 2, 0.5}, kZ)});
       }},
      {"HeadInASolid",
       "interpenetration ",
       "collision",
       [] {
         // The free head of the pin along x runs into the side of the beam on top of the frame.
         return withExtra({beamAt("32523", {-1, 4, 2}, kX, kZ),
                           pinAt("2780", {0, 4, 1.5}, kZ),
                           turned(pinAt("15100", {0, 6, 2}, -kZ), kZ, 90),
                           pinAt("2780", {0.5, 6, 2}, kX),
                           beamAt("32523", {1, 5, 2}, kY, kX),
                           pinAt("2780", {0.5, 4, 2}, kX)});
       }},
      {"KeepOut",
       "interpenetration ",
       "keepOut",
       [] { return withSketch(R"(,"keepOut":[{"min":[4,0,0],"max":[4,0,0]}])"); }},
      {"BelowGround", "interpenetration ", "ground", [] { return withSketch(R"(,"ground":1)"); }},
      {"PinInAxleHole",
       "connections ",
       "badFit",
       [] {
         return withExtra({partAt("60483", {0, 3, 2}),
                           pinAt("2780", {0, 3, 1.5}, kZ),
                           pinAt("2780", {0, 4, 1.5}, kZ)});
       }},
      {"TwoPinsInOneHole",
       "connections ",
       "sharedHole",
       [] {
         return withExtra({pinAt("2780", {0, 4, 1.5}, kZ), pinAt("2780", {0, 4, 0.5}, kZ)});
       }},
      {"TwistedAxle",
       "connections ",
       "badFit",
       [] {
         return changed(testing::squareWithAxle(), [](Model& m) {
           testing::turn(m.parts[10], kZ, 45);
           m.parts.pop_back();
         });
       }},
      {"AxleBetweenSlots",
       "connections ",
       "badFit",
       [] {
         return changed(testing::squareWithAxle(), [](Model& m) {
           m.parts[10].pose.position.z = 3.5;
           m.parts.pop_back();
         });
       }},
      {"PartThatTouchesNothing",
       "connections ",
       "unconnected",
       [] {
         return changed(squareFrame(), [](Model& m) {
           m.parts.push_back({"2780", 0, {{4, 4, 5}, {}}});
         });
       }},
      {"BeamThatTouchesNothing",
       "assembly ",
       "separate",
       [] {
         return withExtra({beamAt("32316", {4, 4, 5}, kX, kZ)});
       }},
      {"BeamOnAnAxleAlone",
       "connections ",
       "loose",
       [] {
         return changed(testing::squareWithAxle(), [](Model& m) {
           m.parts.back() = beamAt("32316", {0, 5, 3}, kY, kZ);
         });
       }},
      {"TwoAssemblies",
       "assembly ",
       "separate",
       [] {
         return changed(squareFrame(), [](Model& m) {
           m.parts.pop_back();
           m.parts.erase(m.parts.begin() + 4);
         });
       }},
      {"StrayAssembly",
       "assembly ",
       "separate",
       [] {
         return withExtra({beamAt("32316", {4, 4, 5}, kX, kZ),
                           beamAt("32316", {4, 4, 6}, kX, kZ),
                           pinAt("2780", {4, 4, 5.5}, kZ)});
       }},
      {"ShortBeam",
       "coverage ",
       "uncovered",
       [] {
         return changed(squareFrame(), [](Model& m) {
           m.parts[0] = beamAt("32524", {3, 0, 0}, kX, kZ);
         });
       }},
      {"ExactLineOffItsLayer",
       "coverage ",
       "uncovered",
       [] {
         return changed(squareFrame(), [](Model& m) {
           const std::string last = R"("to":[0,8,0])";
           m.sketchJson.insert(m.sketchJson.rfind(last) + last.size(), R"(,"exact":true)");
         });
       }},
      {"AxleShorterThanItsLine",
       "coverage ",
       "uncovered",
       [] {
         return changed(testing::frameOfAxles(), [](Model& m) {
           const std::string last = R"({"from":[4,0,0],"to":[4,4,0]})";
           m.sketchJson.replace(
               m.sketchJson.rfind(last), last.size(), R"({"from":[4,0,0],"to":[4,6,0]})");
         });
       }},
      {"AxleOnALineThatFixesTheHoleAxisOfBeams",
       "coverage ",
       "uncovered",
       [] {
         return changed(testing::frameOfAxles(), [](Model& m) {
           const std::string last = R"("to":[4,4,0])";
           m.sketchJson.insert(m.sketchJson.rfind(last) + last.size(), R"(,"holeAxis":"x")");
         });
       }},
      {"AxleBesideItsLine",
       "coverage ",
       "uncovered",
       [] {
         return changed(testing::frameOfAxles(), [](Model& m) {
           for (std::size_t i = 7; i < m.parts.size(); ++i) {
             m.parts[i].pose.position.x = 3;
           }
         });
       }},
      {"BeamWithTheWrongHoleAxis",
       "coverage ",
       "uncovered",
       [] {
         return changed(squareFrame(), [](Model& m) {
           const std::string last = R"("to":[0,8,0])";
           m.sketchJson.insert(m.sketchJson.rfind(last) + last.size(), R"(,"holeAxis":"x")");
         });
       }},
      {"UnreadableSketch",
       "coverage ",
       "sketch",
       [] { return changed(squareFrame(), [](Model& m) { m.sketchJson = "{}"; }); }},
  };
  return kCases;
}

struct BadModel : ::testing::TestWithParam<BadCase> {};

TEST_P(BadModel, FailsExactlyTheIntendedItem) {
  const CheckReport report = check(GetParam().make());
  EXPECT_FALSE(report.buildable);
  EXPECT_EQ(failures(report), GetParam().failingItem) << messages(report);
  ASSERT_FALSE(report.problems.empty());
  EXPECT_EQ(report.problems.front().kind, GetParam().problemKind) << messages(report);
}

TEST_P(BadModel, FailsWithoutAReport) {
  const parts::Catalogue& catalogue = parts::Catalogue::builtIn();
  EXPECT_FALSE(isBuildable(GetParam().make(), catalogue));
}

INSTANTIATE_TEST_SUITE_P(All, BadModel, ::testing::ValuesIn(badCases()), [](const auto& bad) {
  return std::string(bad.param.what);
});

TEST(Check, NamesThePlaceAndThePartsOfACollision) {
  const CheckReport report =
      check(withExtra({beamAt("32523", {0, 1, 0}, kY, kZ), pinAt("2780", {0, 2, 0.5}, kZ)}));
  ASSERT_EQ(report.problems.size(), 1U) << messages(report);
  EXPECT_EQ(report.problems[0].parts, (std::vector<int>{0, 8}));
  ASSERT_TRUE(report.problems[0].at.has_value());
  EXPECT_LT(lattice::length(*report.problems[0].at - Vec3{2, 0.5, 0}), 3.0);
}

TEST(Check, CountsWhatTheModelHolds) {
  const CheckReport report = check(squareFrame());
  EXPECT_EQ(report.counts.beams, 4);
  EXPECT_EQ(report.counts.bricks, 8);
  EXPECT_EQ(report.counts.gaps, 0);
  EXPECT_NEAR(report.counts.mass, 4 * 2.58 + 4 * 0.20, 1e-9);
  EXPECT_NEAR(report.counts.size.x, 8.9, 1e-9);
  EXPECT_NEAR(report.counts.size.z, 2.0, 1e-9);
}

TEST(Check, AnAxleStandsForALineOnlyWhereItHoldsAllThatMeetsIt) {
  // A third line meets that of the second axle half way; its beam hangs on the first beam alone.
  Model model = testing::frameOfAxles();
  model.parts[1] = beamAt("40490", {4, 4, 0}, kX, kY);
  model.parts.push_back(beamAt("40490", {8, 0, 0}, kY, kZ));
  model.sketchJson = testing::sketchOf({{{0, 0, 0}, {4, 0, 0}},
                                        {{0, 4, 0}, {8, 4, 0}},
                                        {{0, 0, 0}, {0, 4, 0}},
                                        {{4, 0, 0}, {4, 4, 0}},
                                        {{4, 2, 0}, {8, 2, 0}}});
  const std::string text = messages(check(model));
  EXPECT_NE(text.find("lines[3] is neither covered nor bridged"), std::string::npos) << text;
  EXPECT_EQ(text.find("lines[2]"), std::string::npos) << text;
}

TEST(Check, AnAxleThatSlidesStandsForNoLine) {
  Model model = testing::frameOfAxles();
  model.parts.erase(model.parts.begin() + 3, model.parts.begin() + 7);
  const std::string text = messages(check(model));
  EXPECT_NE(text.find("lines[2] is neither covered nor bridged"), std::string::npos) << text;
}

TEST(Check, AStackWithAnEmptyLayerHasAGap) {
  Model model = squareFrame();
  model.parts[3].pose.position.z = 2;
  model.parts[5] = pinAt("6558", {8, 0, 1}, kZ);
  model.parts[7] = pinAt("6558", {8, 8, 1}, kZ);
  EXPECT_EQ(check(model).counts.gaps, 2);
  model.parts.push_back(beamAt("18654", {8, 0, 1}, kX, kZ));
  EXPECT_EQ(check(model).counts.gaps, 1);
}

TEST(Check, ABeamBetweenTwoLinesStandsForOneOfThem) {
  // A second sketch line two modules above an existing one has no beam of its own.
  Model model = squareFrame();
  model.sketchJson = testing::sketchOf({{{0, 0, 0}, {8, 0, 0}},
                                        {{8, 0, 0}, {8, 8, 0}},
                                        {{0, 8, 0}, {8, 8, 0}},
                                        {{0, 0, 0}, {0, 8, 0}},
                                        {{0, 0, 2}, {8, 0, 2}}});
  const CheckReport report = check(model);
  EXPECT_EQ(failures(report), "coverage ") << messages(report);
  EXPECT_EQ(report.counts.uncovered, 1);
  EXPECT_NE(messages(report).find("lines[4]"), std::string::npos);
}

TEST(Check, TwoLinesOnOnePlaceNeedOneBeam) {
  Model model = squareFrame();
  model.sketchJson = testing::sketchOf({{{0, 0, 0}, {8, 0, 0}},
                                        {{2, 0, 0}, {6, 0, 0}},
                                        {{8, 0, 0}, {8, 8, 0}},
                                        {{8, 8, 0}, {0, 8, 0}},
                                        {{0, 0, 0}, {0, 8, 0}}});
  const CheckReport report = check(model);
  EXPECT_TRUE(report.buildable) << messages(report);
}

TEST(Check, AnEmptyModelIsNotBuildable) {
  EXPECT_FALSE(check(Model()).buildable);
}

TEST(Check, VoxelJudgeSeesTheSameCollision) {
  LIFTARM_NEED_SHARED_DATA();
  testing::VoxelSolids solids;
  const Model model =
      withExtra({beamAt("32523", {0, 1, 0}, kY, kZ), pinAt("2780", {0, 2, 0.5}, kZ)});
  const auto overlaps = testing::voxelOverlaps(model, solids);
  ASSERT_EQ(overlaps.size(), 1U);
  EXPECT_EQ(overlaps[0].partA, 8);
  EXPECT_EQ(overlaps[0].partB, 0);
}

}  // namespace
}  // namespace liftarm::analysis
