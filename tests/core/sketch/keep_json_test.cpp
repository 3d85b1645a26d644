#include "sketch/keep_json.h"

#include <gtest/gtest.h>

#include "sketch/sketch_colours.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {
namespace {

constexpr const char* kKept = R"({
  "format": "technic-sketch",
  "version": 2,
  "lines": [
    {"from": [0, 0, 0], "to": [8, 0, 0]},
    {"from": [8, 0, 0], "to": [8, 0, 6]}
  ],
  "keep": [
    {"line": 0, "parts": [{"part": "32526", "from": 4, "to": 8, "layer": 0, "holeAxis": "y", "with": [{"line": 1, "from": 0, "to": 2}]}], "barred": [{"part": "40490", "from": 0, "to": 8}]},
    {"line": 1, "layers": [-1, 0], "splits": [3]}
  ]
}
)";

std::string withKeep(const std::string& keep) {
  return R"({"format": "technic-sketch", "version": 2, "lines": [{"from": [0, 0, 0],
    "to": [8, 0, 0]}], "keep": )" +
         keep + "}";
}

std::string keepRefusal(const std::string& keep) {
  const base::Result<Sketch> read = readSketch(withKeep(keep));
  return read.ok() ? "" : read.error().message;
}

TEST(Keep, WhatIsWrittenReadsAsTheSame) {
  const Sketch sketch = readSketch(kKept).value();
  EXPECT_EQ(writeSketch(sketch, {}, keepsOf(kKept, sketch)), kKept);
}

TEST(Keep, StandsBesideColours) {
  SketchColours colours;
  colours.parts.push_back({"40490", {4, 0, 1}, 4});
  const Sketch sketch = readSketch(kKept).value();
  const std::string text = writeSketch(sketch, colours, keepsOf(kKept, sketch));
  const base::Result<Sketch> again = readSketch(text);
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(keepsOf(text, again.value()).size(), 2U);
  EXPECT_EQ(coloursOf(text).parts.size(), 1U);
}

TEST(Keep, ARefusalNamesThePart) {
  EXPECT_EQ(keepRefusal(R"([{"line": 0, "parts": [{"part": "40490", "from": 0, "to": 8, "layer": 3,
                          "holeAxis": "y"}]}])"),
            "keep[0].parts[0].layer: 3 is not a whole number from -2 to 2");
}

TEST(Keep, ALineIsNamedOnce) {
  EXPECT_EQ(keepRefusal(R"([{"line": 0, "layers": [0]}, {"line": 0, "splits": [4]}])"),
            "keep[1].line: line 0 has an element already");
}

TEST(Keep, APartBeginsOnItsLineOrBeforeIt) {
  EXPECT_NE(keepRefusal(R"([{"line": 0, "barred": [{"part": "40490", "from": 9, "to": 12}]}])"),
            "");
}

}  // namespace
}  // namespace liftarm::sketch
