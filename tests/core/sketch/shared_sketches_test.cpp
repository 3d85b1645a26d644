//! Properties of reading and arranging over the drawings beside the project.
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/helpers/shared_data.h"
#include "core/sketch/sketch_text.h"
#include "sketch/arrangement.h"
#include "sketch/snap.h"

namespace liftarm::sketch {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

class SharedSketch : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    LIFTARM_NEED_SHARED_DATA();
    const auto text =
        liftarm::testing::readSharedFile("sketches/" + std::string(GetParam()) + ".sketch.json");
    ASSERT_TRUE(text.has_value());
    base::Result<Sketch> result = readSketch(*text);
    ASSERT_TRUE(result.ok()) << result.error().message;
    sketch_ = std::move(result).value();
    arrangement_ = arrange(sketch_);
  }

  Sketch sketch_;
  Arrangement arrangement_;
};

TEST_P(SharedSketch, HasWholeLengths) {
  for (const Line& line : sketch_.lines) {
    EXPECT_NEAR(lattice::length(line.to - line.from), line.length, 1e-9);
  }
}

TEST_P(SharedSketch, IsWrittenAndReadBackWithoutChange) {
  const std::string text = writeSketch(sketch_);
  const base::Result<Sketch> again = readSketch(text);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(writeSketch(again.value()), text);
}

TEST_P(SharedSketch, HasEachUnitOfEachLineInExactlyOneRunEdge) {
  std::vector<int> unitsOfLine(sketch_.lines.size(), 0);
  std::map<std::pair<int, int>, int> usesOfEdge;
  for (const sketch::Run& run : arrangement_.runs) {
    ASSERT_EQ(run.nodes.size(), run.edges.size() + 1);
    for (std::size_t i = 0; i < run.edges.size(); ++i) {
      ++usesOfEdge[std::minmax(run.nodes[i], run.nodes[i + 1])];
      for (const int line : run.edges[i].lines) {
        ++unitsOfLine[at(line)];
      }
    }
  }
  for (std::size_t i = 0; i < sketch_.lines.size(); ++i) {
    EXPECT_EQ(unitsOfLine[i], sketch_.lines[i].length) << "line " << i;
  }
  for (const auto& [edge, uses] : usesOfEdge) {
    EXPECT_EQ(uses, 1) << edge.first << " to " << edge.second;
  }
}

TEST_P(SharedSketch, HasNodesOneModuleApartAlongStraightRuns) {
  for (const sketch::Run& run : arrangement_.runs) {
    const lattice::Vec3 begin = arrangement_.nodes[at(run.nodes[0])].position;
    for (std::size_t i = 0; i < run.nodes.size(); ++i) {
      const lattice::Vec3 expected = begin + static_cast<double>(i) * run.direction;
      EXPECT_LT(lattice::length(arrangement_.nodes[at(run.nodes[i])].position - expected), 1e-6);
    }
  }
}

TEST_P(SharedSketch, HasRunsThatAreMaximal) {
  for (const ArrangedNode& node : arrangement_.nodes) {
    for (const auto& [runA, indexA] : node.runs) {
      for (const auto& [runB, indexB] : node.runs) {
        if (runA < runB) {
          const lattice::Vec3 cross = lattice::cross(arrangement_.runs[at(runA)].direction,
                                                     arrangement_.runs[at(runB)].direction);
          EXPECT_GT(lattice::length(cross), 1e-3) << "runs " << runA << " and " << runB;
        }
      }
    }
  }
}

TEST_P(SharedSketch, NamesTheSameRunsAtNodesAsNodesInRuns) {
  std::size_t uses = 0;
  for (std::size_t n = 0; n < arrangement_.nodes.size(); ++n) {
    for (const auto& [run, index] : arrangement_.nodes[n].runs) {
      EXPECT_EQ(arrangement_.runs[at(run)].nodes[at(index)], static_cast<int>(n));
      ++uses;
    }
  }
  std::size_t nodesInRuns = 0;
  for (const sketch::Run& run : arrangement_.runs) {
    nodesInRuns += run.nodes.size();
  }
  EXPECT_EQ(uses, nodesInRuns);
}

INSTANTIATE_TEST_SUITE_P(All,
                         SharedSketch,
                         ::testing::Values("airplane",
                                           "bicycle",
                                           "castle",
                                           "chair_complex",
                                           "crossbow",
                                           "cube_21",
                                           "cube_3",
                                           "excavator",
                                           "fan",
                                           "field_10",
                                           "flying_kite",
                                           "flying_kite_x4",
                                           "grid_1",
                                           "grid_4",
                                           "grid_20",
                                           "house",
                                           "letter_A",
                                           "letter_K",
                                           "letter_O",
                                           "lifter",
                                           "long_bow",
                                           "nested_squares",
                                           "picker",
                                           "tower_2d",
                                           "tower_3d_storey",
                                           "triangle_tile_4",
                                           "triangles_10"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace liftarm::sketch
