#include "guide/orbits.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::guide {
namespace {

using lattice::Axis;

sketch::Symmetry mirrorAcross(int axis, double offset) {
  sketch::Symmetry symmetry;
  symmetry.kind = sketch::Symmetry::Kind::kReflection;
  symmetry.normal = {0, 0, 0};
  symmetry.normal[axis] = 1.0;
  symmetry.offset = offset;
  return symmetry;
}

//! A cube with mirrors across x, y and z as far as `mirrors` says.
sketch::Sketch mirroredCube(int mirrors) {
  sketch::Sketch sketch = testing::cubeSketch(8);
  for (int axis = 0; axis < mirrors; ++axis) {
    sketch.symmetries.push_back(mirrorAcross(axis, 4.0));
  }
  return sketch;
}

TEST(Orbits, OfASketchWithoutSymmetriesAreEmpty) {
  EXPECT_TRUE(Orbits(testing::graphOf(testing::cubeSketch(8))).empty());
}

TEST(Orbits, OfAMirroredCubeAreItsFourParallelEdges) {
  const GuidingGraph graph = testing::graphOf(mirroredCube(3));
  const Orbits orbits(graph);
  ASSERT_FALSE(orbits.empty());
  std::vector<int> first;
  for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
    first.push_back(orbits.representative(run));
  }
  std::sort(first.begin(), first.end());
  EXPECT_EQ(std::unique(first.begin(), first.end()) - first.begin(), 3);
}

TEST(Orbits, CentreARunThatTheMirrorCutsInHalf) {
  const GuidingGraph graph = testing::graphOf(mirroredCube(1));
  const Orbits orbits(graph);
  for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
    const GuideRun& guideRun = graph.runs[static_cast<std::size_t>(run)];
    const SelfBinding binding = orbits.binding(run, guideRun.axes[0]);
    EXPECT_EQ(binding.centred, std::abs(guideRun.direction.x) > 0.5) << run;
    EXPECT_EQ(binding.sign, 1) << run;
    EXPECT_FALSE(binding.pinned) << run;
  }
}

TEST(Orbits, PinARunInTheMirrorWhoseHolesPointAcrossIt) {
  sketch::Sketch sketch = testing::teeSketch();
  sketch.symmetries.push_back(mirrorAcross(0, 0.0));
  const GuidingGraph graph = testing::graphOf(sketch);
  const Orbits orbits(graph);
  for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
    if (std::abs(graph.runs[static_cast<std::size_t>(run)].direction.y) > 0.5) {
      EXPECT_TRUE(orbits.binding(run, Axis::kX).pinned);
      EXPECT_FALSE(orbits.binding(run, Axis::kZ).pinned);
    }
  }
}

TEST(Orbits, LeaveOutAShiftThatContradictsAMirror) {
  sketch::Sketch sketch = mirroredCube(3);
  const GuidingGraph before = testing::graphOf(sketch);
  sketch::Symmetry shift;
  shift.kind = sketch::Symmetry::Kind::kTranslation;
  shift.vector = {0, 8, 0};
  shift.pairs = {{0, 1}, {2, 3}};
  sketch.symmetries.push_back(shift);
  const GuidingGraph graph = testing::graphOf(sketch);
  ASSERT_GT(graph.symmetries.size(), before.symmetries.size());
  const Orbits orbits(graph);
  const Orbits mirrorsAlone(before);
  for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
    EXPECT_EQ(orbits.images(run), mirrorsAlone.images(run)) << run;
  }
}

TEST(Orbits, LetRaftersPassEachOtherOnNeighbouringLayers) {
  sketch::Sketch sketch = testing::houseSketch();
  sketch.symmetries.push_back(mirrorAcross(0, 4.0));
  const GuidingGraph graph = testing::graphOf(sketch);
  const Orbits orbits(graph);
  int rafters = 0;
  for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
    const GuideRun& guideRun = graph.runs[static_cast<std::size_t>(run)];
    ASSERT_FALSE(orbits.images(run).empty()) << run;
    if (guideRun.principal) {
      continue;
    }
    ++rafters;
    const auto axis = static_cast<std::size_t>(lattice::index(guideRun.axes.front()));
    const RunImage& there = orbits.images(run).front();
    const RunImage& back = orbits.images(there.run).front();
    EXPECT_EQ(std::abs(there.lifts[axis]), 1) << run;
    EXPECT_EQ(back.run, run);
    EXPECT_EQ(back.layerOf(there.layerOf(2, axis), axis), 2) << run;
  }
  EXPECT_EQ(rafters, 4);
}

TEST(Orbits, KeepTheImagesOfALineThatHasNoHoleInItsMiddle) {
  sketch::Sketch sketch = testing::squareSketch(7);
  sketch.symmetries = {mirrorAcross(0, 3.5), mirrorAcross(1, 3.5)};
  const GuidingGraph graph = testing::graphOf(sketch);
  const Orbits orbits(graph);
  for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
    ASSERT_EQ(orbits.images(run).size(), 1U) << run;
    EXPECT_NE(orbits.images(run).front().run, run);
    EXPECT_FALSE(orbits.binding(run, graph.runs[static_cast<std::size_t>(run)].axes[0]).centred);
  }
}

TEST(Orbits, OfAHalfTurnAreItsOppositeLines) {
  sketch::Sketch sketch = testing::squareSketch(8);
  sketch::Symmetry turn;
  turn.kind = sketch::Symmetry::Kind::kRotation;
  turn.normal = {0, 0, 1};
  turn.vector = {4, 4, 0};
  sketch.symmetries = {turn};
  const Orbits orbits(testing::graphOf(sketch));
  std::vector<int> first;
  for (int run = 0; run < 4; ++run) {
    first.push_back(orbits.representative(run));
  }
  std::sort(first.begin(), first.end());
  EXPECT_EQ(std::unique(first.begin(), first.end()) - first.begin(), 2);
}

TEST(Orbits, FreedRunsHaveNoImagesAndBindNothing) {
  const GuidingGraph graph = testing::graphOf(mirroredCube(1));
  Orbits orbits(graph);
  int run = 0;
  while (orbits.representative(run) == run) {
    ++run;
  }
  const int first = orbits.representative(run);
  orbits.release(run);
  EXPECT_TRUE(orbits.images(run).empty());
  EXPECT_TRUE(orbits.images(first).empty());
}

TEST(Orbits, HoleAxesAgreeOverImages) {
  const GuidingGraph graph = testing::graphOf(mirroredCube(3));
  const Orbits orbits(graph);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    base::Rng rng(seed);
    const Orientation orientation = estimateOrientation(graph, orbits, 10, &rng);
    for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
      const Axis axis = orientation[static_cast<std::size_t>(run)];
      for (const RunImage& image : orbits.images(run)) {
        EXPECT_EQ(lattice::index(orientation[static_cast<std::size_t>(image.run)]),
                  image.axes[static_cast<std::size_t>(lattice::index(axis))]);
      }
    }
  }
}

}  // namespace
}  // namespace liftarm::guide
