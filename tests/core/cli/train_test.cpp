#include <string>

#include <nlohmann/json.hpp>

#include "core/cli/command.h"

namespace liftarm::cli {
namespace {

using testing::Command;
using testing::Outcome;

TEST_F(Command, TellsTheGearsThatCoupleTwoShafts) {
  const Outcome told = run("train 3 0 --ratio 5 --json");
  ASSERT_EQ(told.exitCode, 0) << told.err;
  const auto train = nlohmann::json::parse(told.out);
  EXPECT_EQ(train.at("ratio"), 5.0);
  EXPECT_EQ(train.at("shafts").at(0).at("gears").at(0).at("part"), "10928");
  EXPECT_EQ(train.at("shafts").at(1).at("gears").at(0).at("part"), "3649");
}

TEST_F(Command, SaysWhereNoGearsCoupleThem) {
  EXPECT_EQ(run("train 1 0 --ratio 0.96").exitCode, 2);
}

TEST_F(Command, RefusesATrainFromAShaftToItself) {
  EXPECT_EQ(run("train 0 0").exitCode, 1);
}

}  // namespace
}  // namespace liftarm::cli
