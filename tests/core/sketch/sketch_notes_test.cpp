#include "sketch/sketch_notes.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sketch/closings.h"

namespace liftarm::sketch {
namespace {

std::vector<Note> notesOfLines(const std::string& lines) {
  const base::Result<Reading> reading =
      readDrawing(R"({"format": "technic-sketch", "version": 1, "lines": [)" + lines + "]}");
  EXPECT_TRUE(reading.ok()) << (reading.ok() ? "" : reading.error().message);
  return reading.ok() ? notesOn(reading.value()) : std::vector<Note>{};
}

//! The sentences of one kind.
std::vector<std::string> said(const std::vector<Note>& notes, const std::string& kind) {
  std::vector<std::string> messages;
  for (const Note& note : notes) {
    if (note.kind == kind) {
      messages.push_back(note.message);
    }
  }
  return messages;
}

constexpr const char* kBeam = R"({"from": [0, 0, 0], "to": [8, 0, 0]})";

TEST(SketchNotes, ADrawingOnTheLatticeThatHangsTogetherNeedsNone) {
  EXPECT_TRUE(
      notesOfLines(std::string(kBeam) + R"(, {"from": [3, 0, 0], "to": [3, 0, 5]})").empty());
}

TEST(SketchNotes, WhatSnappingMovesIsTold) {
  const auto moved = said(notesOfLines(R"({"from": [0, 0, 0], "to": [7.97, 0, 0]})"), "moved");
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0],
            "lines[0].to was moved by 0.03 modules (0.24 mm), from [7.97, 0, 0] to [8, 0, 0], so "
            "that lines have whole lengths; 1 of 2 line ends were moved");
}

TEST(SketchNotes, RoundedCoordinatesAreNotCalledMoved) {
  EXPECT_TRUE(
      said(notesOfLines(R"({"from": [0, 0, 0], "to": [7.071068, 0, 7.071068]})"), "moved").empty());
}

TEST(SketchNotes, LengthsThatDoNotCloseAreNamedWithTheNearestThatDo) {
  const auto open = said(notesOfLines(R"({"from": [0, 0, 0], "to": [12, 0, 0]},
                                         {"from": [12, 0, 0], "to": [12, 0, 12]},
                                         {"from": [0, 0, 0], "to": [12, 0, 12]})"),
                         "open");
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].rfind("lines[2] is 16.9706 modules long as drawn; its length of 17 does not "
                          "close",
                          0),
            0U)
      << open[0];
  EXPECT_NE(open[0].find("; nearest that close: 9 by 12 (length 15) or 12 by 16 (length 20)"),
            std::string::npos)
      << open[0];
}

TEST(SketchNotes, LinesThatNearlyTouchAreNamedWithTheirGap) {
  for (const double gap : {0.06, 0.09}) {
    const std::string z = std::to_string(gap);
    const auto notes = notesOfLines(std::string(kBeam) + R"(, {"from": [3, 0, )" + z +
                                    R"(], "to": [3, 0, )" + std::to_string(5 + gap) + "]}");
    const auto near = said(notes, "near");
    ASSERT_EQ(near.size(), 1U) << gap;
    EXPECT_EQ(near[0].rfind("lines[0] and lines[1] come within " + z.substr(0, 4) + " modules", 0),
              0U)
        << near[0];
    EXPECT_NE(near[0].find("moving lines[1] by [0, 0, -" + z.substr(0, 4) + "] would"),
              std::string::npos)
        << near[0];
  }
}

TEST(SketchNotes, ParallelLinesThatNearlyTouchAreNamedToo) {
  const auto near =
      said(notesOfLines(std::string(kBeam) + R"(, {"from": [8.08, 0, 0], "to": [12.08, 0, 0]})"),
           "near");
  ASSERT_EQ(near.size(), 1U);
  EXPECT_NE(near[0].find("come within 0.08 modules (0.64 mm)"), std::string::npos) << near[0];
}

TEST(SketchNotes, LinesOfOneNodeAreNotNearMisses) {
  // 3.6 degrees between them: their first nodes are 0.06 apart.
  EXPECT_TRUE(said(notesOfLines(std::string(kBeam) +
                                R"(, {"from": [0, 0, 0], "to": [7.98424, 0, 0.50196]})"),
                   "near")
                  .empty());
}

TEST(SketchNotes, ACrossingBetweenNodesSaysWhatWouldMendIt) {
  const auto crossing = said(notesOfLines(R"({"from": [0, 0, 0], "to": [5, 0, 0]},
                                             {"from": [2.5, -3, 0], "to": [2.5, 3, 0]})"),
                             "crossing");
  ASSERT_EQ(crossing.size(), 1U);
  EXPECT_EQ(crossing[0],
            "lines[0] and lines[1] cross at [2.5, 0, 0] between their nodes, where no pin can join "
            "them; moving lines[1] by [0.5, 0, 0] would put nodes of both there");
}

