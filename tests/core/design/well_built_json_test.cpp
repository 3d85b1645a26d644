#include "design/well_built_json.h"

#include <gtest/gtest.h>

#include "core/helpers/models.h"
#include "core/helpers/solved.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

//! The item that a check of a model with a pin too many speaks of.
json cleanOf(const json& report) {
  for (const json& item : report.at("wellBuilt").at("items")) {
    if (item.at("id") == "clean") {
      return item;
    }
  }
  return {};
}

json checked(const model::Model& model) {
  return json::parse(checkModelJson(model::writeModel(model)).value());
}

TEST(WellBuiltJson, CountsTheItemsThatHold) {
  const json wellBuilt = checked(testing::squareFrame()).at("wellBuilt");
  EXPECT_EQ(wellBuilt.at("of"), 6);
  int passed = 0;
  for (const json& item : wellBuilt.at("items")) {
    passed += item.at("ok").get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(wellBuilt.at("passed"), passed);
}

TEST(WellBuiltJson, PlacesNameThePartsToLight) {
  model::Model model = testing::squareFrame();
  model.parts.push_back(testing::pinAt("2780", {4, 0, 0.5}, {0, 0, 1}));
  const json clean = cleanOf(checked(model));
  EXPECT_EQ(clean.at("figures").at("nakedHeads"), 1);
  EXPECT_EQ(clean.at("places").at(0).at("parts"), json::array({8}));
  EXPECT_EQ(clean.at("places").at(0).at("at"), json::array({4, 0, 1}));
}

TEST(WellBuiltJson, SearchAndCheckSayTheSame) {
  const testing::Solved solved =
      testing::solve(sketch::readSketch(testing::sketchOf({{{0, 0, 0}, {8, 0, 0}},
                                                           {{8, 0, 0}, {8, 8, 0}},
                                                           {{0, 0, 0}, {0, 0, 8}}}))
                         .value());
  EXPECT_EQ(solved.report.at("wellBuilt"), checked(solved.model).at("wellBuilt"));
}

}  // namespace
}  // namespace liftarm::design
