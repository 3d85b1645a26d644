#include "design/settings.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "layout/bent_beam.h"
#include "rivals/rivals.h"

namespace liftarm::design {
namespace {

struct BadSettings {
  const char* text;
  const char* names;  //!< what the message must name
};

struct RefusedSettings : ::testing::TestWithParam<BadSettings> {};

TEST_P(RefusedSettings, GiveOneMessageThatNamesThePlace) {
  const base::Result<Settings> settings = readSettings(GetParam().text);
  ASSERT_FALSE(settings.ok()) << GetParam().text;
  EXPECT_EQ(settings.error().status, base::Status::kInvalidInput);
  EXPECT_NE(settings.error().message.find(GetParam().names), std::string::npos)
      << settings.error().message;
  EXPECT_EQ(settings.error().message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    RefusedSettings,
    ::testing::Values(BadSettings{"{", "settings"},
                      BadSettings{"[]", "settings"},
                      BadSettings{"7", "settings"},
                      BadSettings{"null", "settings"},
                      BadSettings{R"({"sed": 1})", "sed"},
                      BadSettings{R"({"seed": -1})", "seed"},
                      BadSettings{R"({"seed": 1.5})", "seed"},
                      BadSettings{R"({"seed": 1e300})", "seed"},
                      BadSettings{R"({"seed": "many"})", "seed"},
                      BadSettings{R"({"seed": null})", "seed"},
                      BadSettings{R"({"preset": "cheap"})", "cheap"},
                      BadSettings{R"({"preset": 3})", "preset"},
                      BadSettings{R"({"method": "magic"})", "magic"},
                      BadSettings{R"({"set": 3})", "set"},
                      BadSettings{R"({"set": {"wrong": 1}})", "set.wrong"},
                      BadSettings{R"({"set": {"weights.none": 1}})", "set.weights.none"},
                      BadSettings{R"({"set": {"weights.beams": -1}})", "set.weights.beams"},
                      BadSettings{R"({"set": {"weights.beams": 1e9}})", "set.weights.beams"},
                      BadSettings{R"({"set": {"weights.beams": "x"}})", "set.weights.beams"},
                      BadSettings{R"({"set": {"effort": 0}})", "set.effort"},
                      BadSettings{R"({"set": {"effort": 1e6}})", "set.effort"},
                      BadSettings{R"({"set": {"effort": [1]}})", "set.effort"},
                      BadSettings{R"({"set": {"starts": 0}})", "set.starts"},
                      BadSettings{R"({"set": {"rounds": -1}})", "set.rounds"},
                      BadSettings{R"({"set": {"startTemperature": 0}})", "set.startTemperature"},
                      BadSettings{R"({"set": {"endTemperature": "hot"}})", "set.endTemperature"},
                      BadSettings{R"({"set": {"mechanismParts": 4}})", "set.mechanismParts"},
                      BadSettings{R"({"set": {"search.many": 2}})", "search.many"},
                      BadSettings{R"({"set": {"search.none": 1}})", "search.none"},
                      BadSettings{R"({"set": {"paper.coolingRate": 1}})", "paper.coolingRate"},
                      BadSettings{R"({"set": {"paper.schedule": "icy"}})", "linear, logarithmic"},
                      BadSettings{R"({"set": {"lengths": "2,4"}})", "4"},
                      BadSettings{R"({"set": {"lengths": ""}})", "set.lengths"},
                      BadSettings{R"({"set": {"bent": "32524"}})", "set.bent"},
                      BadSettings{R"({"set": {"axles": "3713"}})", "set.axles"},
                      BadSettings{R"({"set": {"lengths": "two"}})", "two"},
                      BadSettings{R"({"set": {"connectors": "2780,nothing"}})", "nothing"}));

// Not refused yet: a fraction is cut off, no connector at all and a beam as connector are taken.
INSTANTIATE_TEST_SUITE_P(
    TooLenient,
    RefusedSettings,
    ::testing::Values(BadSettings{R"({"set": {"starts": 2.5}})", "set.starts"},
                      BadSettings{R"({"set": {"mechanismParts": 1.5}})", "set.mechanismParts"},
                      BadSettings{R"({"set": {"connectors": ""}})", "set.connectors"},
                      BadSettings{R"({"set": {"connectors": "32316"}})", "32316"}));

TEST(Settings, OfAnEmptyObjectAreTheDefaults) {
  const base::Result<Settings> settings = readSettings("{}");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settingsJson(settings.value()), settingsJson(readSettings("").value()));
}

TEST(Settings, OfThePresetBalancedAreTheDefaults) {
  const base::Result<Settings> settings = readSettings(R"({"preset": "balanced"})");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settingsJson(settings.value()), settingsJson(readSettings("").value()));
}

TEST(Settings, TakeNumbersAsTextFromTheCommandLine) {
  const base::Result<Settings> settings =
      readSettings(R"({"seed": "7", "set": {"starts": "12", "weights.beams": "3.5"}})");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settings.value().annealing.seed, 7U);
  EXPECT_EQ(settings.value().annealing.starts, 12);
  EXPECT_EQ(settings.value().annealing.weights[*objective::termIndex("beams")], 3.5);
}

