#include <gtest/gtest.h>

#include "core/helpers/crank_rockers.h"
#include "core/helpers/solved.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

json firstJoint(const std::string& model) {
  return json::parse(analyseMotionJson(model).value()).at("joints").at(0);
}

TEST(RequiredRange, ACrankThatMustGoRoundGoesRound) {
  const testing::Solved solved =
      testing::solve(testing::crankRocker(std::array<double, 2>{-180.0, 180.0}));
  EXPECT_TRUE(solved.report.at("buildable").get<bool>()) << solved.report.at("problems");
  const json joint = firstJoint(solved.text);
  EXPECT_GE(joint.at("to").get<double>() - joint.at("from").get<double>(), 359.5);
}

// The model of the sketch that asks for nothing, with the question put to it afterwards.
TEST(RequiredRange, AModelWhoseJointIsStoppedBeforeIsNotBuildable) {
  testing::Solved solved = testing::solve(testing::crankRocker(std::nullopt));
  const json joint = firstJoint(solved.text);
  const double turns = joint.at("to").get<double>() - joint.at("from").get<double>();
  ASSERT_LT(turns, 350.0) << "frame and coupler share no layer: choose another sketch";
  json model = json::parse(solved.text);
  model["sketch"] =
      json::parse(sketch::writeSketch(testing::crankRocker(std::array<double, 2>{-180.0, 180.0})));
  const json checked = json::parse(checkModelJson(model.dump()).value());
  EXPECT_FALSE(checked.at("buildable").get<bool>());
  ASSERT_EQ(checked.at("problems").size(), 1U);
  EXPECT_NE(checked.at("problems")[0].at("message").get<std::string>().find("It must turn"),
            std::string::npos);
}

TEST(RequiredRange, IsReadWrittenAndRefusedWithItsPlace) {
  const sketch::Sketch drawn = testing::crankRocker(std::array<double, 2>{-30.0, 90.0});
  const auto read = sketch::readSketch(sketch::writeSketch(drawn));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read.value().joints.front().range, drawn.joints.front().range);
  for (const char* wrong : {"[10, 20]", "[0, 0]", "[-200, 0]", "[1]", "\"x\""}) {
    json document = json::parse(sketch::writeSketch(drawn));
    document["joints"][0]["range"] = json::parse(wrong);
    const auto refused = sketch::readSketch(document.dump());
    ASSERT_FALSE(refused.ok()) << wrong;
    EXPECT_EQ(refused.error().message.rfind("joints[0].range", 0), 0U) << refused.error().message;
  }
  json old = json::parse(sketch::writeSketch(drawn));
  old["version"] = 1;
  EXPECT_FALSE(sketch::readSketch(old.dump()).ok());
}

}  // namespace
}  // namespace liftarm::design