TEST(SketchNotes, PiecesAreToldWithTheirGapAndWhatWouldJoinThem) {
  const auto far = said(
      notesOfLines(std::string(kBeam) + R"(, {"from": [20, 0, 0], "to": [26, 0, 0]})"), "pieces");
  ASSERT_EQ(far.size(), 2U);
  EXPECT_EQ(far[0], "the sketch is 2 pieces that nothing joins; each is built on its own");
  EXPECT_EQ(far[1],
            "the piece of lines[1] is 12 modules (96 mm) from the piece of lines[0], from node "
            "[20, 0, 0] to node [8, 0, 0]; a line between them, 12 long, would join them");
  const auto beside = said(
      notesOfLines(std::string(kBeam) + R"(, {"from": [0, 0.5, 0], "to": [8, 0.5, 0]})"), "pieces");
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_NE(beside[1].find("; moving the one by [0, -0.5, 0] would join them"), std::string::npos)
      << beside[1];
}

TEST(SketchNotes, ManyPiecesAreCountedAndAFewTold) {
  std::string lines = kBeam;
  for (int i = 1; i < 50; ++i) {
    lines += R"(, {"from": [0, )" + std::to_string(3 * i) + R"(, 0], "to": [8, )" +
             std::to_string(3 * i) + ", 0]}";
  }
  const auto pieces = said(notesOfLines(lines), "pieces");
  ASSERT_EQ(pieces.size(), static_cast<std::size_t>(1 + kMostNotes));
  EXPECT_EQ(pieces[0].rfind("the sketch is 50 pieces", 0), 0U);
}

TEST(Closings, AreTheNearestWholeTriangles) {
  Line line;
  line.to = {12, 0, 5};
  ASSERT_FALSE(nearestClosings(line).empty());
  EXPECT_EQ(nearestClosings(line).front().length, 13);  // closes itself
  line.to = {12, 0, 0};
  EXPECT_TRUE(nearestClosings(line).empty());
}

//! Notes of one kind on what the first mend of that kind makes of a drawing.
std::vector<std::string> saidOnceMended(const std::string& lines, const std::string& kind) {
  base::Result<Reading> reading =
      readDrawing(R"({"format": "technic-sketch", "version": 1, "lines": [)" + lines + "]}");
  EXPECT_TRUE(reading.ok());
  Sketch sketch = reading.value().sketch;
  for (const Note& note : notesOn(reading.value())) {
    if (note.kind != kind || note.mend.empty()) {
      continue;
    }
    for (const MendedLine& mended : note.mend) {
      Line line;
      line.from = mended.from;
      line.to = mended.to;
      if (mended.line < 0) {
        sketch.lines.push_back(line);
      } else {
        sketch.lines[static_cast<std::size_t>(mended.line)] = line;
      }
    }
    reading = readDrawing(writeSketch(sketch));
    EXPECT_TRUE(reading.ok()) << (reading.ok() ? "" : reading.error().message);
    return said(notesOn(reading.value()), kind);
  }
  ADD_FAILURE() << "nothing mends " << lines;
  return {};
}

TEST(SketchNotes, TheMendOfANearMissJoinsTheLines) {
  EXPECT_TRUE(
      saidOnceMended(std::string(kBeam) + R"(, {"from": [3, 0, 0.09], "to": [3, 0, 5.09]})", "near")
          .empty());
}

TEST(SketchNotes, TheMendOfANearMissBringsNodesTogetherAndTakesThePieceAlong) {
  const std::string lines =
      std::string(kBeam) + R"(, {"from": [3.4, 0, 0.09], "to": [3.4, 0, 5.09]},
                                                      {"from": [3.4, 0, 5.09], "to": [7.4, 0, 5.09]})";
  EXPECT_TRUE(saidOnceMended(lines, "near").empty());
  EXPECT_EQ(said(notesOfLines(lines), "pieces").size(), 2U);
  EXPECT_EQ(saidOnceMended(lines, "pieces").size(), 0U);
}

TEST(SketchNotes, TheMendOfACrossingPutsNodesThere) {
  EXPECT_TRUE(saidOnceMended(R"({"from": [0, 0, 0], "to": [5, 0, 0]},
                                {"from": [2.5, -3, 0], "to": [2.5, 3, 0]})",
                             "crossing")
                  .empty());
}

TEST(SketchNotes, TheMendOfTwoPiecesIsALineOrAShift) {
  for (const char* other : {R"({"from": [20, 0, 0], "to": [26, 0, 0]})",
                            R"({"from": [0, 0.5, 0], "to": [8, 0.5, 0]})"}) {
    EXPECT_TRUE(saidOnceMended(std::string(kBeam) + ", " + other, "pieces").empty()) << other;
  }
}

TEST(SketchNotes, WhatSnappingMovedCanBeDrawnSo) {
  EXPECT_TRUE(saidOnceMended(R"({"from": [0, 0, 0], "to": [7.97, 0, 0]})", "moved").empty());
}

}  // namespace
}  // namespace liftarm::sketch