TEST(Settings, KeepAWeightThatIsSetBesideAPreset) {
  const base::Result<Settings> settings =
      readSettings(R"({"set": {"weights.beams": 3}, "preset": "faithful"})");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settings.value().annealing.weights[*objective::termIndex("beams")], 3.0);
}

TEST(Settings, OfThePaperTakeItsWeightsWhateverTheOrder) {
  const base::Result<Settings> settings =
      readSettings(R"({"preset": "faithful", "method": "paper"})");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settings.value().annealing.weights,
            objective::paperWeights(objective::Preset::kFaithful));
}

TEST(Settings, TakeEveryRivalAsAMethodWithThePapersWeights) {
  for (const std::string_view rival : rivals::rivalNames()) {
    const base::Result<Settings> settings =
        readSettings(R"({"preset": "simple", "method": ")" + std::string(rival) + "\"}");
    ASSERT_TRUE(settings.ok()) << rival;
    EXPECT_EQ(settings.value().annealing.weights,
              objective::paperWeights(objective::Preset::kSimple));
  }
}

TEST(Settings, NameAllMethodsWhereOneIsUnknown) {
  const base::Result<Settings> settings = readSettings(R"({"method": "magic"})");
  ASSERT_FALSE(settings.ok());
  for (const std::string_view rival : rivals::rivalNames()) {
    EXPECT_NE(settings.error().message.find(rival), std::string::npos) << rival;
  }
}

TEST(Settings, TakeASchedule) {
  const auto cooled = [](const std::string& name) {
    const auto settings = readSettings(R"({"set": {"paper.schedule": ")" + name + "\"}}");
    return settings.ok() && settings.value().paper.cooling;
  };
  EXPECT_TRUE(cooled("linear"));
  EXPECT_FALSE(cooled("exponential"));
}

TEST(Settings, SwitchOffAPartOfTheSearch) {
  const base::Result<Settings> settings = readSettings(R"({"set": {"search.many": "0"}})");
  ASSERT_TRUE(settings.ok());
  EXPECT_FALSE(settings.value().annealing.parts.many);
  EXPECT_TRUE(settings.value().annealing.parts.focus);
}

TEST(Settings, SortTheLengths) {
  const base::Result<Settings> settings = readSettings(R"({"set": {"lengths": "15,3,5"}})");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settings.value().annealing.lengths, (std::vector<int>{3, 5, 15}));
}

TEST(Settings, TakeEachLengthOnce) {
  const base::Result<Settings> settings = readSettings(R"({"set": {"lengths": "3,5,3"}})");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settings.value().annealing.lengths, (std::vector<int>{3, 5}));
}

TEST(Settings, TakeBentBeamsByTheirNumber) {
  const base::Result<Settings> settings = readSettings(R"({"set": {"bent": "60484,32526"}})");
  ASSERT_TRUE(settings.ok());
  std::vector<std::string> parts;
  for (const int form : settings.value().annealing.bends) {
    parts.push_back(layout::bentBeams()[static_cast<std::size_t>(form)].part);
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"32526", "60484"}));
}

TEST(Settings, TakeNoBentBeamAtAll) {
  const base::Result<Settings> settings = readSettings(R"({"set": {"bent": ""}})");
  ASSERT_TRUE(settings.ok());
  EXPECT_TRUE(settings.value().annealing.bends.empty());
}

TEST(Settings, TakeAxlesByTheirNumber) {
  const base::Result<Settings> settings = readSettings(R"({"set": {"axles": "3708,4519"}})");
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settings.value().annealing.axles,
            (std::vector<int>{layout::axlePartIndex("4519"), layout::axlePartIndex("3708")}));
}

TEST(Settings, LetNoAxleCoverALineWithoutBushes) {
  const base::Result<Settings> settings = readSettings(R"({"set": {"connectors": "2780,15462"}})");
  ASSERT_TRUE(settings.ok());
  EXPECT_TRUE(settings.value().annealing.axles.empty());
}

TEST(Settings, HaveEveryWeightInTheirJson) {
  const nlohmann::json json = nlohmann::json::parse(settingsJson(Settings{}));
  for (const objective::Term& term : objective::kTerms) {
    EXPECT_TRUE(json["weights"].contains(std::string(term.name))) << term.name;
  }
}

TEST(Settings, ATextOfAnyDepthIsOneMessage) {
  const std::string deep =
      R"({"set": {"effort": )" + std::string(200000, '[') + std::string(200000, ']') + "}}";
  const base::Result<Settings> settings = readSettings(deep);
  ASSERT_FALSE(settings.ok());
  EXPECT_NE(settings.error().message.find("deep inside each other"), std::string::npos);
  EXPECT_LT(settings.error().message.size(), 200U);
}

}  // namespace
}  // namespace liftarm::design
