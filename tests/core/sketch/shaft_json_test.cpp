#include "sketch/shaft_json.h"

#include <string>

#include <gtest/gtest.h>

#include "sketch/sketch_colours.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {
namespace {

std::string turning(const std::string& members) {
  return R"({"format": "technic-sketch", "version": 2,
             "lines": [{"from": [0, 0, 0], "to": [6, 0, 0]}])" +
         members + "}";
}

std::string messageOf(const std::string& members) {
  const auto read = readSketch(turning(members));
  return read.ok() ? "" : read.error().message;
}

const char* const kPair =
    R"(, "shafts": [{"from": [1, -1, 0], "to": [1, 4, 0]}, {"from": [4, 4, 0], "to": [4, -1, 0]}])";

TEST(ShaftJson, WhatIsWrittenReadsBackTheSame) {
  const std::string text = turning(
      std::string(kPair) + R"(, "drives": [{"from": 0, "to": 1, "ratio": 2.5, "tolerance": 1}])");
  const auto sketch = readSketch(text);
  ASSERT_TRUE(sketch.ok()) << sketch.error().message;
  const Shafts shafts = shaftsOf(text);
  const std::string written = writeSketch(sketch.value(), {}, {}, shafts);
  const Shafts again = shaftsOf(written);
  ASSERT_EQ(again.shafts.size(), 2U);
  EXPECT_EQ(again.shafts[1].from, (lattice::Cell{4, 4, 0}));
  ASSERT_EQ(again.drives.size(), 1U);
  EXPECT_EQ(again.drives[0].ratio, 2.5);
  EXPECT_EQ(again.drives[0].tolerance, 1.0);
  EXPECT_TRUE(readSketch(written).ok());
}

TEST(ShaftJson, KeepsWhatSitsAtItsEnds) {
  const std::string text = turning(
      R"(, "shafts": [{"from": [1, -1, 0], "to": [1, 4, 0], "atFrom": "crank", "atTo": "wheel"}])");
  const std::string written = writeSketch(readSketch(text).value(), {}, {}, shaftsOf(text));
  const Shafts again = shaftsOf(written);
  ASSERT_EQ(again.shafts.size(), 1U);
  EXPECT_EQ(again.shafts[0].atFrom, ShaftEnd::kCrank);
  EXPECT_EQ(again.shafts[0].atTo, ShaftEnd::kWheel);
}

TEST(ShaftJson, RefusesWhatCannotSitAtAnEnd) {
  EXPECT_EQ(messageOf(R"(, "shafts": [{"from": [1, 0, 0], "to": [1, 4, 0], "atTo": "sail"}])"),
            "shafts[0].atTo: expected \"crank\" or \"wheel\"");
}

TEST(ShaftJson, SaysWhereAShaftLeavesTheLattice) {
  EXPECT_EQ(messageOf(R"(, "shafts": [{"from": [1, -1, 0.5], "to": [1, 4, 0.5]}])"),
            "shafts[0].from: 0.5 is not on the lattice; shafts lie on whole modules");
}

TEST(ShaftJson, RefusesARatioOfNothing) {
  EXPECT_EQ(messageOf(std::string(kPair) + R"(, "drives": [{"from": 0, "to": 1, "ratio": 0}])"),
            "drives[0].ratio: 0; expected 0.001 to 1000");
}

TEST(ShaftJson, KnowsTheLongestAxle) {
  EXPECT_EQ(messageOf(R"(, "shafts": [{"from": [1, 0, 0], "to": [1, 12, 0]}])"),
            "shafts[0]: 12 modules long; the longest axle reaches over 11");
  EXPECT_EQ(messageOf(R"(, "shafts": [{"from": [1, 0, 0], "to": [1, 11, 0]}])"), "");
}

}  // namespace
}  // namespace liftarm::sketch
