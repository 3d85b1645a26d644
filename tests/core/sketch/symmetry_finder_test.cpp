#include "sketch/symmetry_finder.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sketch/sketch_json.h"

namespace liftarm::sketch {
namespace {

using lattice::Vec3;

Sketch drawingOf(const std::vector<std::pair<Vec3, Vec3>>& lines) {
  Sketch sketch;
  for (const auto& [from, to] : lines) {
    Line line;
    line.from = from;
    line.to = to;
    line.length = static_cast<int>(lattice::length(to - from) + 0.5);
    sketch.lines.push_back(line);
  }
  return sketch;
}

Sketch rectangle(double width, double depth) {
  return drawingOf({{{0, 0, 0}, {width, 0, 0}},
                    {{width, 0, 0}, {width, depth, 0}},
                    {{width, depth, 0}, {0, depth, 0}},
                    {{0, depth, 0}, {0, 0, 0}}});
}

Sketch hexagon(double side) {
  std::vector<std::pair<Vec3, Vec3>> lines;
  const double h = side * std::sqrt(0.75);
  const std::vector<Vec3> corners{{side, 0, 0},
                                  {0.5 * side, 0, h},
                                  {-0.5 * side, 0, h},
                                  {-side, 0, 0},
                                  {-0.5 * side, 0, -h},
                                  {0.5 * side, 0, -h}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    lines.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  }
  return drawingOf(lines);
}

//! The mirrors of the whole sketch, as "normal x, y, z at offset".
std::vector<Symmetry> wholeMirrors(const Sketch& sketch) {
  std::vector<Symmetry> mirrors;
  for (const Symmetry& s : findSymmetries(sketch).symmetries) {
    if (s.kind == Symmetry::Kind::kReflection && s.lines.empty()) {
      mirrors.push_back(s);
    }
  }
  return mirrors;
}

bool hasMirror(const std::vector<Symmetry>& mirrors, Vec3 normal, double offset) {
  return std::any_of(mirrors.begin(), mirrors.end(), [&](const Symmetry& s) {
    return lattice::length(s.normal - normal) < 1e-6 && std::abs(s.offset - offset) < 1e-6;
  });
}

TEST(SymmetryFinder, FindsBothMirrorsOfARectangle) {
  const std::vector<Symmetry> mirrors = wholeMirrors(rectangle(6, 4));
  EXPECT_EQ(mirrors.size(), 2U);
  EXPECT_TRUE(hasMirror(mirrors, {1, 0, 0}, 3.0));
  EXPECT_TRUE(hasMirror(mirrors, {0, 1, 0}, 2.0));
}

TEST(SymmetryFinder, FindsTheDiagonalMirrorsOfASquareAfterThePrincipalOnes) {
  const std::vector<Symmetry> mirrors = wholeMirrors(rectangle(6, 6));
  ASSERT_EQ(mirrors.size(), 4U);
  EXPECT_NEAR(std::abs(mirrors[0].normal.x + mirrors[0].normal.y), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(mirrors[3].normal.x), std::sqrt(0.5), 1e-6);
}

TEST(SymmetryFinder, FindsTheSixMirrorsAndTheTurnOfAHexagonOffTheLattice) {
  const FoundSymmetries found = findSymmetries(hexagon(5));
  EXPECT_EQ(wholeMirrors(hexagon(5)).size(), 6U);
  ASSERT_EQ(found.rotations.size(), 1U);
  EXPECT_EQ(found.rotations[0].order, 6);
  EXPECT_NEAR(std::abs(found.rotations[0].axis.y), 1.0, 1e-9);
}

TEST(SymmetryFinder, DoesNotMindHowLinesAreDrawn) {
  Sketch split = rectangle(6, 4);
  // The upper side in two overlapping lines.
  split.lines[2] = drawingOf({{{6, 4, 0}, {2, 4, 0}}}).lines[0];
  split.lines.push_back(drawingOf({{{3, 4, 0}, {0, 4, 0}}}).lines[0]);
  EXPECT_EQ(wholeMirrors(split).size(), 2U);
}

TEST(SymmetryFinder, FindsNothingInACrookedSketch) {
  const FoundSymmetries found = findSymmetries(
      drawingOf({{{0, 0, 0}, {6, 0, 0}}, {{0, 0, 0}, {0, 4, 0}}, {{0, 4, 0}, {0, 4, 3}}}));
  EXPECT_TRUE(found.symmetries.empty());
  EXPECT_TRUE(found.rotations.empty());
}

TEST(SymmetryFinder, FindsTheMiddleOfASingleLine) {
  const std::vector<Symmetry> mirrors = wholeMirrors(drawingOf({{{1, 0, 0}, {8, 0, 0}}}));
  ASSERT_EQ(mirrors.size(), 1U);
  EXPECT_TRUE(hasMirror(mirrors, {1, 0, 0}, 4.5));
}

TEST(SymmetryFinder, LeavesOutTheMirrorInWhichAFlatSketchLies) {
  EXPECT_FALSE(hasMirror(wholeMirrors(rectangle(6, 4)), {0, 0, 1}, 0.0));
}

TEST(SymmetryFinder, TellsATurnWithoutAMirror) {
  // A staircase Z in the plane: only the half turn brings it onto itself.
  const FoundSymmetries found = findSymmetries(
      drawingOf({{{-4, 3, 0}, {0, 3, 0}}, {{0, 3, 0}, {0, -3, 0}}, {{0, -3, 0}, {4, -3, 0}}}));
  EXPECT_TRUE(found.symmetries.empty());
  ASSERT_EQ(found.rotations.size(), 1U);
  EXPECT_EQ(found.rotations[0].order, 2);
}

TEST(SymmetryFinder, MindsExactLines) {
  Sketch sketch = rectangle(6, 4);
  sketch.lines[0].exact = true;
  const std::vector<Symmetry> mirrors = wholeMirrors(sketch);
  EXPECT_EQ(mirrors.size(), 1U);
  EXPECT_TRUE(hasMirror(mirrors, {1, 0, 0}, 3.0));
}

TEST(SymmetryFinder, MindsFixedHoleAxes) {
  Sketch sketch = rectangle(6, 4);
  sketch.lines[1].holeAxis = lattice::Axis::kZ;
  EXPECT_FALSE(hasMirror(wholeMirrors(sketch), {1, 0, 0}, 3.0));
  sketch.lines[3].holeAxis = lattice::Axis::kZ;
  EXPECT_TRUE(hasMirror(wholeMirrors(sketch), {1, 0, 0}, 3.0));
}

TEST(SymmetryFinder, MindsJoints) {
  Sketch sketch = rectangle(6, 4);
  sketch.joints.push_back({{0, 0, 0}, {0, 0, 1}, {{0}, {3}}});
  EXPECT_TRUE(wholeMirrors(sketch).empty());
  sketch.joints.push_back({{6, 0, 0}, {0, 0, 1}, {{0}, {1}}});
  EXPECT_TRUE(hasMirror(wholeMirrors(sketch), {1, 0, 0}, 3.0));
}

TEST(SymmetryFinder, OffersAMirrorOfMostLines) {
  Sketch sketch = rectangle(8, 4);
  sketch.lines.push_back(drawingOf({{{8, 2, 0}, {8, 2, 5}}}).lines[0]);
  const FoundSymmetries found = findSymmetries(sketch);
  EXPECT_TRUE(std::any_of(found.symmetries.begin(), found.symmetries.end(), [](const Symmetry& s) {
    return s.kind == Symmetry::Kind::kReflection && s.normal.x > 0.99 && s.offset == 4.0 &&
           s.lines == std::vector<int>({0, 1, 2, 3});
  }));
}

TEST(SymmetryFinder, OffersTheMirrorsOfAPieceWithItsLines) {
  Sketch sketch = rectangle(6, 4);
  const Sketch crooked = drawingOf({{{20, 0, 0}, {27, 0, 0}}, {{20, 0, 0}, {20, 9, 0}}});
  sketch.lines.insert(sketch.lines.end(), crooked.lines.begin(), crooked.lines.end());
  const FoundSymmetries found = findSymmetries(sketch);
  EXPECT_TRUE(std::any_of(found.symmetries.begin(), found.symmetries.end(), [](const Symmetry& s) {
    return s.normal.y > 0.99 && s.offset == 2.0 && s.lines == std::vector<int>({0, 1, 2, 3});
  }));
}

TEST(SymmetryFinder, OffersShiftsWithTheirPairs) {
  const FoundSymmetries found = findSymmetries(rectangle(6, 4));
  const auto shift =
      std::find_if(found.symmetries.begin(), found.symmetries.end(), [](const Symmetry& s) {
        return s.kind == Symmetry::Kind::kTranslation;
      });
  // One pair each way is not enough to be worth a word.
  EXPECT_EQ(shift, found.symmetries.end());
  Sketch box = rectangle(6, 4);
  for (Line line : rectangle(6, 4).lines) {
    line.from.z += 3;
    line.to.z += 3;
    box.lines.push_back(line);
  }
  const FoundSymmetries raised = findSymmetries(box);
  EXPECT_TRUE(
      std::any_of(raised.symmetries.begin(), raised.symmetries.end(), [](const Symmetry& s) {
        return s.kind == Symmetry::Kind::kTranslation && s.vector == Vec3{0, 0, 3} &&
               s.pairs == std::vector<std::pair<int, int>>({{0, 4}, {1, 5}, {2, 6}, {3, 7}});
      }));
}

TEST(SymmetryFinder, OffersNothingThatTheSketchNamesAlready) {
  Sketch sketch = rectangle(6, 4);
  Symmetry known;
  known.normal = {-1, 0, 0};
  known.offset = -3.0;
  sketch.symmetries.push_back(known);
  const std::vector<Symmetry> mirrors = wholeMirrors(sketch);
  ASSERT_EQ(mirrors.size(), 1U);
  EXPECT_TRUE(hasMirror(mirrors, {0, 1, 0}, 2.0));
}

TEST(SymmetryFinder, OffersWhatTheFormatReads) {
  Sketch sketch = hexagon(4);
  sketch.symmetries = findSymmetries(sketch).symmetries;
  const base::Result<Sketch> again = readSketch(writeSketch(sketch));
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_TRUE(findSymmetries(again.value()).symmetries.empty());
}

}  // namespace
}  // namespace liftarm::sketch
