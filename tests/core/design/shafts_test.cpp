#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/check.h"
#include "design/design_session.h"
#include "model/model_json.h"
#include "parts/catalogue.h"
#include "parts/gear_teeth.h"
#include "sketch/shaft_json.h"

namespace liftarm::design {
namespace {

//! Two upright frames with cross beams between their feet, and a train of 15 to 1 in them.
const char* const kGearbox = R"({"format": "technic-sketch", "version": 2, "name": "Gearbox",
  "lines": [{"from": [0, 0, 4], "to": [14, 0, 4]}, {"from": [0, 0, 0], "to": [14, 0, 0]},
            {"from": [0, 0, 0], "to": [0, 0, 4]}, {"from": [14, 0, 0], "to": [14, 0, 4]},
            {"from": [0, 4, 4], "to": [14, 4, 4]}, {"from": [0, 4, 0], "to": [14, 4, 0]},
            {"from": [0, 4, 0], "to": [0, 4, 4]}, {"from": [14, 4, 0], "to": [14, 4, 4]},
            {"from": [0, 0, 0], "to": [0, 4, 0]}, {"from": [14, 0, 0], "to": [14, 4, 0]}],
  "shafts": [{"from": [4, -2, 4], "to": [4, 5, 4]}, {"from": [9, -1, 4], "to": [9, 6, 4]}],
  "drives": [{"from": 0, "to": 1, "ratio": 15}]})";

//! The same with a crank and a wheel at the outer ends of its shafts.
std::string crankedGearbox() {
  std::string text = kGearbox;
  const auto put = [&text](const std::string& after, const std::string& end) {
    text.insert(text.find(after) + after.size(), end);
  };
  put(R"("to": [4, 5, 4])", R"(, "atFrom": "crank")");
  put(R"("to": [9, 6, 4])", R"(, "atTo": "wheel")");
  return text;
}

model::Model solved(const char* sketch) {
  auto session = DesignSession::create(sketch, "{}");
  EXPECT_TRUE(session.ok());
  while (!session.value()->advance(100'000)) {
  }
  return model::readModel(session.value()->modelJson()).value();
}

TEST(ShaftsInAModel, AGearboxIsBuildableWithItsGearsInIt) {
  const model::Model model = solved(kGearbox);
  const analysis::CheckReport report = analysis::checkModel(model, parts::Catalogue::builtIn());
  EXPECT_TRUE(report.buildable) << (report.problems.empty() ? "" : report.problems.front().message);
  int gears = 0;
  for (const model::PlacedPart& part : model.parts) {
    gears += parts::teethOf(*parts::Catalogue::builtIn().find(part.part)) > 0 ? 1 : 0;
  }
  EXPECT_EQ(gears, 4);
}

TEST(ShaftsInAModel, ACrankAndAWheelAreBuildableAndTurnWithTheirShafts) {
  const model::Model model = solved(crankedGearbox().c_str());
  const analysis::CheckReport report = analysis::checkModel(model, parts::Catalogue::builtIn());
  EXPECT_TRUE(report.buildable) << (report.problems.empty() ? "" : report.problems.front().message);
  const nlohmann::json motion =
      nlohmann::json::parse(analyseMotionJson(model::writeModel(model)).value());
  std::set<std::string> turning;
  for (const nlohmann::json& shaft : motion.at("trains").at(0).at("shafts")) {
    for (const int part : shaft.at("parts")) {
      turning.insert(model.parts[static_cast<std::size_t>(part)].part);
    }
  }
  for (const char* part : {parts::kCrankArm, parts::kCrankHandle, parts::kWheel}) {
    EXPECT_EQ(turning.count(part), 1U) << part;
  }
}

TEST(ShaftsInAModel, AModelWithoutItsWheelFails) {
  model::Model model = solved(crankedGearbox().c_str());
  model.parts.erase(
      std::find_if(model.parts.begin(), model.parts.end(), [](const model::PlacedPart& part) {
        return part.part == parts::kWheel;
      }));
  const analysis::CheckReport report = analysis::checkModel(model, parts::Catalogue::builtIn());
  EXPECT_TRUE(std::any_of(report.problems.begin(), report.problems.end(), [](const auto& problem) {
    return problem.message == "shafts[1]: no wheel sits at its end";
  }));
}

TEST(ShaftsInAModel, ItsSketchStillSaysWhatTurns) {
  const model::Model model = solved(kGearbox);
  const sketch::Shafts shafts = sketch::shaftsOf(model.sketchJson);
  EXPECT_EQ(shafts.shafts.size(), 2U);
  EXPECT_EQ(shafts.drives.size(), 1U);
  // What was planned for them is no part of the drawing.
  EXPECT_EQ(model.sketchJson.find("keepOut"), std::string::npos);
}

TEST(ShaftsInAModel, ItsMotionHasTheTrainWithTheSpeedsOfItsShafts) {
  const std::string text = analyseMotionJson(model::writeModel(solved(kGearbox))).value();
  const nlohmann::json trains = nlohmann::json::parse(text).at("trains");
  ASSERT_EQ(trains.size(), 1U);
  EXPECT_TRUE(trains[0].at("turns").get<bool>());
  double first = 0.0;
  double second = 0.0;
  for (const nlohmann::json& shaft : trains[0].at("shafts")) {
    (shaft.at("drawn") == 0 ? first : second) =
        shaft.at("drawn").is_null() ? second : shaft.at("speed").get<double>();
  }
  EXPECT_NEAR(first / second, 15.0, 0.45);
}

TEST(ShaftsInAModel, ThePapersMethodRefusesThem) {
  const auto session = DesignSession::create(kGearbox, R"({"method": "paper"})");
  ASSERT_FALSE(session.ok());
  EXPECT_EQ(session.error().message,
            "shafts: method paper knows no shafts; use the default method");
}

}  // namespace
}  // namespace liftarm::design
