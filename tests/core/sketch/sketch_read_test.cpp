#include <string>

#include <gtest/gtest.h>

#include "core/sketch/sketch_text.h"

namespace liftarm::sketch {
namespace {

using lattice::Axis;
using lattice::Vec3;
using liftarm::testing::lineText;
using liftarm::testing::sketchText;

Sketch readOrFail(const std::string& text) {
  base::Result<Sketch> result = readSketch(text);
  if (!result.ok()) {
    ADD_FAILURE() << result.error().message;
    return {};
  }
  return std::move(result).value();
}

//! Every member of the format, none with its default.
std::string seesaw() {
  return R"({ "format": "technic-sketch", "version": 1, "name": "Seesaw \u00e4",
  "lines": [ {"from": [0,0,0], "to": [6,0,0]},
             {"from": [3,0,0], "to": [3,0,5], "exact": true, "holeAxis": "y"},
             {"from": [0,4,0], "to": [6,4,0]} ],
  "joints": [ {"at": [3,0,0], "axis": [0,2,0], "between": [[0],[1]]} ],
  "symmetries": [ {"kind": "reflection", "normal": [2,0,0], "offset": 6, "lines": [0,1]},
                  {"kind": "translation", "vector": [0,4,0], "pairs": [[0,2]]} ],
  "keepOut": [ {"min": [2,1,1], "max": [8,5.5,5]} ],
  "ground": -0.25 })";
}

TEST(ReadSketch, TakesEveryMemberOfTheFormat) {
  const Sketch sketch = readOrFail(seesaw());
  EXPECT_EQ(sketch.name, "Seesaw \xC3\xA4");
  ASSERT_EQ(sketch.lines.size(), 3U);
  EXPECT_EQ(sketch.lines[1].to, (Vec3{3, 0, 5}));
  EXPECT_EQ(sketch.lines[1].length, 5);
  EXPECT_TRUE(sketch.lines[1].exact);
  EXPECT_EQ(sketch.lines[1].holeAxis, Axis::kY);
  EXPECT_FALSE(sketch.lines[0].exact);
  EXPECT_FALSE(sketch.lines[0].holeAxis.has_value());
  ASSERT_EQ(sketch.joints.size(), 1U);
  EXPECT_EQ(sketch.joints[0].at, (Vec3{3, 0, 0}));
  EXPECT_EQ(sketch.joints[0].between, (std::vector<std::vector<int>>{{0}, {1}}));
  ASSERT_EQ(sketch.symmetries.size(), 2U);
  EXPECT_EQ(sketch.symmetries[0].lines, (std::vector<int>{0, 1}));
  EXPECT_EQ(sketch.symmetries[1].vector, (Vec3{0, 4, 0}));
  EXPECT_EQ(sketch.symmetries[1].pairs, (std::vector<std::pair<int, int>>{{0, 2}}));
  ASSERT_EQ(sketch.keepOut.size(), 1U);
  EXPECT_EQ(sketch.keepOut[0].max, (Vec3{8, 5.5, 5}));
  EXPECT_EQ(sketch.ground, -0.25);
}

TEST(ReadSketch, MakesDirectionsUnitLengthAndKeepsTheMirrorWhereItIs) {
  const Sketch sketch = readOrFail(seesaw());
  EXPECT_EQ(sketch.joints[0].axis, (Vec3{0, 1, 0}));
  EXPECT_EQ(sketch.symmetries[0].normal, (Vec3{1, 0, 0}));
  EXPECT_EQ(sketch.symmetries[0].offset, 3.0);
}

TEST(ReadSketch, NeedsOnlyFormatVersionAndLines) {
  const Sketch sketch = readOrFail(sketchText(lineText("0,0,0", "5,0,0")));
  EXPECT_EQ(sketch.lines.size(), 1U);
  EXPECT_FALSE(sketch.ground.has_value());
}

TEST(ReadSketch, AcceptsOverlapsDuplicatesAndSeveralPieces) {
  const std::string line = lineText("0,0,0", "5,0,0");
  const Sketch sketch = readOrFail(sketchText(line + "," + line + "," + lineText("3,0,0", "8,0,0") +
                                              "," + lineText("0,9,0", "0,9,4")));
  EXPECT_EQ(sketch.lines.size(), 4U);
}

TEST(ReadSketch, AcceptsAJointWithoutGroupsWhereTwoLinesMeet) {
  const Sketch sketch =
      readOrFail(sketchText(lineText("0,0,0", "6,0,0") + "," + lineText("3,0,0", "3,0,5"),
                            R"("joints": [{"at": [3,0,0], "axis": [0,1,0]}])"));
  EXPECT_TRUE(sketch.joints.at(0).between.empty());
}

TEST(ReadSketch, TurnsNegativeZeroIntoZero) {
  const Sketch sketch = readOrFail(sketchText(lineText("-0.0,0,0", "5,0,0")));
  EXPECT_FALSE(std::signbit(sketch.lines[0].from.x));
}

TEST(ReadSketch, CarriesJointsAndTheGroundAlongWhenSnappingMovesTheirNodes) {
  const Sketch sketch = readOrFail(
      sketchText(lineText("0,0,-0.1949", "6,0,-0.1949") + "," + lineText("6,0,-0.1949", "9,0,5") +
                     "," + lineText("9,0,5", "3,0,5"),
                 R"("joints": [{"at": [6,0,-0.1949], "axis": [0,1,0]}], "ground": -0.1949)"));
  EXPECT_EQ(sketch.joints.at(0).at, sketch.lines[0].to);
  EXPECT_EQ(sketch.ground, sketch.lines[0].to.z);
  EXPECT_NE(sketch.ground, -0.1949);
}

TEST(WriteSketch, ReadsBackAsTheSameSketch) {
  const Sketch sketch = readOrFail(seesaw());
  const std::string text = writeSketch(sketch);
  EXPECT_EQ(writeSketch(readOrFail(text)), text);
  EXPECT_EQ(readOrFail(text).symmetries[0].offset, sketch.symmetries[0].offset);
  EXPECT_EQ(readOrFail(text).lines[1].holeAxis, sketch.lines[1].holeAxis);
}

TEST(WriteSketch, WritesShortNumbersAndNoDefaults) {
  const Sketch sketch = readOrFail(sketchText(lineText("0,0,0.50", "5.0,0,0.5")));
  EXPECT_EQ(writeSketch(sketch),
            "{\n  \"format\": \"technic-sketch\",\n  \"version\": 1,\n  \"lines\": [\n"
            "    {\"from\": [0, 0, 0.5], \"to\": [5, 0, 0.5]}\n  ]\n}\n");
}

TEST(WriteSketch, SurvivesANameThatIsNoValidText) {
  Sketch sketch = readOrFail(sketchText(lineText("0,0,0", "5,0,0")));
  sketch.name = "bad \xff byte \"and\" quotes";
  EXPECT_TRUE(readSketch(writeSketch(sketch)).ok());
}

}  // namespace
}  // namespace liftarm::sketch
