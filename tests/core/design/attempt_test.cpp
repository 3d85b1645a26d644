#include "design/attempt.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/sketches.h"
#include "design/alikeness.h"
#include "design/design_session.h"
#include "design/looseness.h"
#include "design/model_builder.h"
#include "model/model_json.h"
#include "objective/mobility.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

Settings settingsFrom(const std::string& text) {
  base::Result<Settings> settings = readSettings(text);
  EXPECT_TRUE(settings.ok());
  return std::move(settings).value();
}

//! What the model wing counts on the real parts.
int freedomsOfModel(const Attempts& attempts, const sketch::Sketch& sketch) {
  const model::Model model = buildModel(attempts.problem(),
                                        attempts.table(),
                                        attempts.search().best(),
                                        "test",
                                        sketch::writeSketch(sketch));
  const base::Result<std::string> motion = analyseMotionJson(model::writeModel(model));
  EXPECT_TRUE(motion.ok());
  return json::parse(motion.value())["freedoms"]["beyondJoints"].get<int>();
}

class MobilityOf : public ::testing::TestWithParam<std::string> {};

TEST_P(MobilityOf, ALayoutIsThatOfItsModel) {
  const Settings settings = settingsFrom(GetParam());
  for (const sketch::Sketch& sketch : {testing::squareSketch(8),
                                       testing::cornerSketch(6),
                                       testing::teeSketch(),
                                       testing::cubeSketch(7),
                                       testing::houseSketch()}) {
    Attempts attempts(sketch, settings);
    objective::Mobility mobility(attempts.problem(), attempts.table());
    for (int slice = 0; slice < 4; ++slice) {
      attempts.advance(200);
      const search::LayoutSnapshot& best = attempts.search().best();
      if (best.tallies.violations() > 0) {
        continue;  // what is not joined yet is no linkage
      }
      EXPECT_EQ(mobility.count(best.covers, best.junctions), freedomsOfModel(attempts, sketch))
          << sketch.lines.size() << " lines, slice " << slice;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Presets,
                         MobilityOf,
                         ::testing::Values(R"({"seed": 1, "preset": "simple"})",
                                           R"({"seed": 2, "preset": "faithful"})",
                                           R"({"seed": 3, "preset": "simple-rigid"})",
                                           R"({"seed": 4, "preset": "balanced",
                          "set": {"symmetric": 0, "standing": 0}})"));

TEST(Wishes, StandPutsTheGroundHalfABeamUnderTheLowestPoint) {
  const sketch::Sketch wanted = withWishes(testing::cubeSketch(6), {.standing = true});
  ASSERT_TRUE(wanted.ground.has_value());
  EXPECT_DOUBLE_EQ(*wanted.ground, -0.5);
}

TEST(Wishes, LeaveTheGroundThatThePersonNamed) {
  sketch::Sketch sketch = testing::cubeSketch(6);
  sketch.ground = -3.0;
  EXPECT_DOUBLE_EQ(*withWishes(sketch, {.standing = true}).ground, -3.0);
}

TEST(Wishes, AskNothingOfWhatLiesFlat) {
  EXPECT_TRUE(liesFlat(testing::sketchFrom({{{0, 0, 2}, {8, 0, 2}}, {{0, 0, 2}, {0, 6, 2}}})));
  EXPECT_FALSE(liesFlat(testing::sketchFrom({{{0, 0, 2}, {8, 0, 2}}, {{0, 0, 2}, {0, 0, 8}}})));
}

//! A rectangle of 12 by 9 on the table with both diagonals: one of them passes under the frame, the
//! other over it, which no layout above the drawn plane can do.
TEST(AttemptsOn, AFlatDrawingUseBothSidesOfItsPlane) {
  const sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {12, 0, 0}},
                                                     {{0, 9, 0}, {12, 9, 0}},
                                                     {{0, 0, 0}, {0, 9, 0}},
                                                     {{12, 0, 0}, {12, 9, 0}},
                                                     {{0, 0, 0}, {12, 9, 0}},
                                                     {{0, 9, 0}, {12, 0, 0}}});
  const Settings settings = settingsFrom(R"({"seed": 1})");
  Attempts attempts(sketch, settings);
  while (!attempts.advance(1000)) {
  }
  int lowest = 0;
  int highest = 0;
  for (const layout::Cover& cover : attempts.search().best().covers) {
    for (const layout::Beam& beam : cover.beams) {
      lowest = std::min(lowest, beam.layer);
      highest = std::max(highest, beam.layer);
    }
  }
  EXPECT_TRUE(isWhole(attempts.search().best()));
  EXPECT_LT(lowest, 0);
  EXPECT_GT(highest, 0);
}

