#include "sketch/sketch_colours.h"

#include <string>

#include <gtest/gtest.h>

#include "sketch/sketch_json.h"

namespace liftarm::sketch {
namespace {

std::string textWith(const std::string& colours, int version = 2) {
  return R"({"format": "technic-sketch", "version": )" + std::to_string(version) +
         R"(, "lines": [{"from": [0, 0, 0], "to": [4, 0, 0]}, {"from": [0, 0, 0], "to": [0, 4, 0]}])" +
         (colours.empty() ? "" : R"(, "colours": )" + colours) + "}";
}

std::string refusal(const std::string& colours) {
  const base::Result<Sketch> sketch = readSketch(textWith(colours));
  return sketch.ok() ? "" : sketch.error().message;
}

TEST(SketchColours, AreReadInVersionTwo) {
  const std::string text = textWith(
      R"({"scheme": "component", "default": 71, "kinds": {"pin": 4}, "lines": {"1": 14}})");
  ASSERT_TRUE(readSketch(text).ok());
  const SketchColours colours = coloursOf(text);
  EXPECT_EQ(colours.scheme, "component");
  EXPECT_EQ(colours.standard, 71);
  EXPECT_EQ(colours.kinds.at("pin"), 4);
  EXPECT_EQ(colours.lines.at(1), 14);
}

TEST(SketchColours, VersionOneHasNone) {
  EXPECT_TRUE(coloursOf(textWith("", 1)).empty());
  EXPECT_FALSE(readSketch(textWith("{}", 1)).ok());
}

TEST(SketchColours, VersionTwoNeedsNone) {
  EXPECT_TRUE(readSketch(textWith("")).ok());
}

TEST(SketchColours, WrongOnesAreRefusedByTheirPlace) {
  EXPECT_EQ(refusal("3"), "colours: expected an object in braces, found the number 3");
  EXPECT_EQ(refusal(R"({"scheme": "pink"})"),
            "colours.scheme: \"pink\" is not known; expected one of length, component, usual");
  EXPECT_EQ(refusal(R"({"default": 16})"),
            "colours.default: 16 is no colour; expected an LDraw code from 0 to 511");
  EXPECT_EQ(refusal(R"({"default": 1.5})"),
            "colours.default: 1.5 is no colour; expected an LDraw code from 0 to 511");
  EXPECT_EQ(
      refusal(R"({"kinds": {"brick": 4}})"),
      "colours.kinds: \"brick\" is not known; expected one of beam, bent, pin, axle, connector, "
      "bush, gear");
  EXPECT_EQ(refusal(R"({"lines": {"2": 4}})"),
            "colours.lines: \"2\" is no line; expected numbers from 0 to 1");
  EXPECT_EQ(refusal(R"({"lines": {"01": 4}})"),
            "colours.lines: \"01\" is no line; expected numbers from 0 to 1");
}

TEST(SketchColours, AreWrittenSoThatTheyAreReadBack) {
  const std::string text = textWith(R"({"lines": {"1": 14, "0": 4}, "scheme": "usual"})");
  const std::string written = writeSketch(readSketch(text).value(), coloursOf(text));
  ASSERT_TRUE(readSketch(written).ok()) << readSketch(written).error().message;
  EXPECT_EQ(coloursOf(written).lines, coloursOf(text).lines);
  EXPECT_EQ(coloursOf(written).scheme, "usual");
  EXPECT_EQ(writeSketch(readSketch(written).value(), coloursOf(written)), written);
}

TEST(SketchColours, WithoutAnyTheTextIsThatOfVersionOne) {
  const Sketch sketch = readSketch(textWith("", 1)).value();
  EXPECT_EQ(writeSketch(sketch, {}), writeSketch(sketch));
}

}  // namespace
}  // namespace liftarm::sketch
