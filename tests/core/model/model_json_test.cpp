#include "model/model_json.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/models.h"
#include "model/number_text.h"

namespace liftarm::model {
namespace {

TEST(NumberText, IsShortExactAndNeverMinusZero) {
  const std::vector<std::pair<double, std::string>> cases{{0.0, "0"},
                                                          {-0.0, "0"},
                                                          {-4e-7, "0"},
                                                          {1.0, "1"},
                                                          {-2.5, "-2.5"},
                                                          {0.1, "0.1"},
                                                          {1.0 / 3, "0.333333"},
                                                          {1e6, "1000000"},
                                                          {20.0, "20"},
                                                          {-0.000001, "-0.000001"}};
  for (const auto& [value, text] : cases) {
    EXPECT_EQ(numberText(value), text);
  }
}

TEST(ModelJson, ReadingWhatWasWrittenGivesTheSameText) {
  for (const Model& model : testing::buildableModels()) {
    const std::string text = writeModel(model);
    const base::Result<Model> read = readModel(text);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(writeModel(read.value()), text);
    EXPECT_EQ(read.value().parts.size(), model.parts.size());
    EXPECT_EQ(read.value().sketchJson.empty(), model.sketchJson.empty());
  }
}

TEST(ModelJson, AMissingColourIsThePartsOwn) {
  const base::Result<Model> read = readModel(
      R"({"format":"liftarm-model","version":1,"parts":[{"part":"2780","position":[0,0,0],)"
      R"("rotation":[1,0,0,0,1,0,0,0,1]}]})");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read.value().parts[0].color, parts::Catalogue::builtIn().find("2780")->color);
}

struct BadFile {
  const char* text;
  const char* message;
};

class RefusedModel : public ::testing::TestWithParam<BadFile> {};

TEST_P(RefusedModel, NamesThePlace) {
  const base::Result<Model> read = readModel(GetParam().text);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().status, base::Status::kInvalidInput);
  EXPECT_NE(read.error().message.find(GetParam().message), std::string::npos)
      << read.error().message;
}

#define LIFTARM_HEAD R"({"format":"liftarm-model","version":1,"parts":)"

INSTANTIATE_TEST_SUITE_P(
    All,
    RefusedModel,
    ::testing::Values(
        BadFile{"", "not valid JSON"},
        BadFile{"{\"format\":", "not valid JSON"},
        BadFile{"[]", "expected an object"},
        BadFile{"{}", "format"},
        BadFile{R"({"format":"liftarm-model","version":2,"parts":[]})", "version: expected 1"},
        BadFile{R"({"format":"liftarm-model","version":1})", "parts: expected an array"},
        BadFile{LIFTARM_HEAD "[3]}", "parts[0]: expected an object"},
        BadFile{LIFTARM_HEAD "[{}]}", "parts[0].part: missing"},
        BadFile{LIFTARM_HEAD R"([{"part":"2780"}]})", "parts[0].position: missing"},
        BadFile{LIFTARM_HEAD R"([{"part":"2780","position":[0,0]}]})",
                "parts[0].position: expected an array of 3"},
        BadFile{LIFTARM_HEAD R"([{"part":"2780","position":[0,0,1e9]}]})",
                "parts[0].position[2]: outside the limit"},
        BadFile{LIFTARM_HEAD R"([{"part":"2780","position":[0,0,0],"rotation":[1,0]}]})",
                "parts[0].rotation: expected an array of 9"},
        BadFile{LIFTARM_HEAD R"([{"part":"2780","position":[0,0,0],)"
                             R"("rotation":[1,0,0,0,1,0,0,0,1],"layer":0.5}]})",
                "parts[0].layer: expected a whole number"},
        BadFile{R"({"format":"liftarm-model","version":1,"name":3,"parts":[]})", "name"}));

TEST(ModelJson, RefusesWhatLiesTooDeep) {
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  const base::Result<Model> read =
      readModel(R"({"format":"liftarm-model","version":1,"parts":[],"sketch":)" + deep + "}");
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().message.find("deep"), std::string::npos) << read.error().message;
}

TEST(ModelJson, KeepsWhatClosedChainsNeed) {
  Model model;
  model.parts.push_back(testing::pinAt("3673", {std::sqrt(27.0), 1.0 / 3, 0}, {0, 0, 1}));
  testing::turn(model.parts[0], {0, 0, 1}, 77.7);
  const lattice::Pose& written = model.parts[0].pose;
  const lattice::Pose read = readModel(writeModel(model)).value().parts[0].pose;
  EXPECT_NEAR(read.position.x, written.position.x, 1e-12);
  EXPECT_NEAR(read.rotation.m[0], written.rotation.m[0], 1e-12);
}

TEST(ModelJson, RefusesAFileBeyondTheLimitBeforeReadingIt) {
  const std::string huge(kMaxModelBytes + 1, ' ');
  const base::Result<Model> read = readModel(huge);
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().message.find("bytes"), std::string::npos);
}

}  // namespace
}  // namespace liftarm::model
