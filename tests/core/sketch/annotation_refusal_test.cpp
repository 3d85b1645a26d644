#include <string>

#include <gtest/gtest.h>

#include "core/sketch/sketch_text.h"

namespace liftarm::sketch {
namespace {

using liftarm::testing::lineText;
using liftarm::testing::refusalOf;
using liftarm::testing::sketchText;

//! Three lines that meet at (5, 0, 0); a fourth apart from them.
std::string withLines(const std::string& annotations) {
  return sketchText(lineText("0,0,0", "5,0,0") + "," + lineText("5,0,0", "5,0,5") + "," +
                        lineText("5,0,0", "5,3,0") + "," + lineText("9,0,0", "9,0,3"),
                    annotations);
}

std::string joint(const std::string& members) {
  return withLines(R"("joints": [{)" + members + "}]");
}

std::string jointBetween(const std::string& groups) {
  return joint(R"("at": [5,0,0], "axis": [0,1,0], "between": )" + groups);
}

std::string symmetry(const std::string& members) {
  return withLines(R"("symmetries": [{)" + members + "}]");
}

struct Row {
  std::string text;
  std::string message;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.text;
}

class AnnotationRefused : public ::testing::TestWithParam<Row> {};

TEST_P(AnnotationRefused, WithOneMessageThatNamesThePlace) {
  EXPECT_EQ(refusalOf(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Joints,
    AnnotationRefused,
    ::testing::Values(
        Row{joint(R"("axis": [0,1,0])"), "joints[0].at: missing; expected three numbers [x, y, z]"},
        Row{joint(R"("at": [5,0,0])"), "joints[0].axis: missing; expected a direction [x, y, z]"},
        Row{joint(R"("at": [5,0,0], "axis": [0,0,0])"),
            "joints[0].axis: a direction must not be zero; expected for example [0, 0, 1]"},
        Row{joint(R"("at": [4.5,0,0], "axis": [0,1,0])"),
            "joints[0].at: [4.5, 0, 0] is no node of any line; expected a point a whole number of "
            "modules from a line's end"},
        Row{joint(R"("at": [9,0,1], "axis": [0,1,0])"),
            "joints[0].between: only line 3 has a node here; a joint needs two lines"},
        Row{joint(R"("at": [5,0,0], "axis": [0,1,0])"),
            "joints[0].between: missing; 3 lines meet here (0, 1, 2), so name the groups, such "
            "as [[0], [1, 2]]"},
        Row{jointBetween("[[0], [1, 4]]"),
            "joints[0].between[1][1]: there is no line 4; lines are numbered 0 to 3"},
        Row{jointBetween("[[0], [-1]]"),
            "joints[0].between[1][0]: there is no line -1; lines are numbered 0 to 3"},
        Row{jointBetween("[[0], [1.5]]"),
            "joints[0].between[1][0]: expected the number of a line, found the number 1.5"},
        Row{jointBetween("[[0], [1, 3]]"), "joints[0].between[1]: line 3 has no node at [5, 0, 0]"},
        Row{jointBetween("[[0], [1, 0]]"),
            "joints[0].between: line 0 stands in two groups; a line moves with one of them"},
        Row{jointBetween("[[0], [1, 1]]"), "joints[0].between[1]: line 1 is named twice"},
        Row{jointBetween("[[0], []]"), "joints[0].between[1]: expected at least one line number"},
        Row{jointBetween("[[0]]"),
            "joints[0].between: expected 2 to 16 groups of line numbers, such as [[0], [1, 2]], "
            "found an array of 1"},
        Row{withLines(R"("joints": {})"),
            "joints: expected an array of objects, found an object"}));

INSTANTIATE_TEST_SUITE_P(
    Symmetries,
    AnnotationRefused,
    ::testing::Values(
        Row{withLines(R"("symmetries": [4])"),
            "symmetries[0]: expected an object in braces, found the number 4"},
        Row{symmetry(R"("normal": [1,0,0])"),
            "symmetries[0].kind: missing; expected \"reflection\" or \"translation\""},
        Row{symmetry(R"("kind": "rotation")"),
            "symmetries[0].kind: \"rotation\" is not known; expected \"reflection\" or "
            "\"translation\""},
        Row{symmetry(R"("kind": "reflection", "normal": [1,0,0])"),
            "symmetries[0].offset: missing; expected a number of modules"},
        Row{symmetry(R"("kind": "reflection", "normal": [0,0,0], "offset": 1)"),
            "symmetries[0].normal: a direction must not be zero; expected for example [0, 0, 1]"},
        Row{symmetry(R"("kind": "reflection", "normal": [1,0,0], "offset": 1, "lines": [7])"),
            "symmetries[0].lines[0]: there is no line 7; lines are numbered 0 to 3"},
        Row{symmetry(R"("kind": "reflection", "normal": [1,0,0], "offset": 1, "pairs": [])"),
            "symmetries[0]: unknown key \"pairs\"; known keys here: kind, normal, offset, lines"},
        Row{symmetry(R"("kind": "translation", "vector": [0,0,0], "pairs": [[0,1]])"),
            "symmetries[0].vector: a shift must not be zero"},
        Row{symmetry(R"("kind": "translation", "vector": [0,0,1])"),
            "symmetries[0].pairs: missing; expected pairs of line numbers, such as [[0, 1]]"},
        Row{symmetry(R"("kind": "translation", "vector": [0,0,1], "pairs": [[0]])"),
            "symmetries[0].pairs[0]: expected two line numbers: a line and its image"},
        Row{symmetry(R"("kind": "translation", "vector": [0,0,1], "pairs": [[0,0]])"),
            "symmetries[0].pairs[0]: line 0 is named twice"}));

INSTANTIATE_TEST_SUITE_P(
    Boxes,
    AnnotationRefused,
    ::testing::Values(Row{withLines(R"("keepOut": [{"min": [0,0,0]}])"),
                          "keepOut[0].max: missing; expected three numbers [x, y, z]"},
                      Row{withLines(R"("keepOut": [{"min": [1,2,3], "max": [2,1,4]}])"),
                          "keepOut[0].min[1]: 2 is above max[1], which is 1"},
                      Row{withLines(R"("keepOut": [{"min": [0,0,0], "max": [0,0,9000]}])"),
                          "keepOut[0].max[2]: 9000 is outside the limit of -2000 to 2000"}));

}  // namespace
}  // namespace liftarm::sketch
