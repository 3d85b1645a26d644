#include "design/solve.h"

#include <gtest/gtest.h>

namespace liftarm::design {
namespace {

sketch::Line lineOf(lattice::Vec3 from, lattice::Vec3 to) {
  sketch::Line line;
  line.from = from;
  line.to = to;
  return line;
}

TEST(Solve, BuildsASketchMadeInAProgram) {
  sketch::Sketch corner;
  corner.name = "Corner";
  corner.lines = {lineOf({0, 0, 0}, {8, 0, 0}), lineOf({0, 0, 0}, {0, 0, 6})};
  const base::Result<Design> design = design::solve(corner);
  ASSERT_TRUE(design.ok());
  EXPECT_TRUE(design.value().buildable);
  EXPECT_TRUE(design.value().check.buildable);
  EXPECT_EQ(design.value().model.name, "Corner");
  EXPECT_GE(design.value().model.parts.size(), 3U);
}

TEST(Solve, GivesTheSameModelForTheSameOptions) {
  sketch::Sketch line;
  line.lines = {lineOf({0, 0, 0}, {20, 0, 0})};
  SolveOptions options;
  options.seed = 7;
  options.set["effort"] = "0.5";
  const base::Result<Design> one = design::solve(line, options);
  const base::Result<Design> other = design::solve(line, options);
  ASSERT_TRUE(one.ok() && other.ok());
  EXPECT_EQ(one.value().report, other.value().report);
}

TEST(Solve, NamesWhatIsWrongWithSketchOrOptions) {
  sketch::Sketch half;
  half.lines = {lineOf({0, 0, 0}, {6.5, 0, 0})};
  EXPECT_EQ(design::solve(half).error().message.rfind("lines[0]: length 6.5", 0), 0U);
  half.lines = {lineOf({0, 0, 0}, {6, 0, 0})};
  SolveOptions options;
  options.preset = "sturdy";
  EXPECT_EQ(design::solve(half, options).error().message.rfind("preset: sturdy", 0), 0U);
}

}  // namespace
}  // namespace liftarm::design
