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
