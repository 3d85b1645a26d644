#include <string>

#include <gtest/gtest.h>

#include "core/sketch/sketch_text.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {
namespace {

using liftarm::testing::lineText;
using liftarm::testing::refusalOf;
using liftarm::testing::sketchText;

const std::string kLine = lineText("0,0,0", "5,0,0");                        // NOLINT
const std::string kThree = kLine + "," + lineText("5,0,0", "5,0,5") + "," +  // NOLINT
                           lineText("5,0,0", "5,3,0");

struct RefusalRow {
  std::string text;
  std::string message;
};

void PrintTo(const RefusalRow& row, std::ostream* out) {
  *out << row.text.substr(0, 200);
}

class Refused : public ::testing::TestWithParam<RefusalRow> {};

TEST_P(Refused, WithOneMessageThatNamesThePlace) {
  EXPECT_EQ(refusalOf(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Texts,
    Refused,
    ::testing::Values(
        RefusalRow{"", "the file is empty; expected a sketch in JSON"},
        RefusalRow{" \n\t", "the file is empty; expected a sketch in JSON"},
        RefusalRow{"{", "line 1, column 2: not valid JSON: the text ends too early"},
        RefusalRow{
            "{\n  \"format\": }",
            "line 2, column 13: not valid JSON: unexpected '}'; expected a value, near \"}\""},
        RefusalRow{
            sketchText(kLine + ","),
            "line 1, column 87: not valid JSON: unexpected ']'; expected a value, near \"]\""},
        RefusalRow{sketchText(kLine) + "x",
                   "line 1, column 88: not valid JSON: invalid literal, near \"x\""},
        RefusalRow{
            "{\"name\": \"\xff\"}",
            "line 1, column 11: not valid JSON: invalid string: ill-formed UTF-8 byte, near \"?\""},
        RefusalRow{
            sketchText(lineText("0,0,NaN", "1,0,0")),
            "line 1, column 68: not valid JSON: NaN is not a JSON number; coordinates must be "
            "finite numbers"},
        RefusalRow{
            sketchText(lineText("0,0,0", "-Infinity,0,0")),
            "line 1, column 80: not valid JSON: -Infinity is not a JSON number; coordinates must "
            "be finite numbers"},
        RefusalRow{sketchText(lineText("0,0,1e999", "1,0,0")),
                   "lines[0].from[2]: the number \"1e999\" is not finite: it is too large for a "
                   "computer's numbers"},
        RefusalRow{std::string(1000000, '['),
                   "[0][0][0][0][0][0][0][0][0][0][0][0]: arrays and objects lie more than 12 deep "
                   "inside each other"},
        RefusalRow{sketchText(R"({"from": [0,0,0], "from": [0,0,0], "to": [1,0,0]})"),
                   "lines[0]: the key \"from\" stands twice in this object"}));

INSTANTIATE_TEST_SUITE_P(
    Heads,
    Refused,
    ::testing::Values(
        RefusalRow{"[]", "not a sketch: expected an object with format, version and lines"},
        RefusalRow{"{}", "format: missing; expected \"technic-sketch\""},
        RefusalRow{R"({"format": 7})", "format: expected a text in quotes, found the number 7"},
        RefusalRow{R"({"format": "gltf", "version": 1})",
                   "format: \"gltf\" is not known; expected \"technic-sketch\""},
        RefusalRow{R"({"format": "technic-sketch"})", "version: missing; expected 1"},
        RefusalRow{R"({"format": "technic-sketch", "version": 3})",
                   "version: 3 is not known; expected 1 or 2"},
        RefusalRow{R"({"format": "technic-sketch", "version": "1"})",
                   "version: expected a number, found the text \"1\""},
        RefusalRow{R"({"format": "technic-sketch", "version": 1})",
                   "lines: missing; expected an array of lines"},
        RefusalRow{R"({"format": "technic-sketch", "version": 1, "lines": {}})",
                   "lines: expected an array of lines, found an object"},
        RefusalRow{sketchText(""), "lines: empty; a sketch has at least one line"},
        RefusalRow{sketchText(kLine, R"("joint": [])"),
                   "unknown key \"joint\", most likely joints; known keys here: format, "
                   "version, name, lines, joints, "
                   "symmetries, keepOut, ground"},
        RefusalRow{sketchText(kLine, R"("name": 5)"),
                   "name: expected a text in quotes, found the number 5"},
        RefusalRow{sketchText(kLine, R"("name": "a\nb")"),
                   "name: holds a line break or another control character"},
        RefusalRow{sketchText(kLine, "\"name\": \"" + std::string(201, 'a') + "\""),
                   "name: longer than 200 bytes"},
        RefusalRow{sketchText(kLine, R"("ground": "low")"),
                   "ground: expected a number, found the text \"low\""}));

INSTANTIATE_TEST_SUITE_P(
    Lines,
    Refused,
    ::testing::Values(
        RefusalRow{sketchText("null"), "lines[0]: expected an object in braces, found null"},
        RefusalRow{sketchText("{}"), "lines[0].from: missing; expected three numbers [x, y, z]"},
        RefusalRow{sketchText(lineText("0,0", "1,0,0")),
                   "lines[0].from: expected three numbers [x, y, z], found an array of 2"},
        RefusalRow{sketchText(kLine + "," + lineText("0,0,0", "0,\"a\",0")),
                   "lines[1].to[1]: expected a number, found the text \"a\""},
        RefusalRow{sketchText(lineText("0,0,0", "3000,0,0")),
                   "lines[0].to[0]: 3000 is outside the limit of -2000 to 2000"},
        RefusalRow{
            sketchText(kThree + "," + lineText("0,0,0", "4.5,0,0")),
            "lines[3]: length 4.5 is not a whole number of modules; nearest: 4 or 5; with the "
            "whole "
            "drawing twice as large it would be 9"},
        RefusalRow{sketchText(lineText("0,0,0", "5,5,0")),
                   "lines[0]: length 7.0711 is not a whole number of modules; nearest: 7 or 8"},
        RefusalRow{sketchText(lineText("0,0,0", "0.4,0,0")),
                   "lines[0]: length 0.4 is not a whole number of modules; nearest: 1"},
        RefusalRow{sketchText(lineText("2,2,2", "2,2,2")),
                   "lines[0]: from and to are the same point; a line is at least 1 module long"},
        RefusalRow{sketchText(lineText("0,0,0", "3,4,12")),
                   "lines[0]: runs 3 along x, 4 along y and 12 along z; a line must lie in a plane "
                   "parallel to XY, YZ or ZX, so one of the three must be 0"},
        RefusalRow{
            sketchText(lineText("0,0,0", "3,0,0", R"("exakt": true)")),
            "lines[0]: unknown key \"exakt\", most likely exact; known keys here: from, to, exact, "
            "holeAxis"},
        RefusalRow{sketchText(lineText("0,0,0", "3,0,0", R"("exact": 1)")),
                   "lines[0].exact: expected true or false, found the number 1"},
        RefusalRow{sketchText(lineText("0,0,0", "3,0,0", R"("holeAxis": "up")")),
                   "lines[0].holeAxis: expected \"x\", \"y\" or \"z\", found the text \"up\""},
        RefusalRow{
            sketchText(lineText("0,0,0", "3,0,0", R"("holeAxis": "x")")),
            "lines[0].holeAxis: x is not perpendicular to the line, which runs along x; expected "
            "y or z"},
        RefusalRow{
            sketchText(lineText("0,0,0", "3,4,0", R"("holeAxis": "y")")),
            "lines[0].holeAxis: y is not perpendicular to the line, which runs along x and y; "
            "expected z"},
        RefusalRow{sketchText(lineText("0,0,0", "3,0,0", R"("holeAxis": "y")") + "," +
                              lineText("2,0,0", "5,0,0", R"("holeAxis": "z")")),
                   "lines[1].holeAxis: z, but line 0 overlaps it and says y; expected the same"}));

std::string repeated(const std::string& element, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += (i == 0 ? "" : ",") + element;
  }
  return text;
}

TEST(RefusedByTolerance, OnlyBeyondFiveHundredths) {
  for (const char* end : {"0.95,0,0", "4.05,0,0", "4,0.05,0.05", "-7.95,0,0"}) {
    EXPECT_TRUE(readSketch(sketchText(lineText("0,0,0", end))).ok()) << end;
  }
  EXPECT_NE(refusalOf(sketchText(lineText("0,0,0", "0.949,0,0"))), "");
}

TEST(RefusedBySize, AFileLargerThanTheLimitWhateverItHolds) {
  EXPECT_EQ(refusalOf(std::string(kMaxSketchBytes + 1, '[')),
            "the file has 8388609 bytes; at most 8388608 are read");
}

TEST(RefusedBySize, MoreLinesThanTheLimitBeforeAnyIsRead) {
  EXPECT_EQ(refusalOf(sketchText(repeated("{}", static_cast<int>(kMaxLines) + 1))),
            "lines: more than 20000 elements; at most 20000 are read");
}

TEST(RefusedBySize, LinesLongerInAllThanTheLimit) {
  EXPECT_EQ(refusalOf(sketchText(repeated(lineText("0,0,0", "1000,0,0"), 101))),
            "lines: together 101000 modules long; at most 100000 are read");
}

TEST(RefusedBySize, MoreAnnotationsThanTheLimit) {
  EXPECT_EQ(refusalOf(sketchText(kLine, "\"keepOut\": [" + repeated("{}", 10001) + "]")),
            "keepOut: 10001 elements; at most 10000 are read");
  EXPECT_EQ(refusalOf(sketchText(kLine, "\"joints\": [" + repeated("{}", 1001) + "]")),
            "joints: 1001 elements; at most 1000 are read");
  EXPECT_EQ(refusalOf(sketchText(kLine, "\"symmetries\": [" + repeated("{}", 501) + "]")),
            "symmetries: 501 elements; at most 500 are read");
}

}  // namespace
}  // namespace liftarm::sketch
