#include "guide/layer_field.h"

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::guide {
namespace {

using testing::graphOf;
using testing::Segments;

//! The paper's grid puzzle: n x n meshes of 4 x 4 modules.
sketch::Sketch gridSketch(int n) {
  Segments lines;
  for (int i = 0; i <= n; ++i) {
    lines.push_back({{0, 4.0 * i, 0}, {4.0 * n, 4.0 * i, 0}});
    lines.push_back({{4.0 * i, 0, 0}, {4.0 * i, 4.0 * n, 0}});
  }
  return testing::sketchFrom(lines);
}

LayerField fieldOf(const GuidingGraph& graph, std::uint64_t seed = 1) {
  base::Rng rng(seed);
  return makeLayerField(graph, Orientation(graph.runs.size(), lattice::Axis::kZ), &rng);
}

TEST(LayerField, CrossingLinesLieOnDifferentLayers) {
  const GuidingGraph graph = graphOf(gridSketch(9));
  const LayerField field = fieldOf(graph);
  std::vector<std::vector<int>> layersAt(graph.junctions.size());
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    for (std::size_t j = 0; j < field[r].size(); ++j) {
      layersAt[static_cast<std::size_t>(graph.runs[r].junctions[j])].push_back(field[r][j]);
    }
  }
  for (const std::vector<int>& layers : layersAt) {
    ASSERT_EQ(layers.size(), 2U);
    EXPECT_EQ(layers[0] + layers[1], 1);
  }
}

TEST(LayerField, NoLineChangesLayersMoreOftenThanItsBeamsMust) {
  const GuidingGraph graph = graphOf(gridSketch(12));
  const LayerField field = fieldOf(graph);
  for (const std::vector<int>& layers : field) {
    int changes = 0;
    for (std::size_t j = 1; j < layers.size(); ++j) {
      changes += layers[j] == layers[j - 1] ? 0 : 1;
    }
    EXPECT_EQ(changes, 3);  // 48 modules, 14 at most in one beam
  }
}

TEST(LayerField, ShortLinesNeedNoChange) {
  const GuidingGraph graph = graphOf(gridSketch(3));
  for (const std::vector<int>& layers : fieldOf(graph)) {
    for (const int layer : layers) {
      EXPECT_EQ(layer, layers.front());
    }
  }
}

TEST(LayerField, LinesThatMeetNothingInTheirPlaneHaveNoOpinion) {
  const GuidingGraph graph = graphOf(testing::cornerSketch(8));
  base::Rng rng(1);
  Orientation orientation;
  for (const GuideRun& run : graph.runs) {
    // Each line its own hole axis: no two are coplanar with it.
    const int along = run.direction.x > 0.5 ? 0 : (run.direction.y > 0.5 ? 1 : 2);
    orientation.push_back(lattice::axisFromIndex((along + 1) % 3));
  }
  for (const std::vector<int>& layers : makeLayerField(graph, orientation, &rng)) {
    for (const int layer : layers) {
      EXPECT_EQ(layer, kNoLayer);
    }
  }
}

}  // namespace
}  // namespace liftarm::guide