TEST(Wishes, FindTheMirrorsAcrossXAndYAlone) {
  const sketch::Sketch wanted = withWishes(testing::cubeSketch(6), {.symmetric = true});
  ASSERT_EQ(wanted.symmetries.size(), 2U);
  for (const sketch::Symmetry& symmetry : wanted.symmetries) {
    EXPECT_EQ(symmetry.normal.z, 0.0);
    EXPECT_NEAR(std::max(std::abs(symmetry.normal.x), std::abs(symmetry.normal.y)), 1.0, 1e-9);
  }
}

TEST(Wishes, LeaveSymmetriesThatThePersonConfirmed) {
  sketch::Sketch sketch = testing::cubeSketch(6);
  sketch::Symmetry mirror;
  mirror.normal = {1, 0, 0};
  mirror.offset = 3;
  sketch.symmetries.push_back(mirror);
  EXPECT_EQ(withWishes(sketch, {.symmetric = true}).symmetries.size(), 1U);
}

TEST(Attempts, ABalancedCubeStandsOnTheDrawingsLowestPlane) {
  const sketch::Sketch sketch = testing::cubeSketch(8);
  const Settings settings = settingsFrom("");
  Attempts attempts(sketch, settings);
  while (!attempts.advance(1000)) {
  }
  const search::LayoutSnapshot& best = attempts.search().best();
  EXPECT_EQ(best.tallies.violations(), 0);
  EXPECT_EQ(
      objective::Mobility(attempts.problem(), attempts.table()).count(best.covers, best.junctions),
      0);
}

