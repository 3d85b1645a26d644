#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/models.h"
#include "design/design_session.h"
#include "model/model_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json analysed(const std::string& options) {
  const auto answer = analyseStressJson(model::writeModel(testing::squareFrame()), options);
  if (!answer.ok()) {
    ADD_FAILURE() << answer.error().message;
    return {};
  }
  return json::parse(answer.value());
}

TEST(StressJson, TellsStressOfEveryPart) {
  const json answer = analysed("{}");
  EXPECT_TRUE(answer.at("ok"));
  EXPECT_EQ(answer.at("parts").size(), 8U);
  EXPECT_EQ(answer.at("samples").size(), 8U);
  for (const json& samples : answer.at("samples")) {
    ASSERT_FALSE(samples.empty());
    EXPECT_EQ(samples[0].size(), 7U);
  }
  EXPECT_EQ(answer.at("pins").size(), 4U);
  EXPECT_LT(answer.at("imbalance").get<double>(), 1e-6);
}

TEST(StressJson, SaysBesideTheNumbersWhereFrictionAloneHolds) {
  EXPECT_THAT(analysed("{}").at("message").get<std::string>(), HasSubstr("friction alone holds 1"));
  EXPECT_EQ(analysed(R"({"friction":"locked"})").at("message"), "");
}

TEST(StressJson, TakesNoOptionsAsTheDefaults) {
  EXPECT_EQ(analysed(""), analysed(R"({"friction":"held","loads":[]})"));
}

TEST(StressJson, TellsWhichPartsMove) {
  const json answer = analysed(R"({"friction":"free"})");
  EXPECT_FALSE(answer.at("ok"));
  EXPECT_FALSE(answer.at("moving").empty());
  EXPECT_THAT(answer.at("message").get<std::string>(), HasSubstr("move"));
}

TEST(StressJson, PutsLoadsOnTheModel) {
  const json answer = analysed(R"({"loads":[{"at":[4,0,0],"force":[0,0,-10]}]})");
  EXPECT_GT(answer.at("maxStress").get<double>(),
            10 * analysed("{}").at("maxStress").get<double>());
}

struct Refused {
  const char* options;
  const char* place;
};

struct RefusedOptions : ::testing::TestWithParam<Refused> {};

TEST_P(RefusedOptions, AreNamedByTheirPlace) {
  const auto answer =
      analyseStressJson(model::writeModel(testing::squareFrame()), GetParam().options);
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.error().status, base::Status::kInvalidInput);
  EXPECT_THAT(answer.error().message, HasSubstr(GetParam().place));
}

INSTANTIATE_TEST_SUITE_P(
    Some,
    RefusedOptions,
    ::testing::Values(Refused{"[]", "options"},
                      Refused{R"({"friction":"some"})", "friction"},
                      Refused{R"({"heldStiffness":0})", "heldStiffness"},
                      Refused{R"({"loads":3})", "loads"},
                      Refused{R"({"loads":[{"at":[0,0,0]}]})", "loads[0].force"},
                      Refused{R"({"loads":[{"at":[0,0],"force":[0,0,0]}]})", "loads[0].at"},
                      Refused{R"({"loads":[{"at":[0,0,0],"force":[0,0,1e9]}]})", "force"},
                      Refused{R"({"loads":[{"at":[50,0,0],"force":[0,0,-1]}]})", "loads[0].at"}));

TEST(ExportModel, RefusesAFrameThatMovesWithTheReason) {
  model::Model model = testing::squareFrame();
  // A beam that hangs in the air.
  model.parts.push_back(testing::beamAt("32316", {4, 4, 9}, {1, 0, 0}, {0, 0, 1}));
  const auto deck = exportModel(model::writeModel(model), "inp");
  ASSERT_FALSE(deck.ok());
  EXPECT_EQ(deck.error().status, base::Status::kSingular);
}

}  // namespace
}  // namespace liftarm::design