TEST(Attempts, KnowWhatMovesInALayoutWhoseSearchWasCutOffBeforeItAsked) {
  const sketch::Sketch sketch = testing::squareSketch(8);
  int loose = 0;
  for (double work = 1e4; work < 2e7; work *= 2.0) {
    Settings settings = settingsFrom(R"({"set": {"symmetric": 0, "standing": 0}})");
    settings.annealing.mostWork = work;
    Attempts attempts(sketch, settings);
    while (!attempts.advance(1000)) {
    }
    const search::LayoutSnapshot& best = attempts.search().best();
    if (isWhole(best)) {
      objective::Mobility mobility(attempts.problem(), attempts.table());
      EXPECT_EQ(attempts.freedoms(), mobility.count(best.covers, best.junctions)) << work;
      loose += attempts.freedoms() > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(loose, 0);  // else nothing was cut off
}

TEST(Attempts, GivesAWishUpWhereNoLayoutGrantsIt) {
  // A line below the ground that the person's keep-out box leaves no room for above it.
  sketch::Sketch sketch = testing::squareSketch(8);
  sketch.keepOut.push_back({{-2, -2, 1}, {10, 10, 3}});
  const Settings settings = settingsFrom(R"({"set": {"corners": 0}})");
  Attempts attempts(sketch, settings);
  while (!attempts.advance(1000)) {
  }
  EXPECT_EQ(attempts.search().best().tallies.violations(), 0);
}

//! The share of beams whose image is there, as the model wing judges the real parts.
double mirroredShare(const Attempts& attempts, const sketch::Sketch& sketch) {
  const model::Model model = buildModel(attempts.problem(),
                                        attempts.table(),
                                        attempts.search().best(),
                                        "test",
                                        sketch::writeSketch(sketch));
  const json report = json::parse(checkModelJson(model::writeModel(model)).value());
  for (const json& item : report["wellBuilt"]["items"]) {
    if (item["id"] == "symmetric") {
      return item["figures"]["mirroredBeams"].get<double>() /
             item["figures"]["beams"].get<double>();
    }
  }
  return -1.0;
}

TEST(Alikeness, OfALayoutIsNeverMoreThanThatOfItsModel) {
  for (const sketch::Sketch& sketch : {testing::squareSketch(7),
                                       testing::squareSketch(8),
                                       testing::cubeSketch(6),
                                       testing::cubeSketch(9),
                                       testing::teeSketch(),
                                       testing::houseSketch()}) {
    for (const int seed : {1, 2, 3}) {
      const Settings settings = settingsFrom(R"({"seed": )" + std::to_string(seed) + "}");
      Attempts attempts(sketch, settings);
      while (!attempts.advance(1000)) {
      }
      const double layout =
          alikeness(attempts.problem(), attempts.search().best(), wishedSymmetries(sketch));
      EXPECT_LE(layout, mirroredShare(attempts, sketch) + 1e-9) << sketch.lines.size() << " lines";
    }
  }
}

TEST(Alikeness, OfAHouseIsWholeWhateverItsRaftersDo) {
  const sketch::Sketch sketch = testing::houseSketch();
  const Settings settings = settingsFrom("");
  Attempts attempts(sketch, settings);
  while (!attempts.advance(1000)) {
  }
  EXPECT_EQ(alikeness(attempts.problem(), attempts.search().best(), wishedSymmetries(sketch)), 1.0);
}

TEST(WishedSymmetries, AreMirrorsOfTheSidesBeforeAnyOther) {
  const std::vector<sketch::Symmetry> ofCube = wishedSymmetries(testing::cubeSketch(6));
  ASSERT_EQ(ofCube.size(), 2U);
  for (const sketch::Symmetry& symmetry : ofCube) {
    EXPECT_EQ(symmetry.kind, sketch::Symmetry::Kind::kReflection);
    EXPECT_EQ(symmetry.normal.z, 0.0);
  }
}

TEST(WishedSymmetries, AreHalfTurnsWhereThereIsNoMirror) {
  sketch::Sketch s = testing::squareSketch(8);  // a Z of three of its lines, stretched
  s.lines.resize(3);
  s.lines[0] = {{0, 0, 0}, {6, 0, 0}, 6, false, {}};
  s.lines[1] = {{6, 0, 0}, {6, 8, 0}, 8, false, {}};
  s.lines[2] = {{6, 8, 0}, {12, 8, 0}, 6, false, {}};
  const std::vector<sketch::Symmetry> symmetries = wishedSymmetries(s);
  ASSERT_EQ(symmetries.size(), 1U);
  EXPECT_EQ(symmetries[0].kind, sketch::Symmetry::Kind::kRotation);
}

//! A rectangle of 12 by 9 with both its diagonals.
sketch::Sketch crossedSketch() {
  return testing::sketchFrom({{{0, 0, 0}, {12, 0, 0}},
                              {{0, 9, 0}, {12, 9, 0}},
                              {{0, 0, 0}, {0, 9, 0}},
                              {{12, 0, 0}, {12, 9, 0}},
                              {{0, 0, 0}, {12, 9, 0}},
                              {{0, 9, 0}, {12, 0, 0}}});
}

TEST(WishedSymmetries, AreHalfTurnsTooWhereLinesCrossInEachMirror) {
  const std::vector<sketch::Symmetry> symmetries = wishedSymmetries(crossedSketch());
  ASSERT_EQ(symmetries.size(), 3U);
  EXPECT_EQ(symmetries.back().kind, sketch::Symmetry::Kind::kRotation);
  for (const sketch::Symmetry& symmetry : withWishes(crossedSketch(), {false, true}).symmetries) {
    EXPECT_EQ(symmetry.kind, sketch::Symmetry::Kind::kReflection);  // not beside mirrors
  }
  EXPECT_EQ(withWishes(crossedSketch(), {false, true, 2}).symmetries.front().kind,
            sketch::Symmetry::Kind::kRotation);
}

//! Freedoms of the default model, as the model wing counts them.
int freedomsByDefault(const sketch::Sketch& sketch) {
  const Settings settings = settingsFrom("");
  Attempts attempts(sketch, settings);
  while (!attempts.advance(1000)) {
  }
  return freedomsOfModel(attempts, sketch);
}

TEST(Attempts, HoldEachLineOfAStarTwice) {
  EXPECT_EQ(freedomsByDefault(testing::sketchFrom({{{0, 0, 0}, {9, 0, 0}},
                                                   {{0, 0, 0}, {-6, 0, 0}},
                                                   {{0, 0, 0}, {0, 3, 0}},
                                                   {{0, 0, 0}, {0, -5, 0}},
                                                   {{0, 0, 0}, {0, 0, 7}},
                                                   {{0, 0, 0}, {0, 0, -6}}})),
            0);
}

TEST(Attempts, HoldTheRidgeOfASymmetricRoof) {
  testing::Segments lines{{{0, 0, 0}, {0, 9, 0}}, {{8, 0, 0}, {8, 9, 0}}, {{4, 0, 3}, {4, 9, 3}}};
  for (const double y : {0.0, 9.0}) {
    lines.push_back({{0, y, 0}, {8, y, 0}});
    lines.push_back({{0, y, 0}, {4, y, 3}});
    lines.push_back({{8, y, 0}, {4, y, 3}});
  }
  EXPECT_EQ(freedomsByDefault(testing::sketchFrom(lines)), 0);
}

TEST(Attempts, NeverGoBackInWhatTheyTellOfTheirProgress) {
  const sketch::Sketch sketch = testing::cubeSketch(7);
  const Settings settings = settingsFrom("");
  Attempts attempts(sketch, settings);
  double fraction = 0.0;
  std::uint32_t improvements = 0;
  bool done = false;
  while (!done) {
    done = attempts.advance(100);
    EXPECT_GE(attempts.fraction(), fraction);
    EXPECT_GE(attempts.improvements(), improvements);
    fraction = attempts.fraction();
    improvements = attempts.improvements();
  }
  EXPECT_EQ(fraction, 1.0);
}

TEST(StandingFaults, AreWhatTheModelWingSaysOfTheModel) {
  const sketch::Sketch sketch = testing::cubeSketch(6);
  const Settings settings = settingsFrom(R"({"seed": 1, "preset": "simple"})");
  int most = 0;
  for (const bool standing : {false, true}) {
    Attempts attempts(withWishes(sketch, {.standing = standing}), settings);
    while (!attempts.advance(1000)) {
    }
    const model::Model model = buildModel(attempts.problem(),
                                          attempts.table(),
                                          attempts.search().best(),
                                          "test",
                                          sketch::writeSketch(sketch));
    const base::Result<std::string> report = checkModelJson(model::writeModel(model));
    ASSERT_TRUE(report.ok());
    const json parsed = json::parse(report.value());
    double faults = 0.0;
    for (const json& item : parsed["wellBuilt"]["items"]) {
      if (item["id"] == "stands") {
        const json& figures = item["figures"];
        faults = figures["belowBase"].get<double>() + figures["liftedFeet"].get<double>() +
                 figures["fallsOver"].get<double>();
      }
    }
    const int counted =
        countStandingFaults(attempts.problem(), attempts.table(), sketch, attempts.search().best());
    EXPECT_EQ(counted, static_cast<int>(faults));
    most = std::max(most, counted);
  }
  EXPECT_GT(most, 0) << "a search that need not stand leaves something to be counted";
}

}  // namespace
}  // namespace liftarm::design
