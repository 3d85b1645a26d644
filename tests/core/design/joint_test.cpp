#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "design/model_builder.h"
#include "search/annealer.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using lattice::Vec3;
using testing::LayoutBench;

//! A turning beam with a stub so near to the joint that one connector could reach both sides.
sketch::Sketch crowdedJoint() {
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {0, 0, 6}},
                                               {{-6, 0, 6}, {6, 0, 6}},
                                               {{2, 0, 6}, {2, 6, 6}},
                                               {{-2, 0, 6}, {-2, 0, 12}}});
  sketch.joints.push_back({{0, 0, 6}, {0, 1, 0}, {{0}, {1}}});
  return sketch;
}

search::LayoutSnapshot solved(const LayoutBench& bench,
                              layout::ConnectionSolver& solver,
                              std::uint64_t seed) {
  search::AnnealingOptions options;
  options.seed = seed;
  options.starts = 10;
  options.minIterations = 300;
  options.iterationsPerRun = 50;
  search::Annealer annealer(bench.problem, solver, options);
  while (!annealer.advance(1000)) {
  }
  return annealer.best();
}

//! Runs whose beams have a hole at this place along this axis.
std::set<int> runsWithHoleAt(const LayoutBench& bench,
                             const search::LayoutSnapshot& layout,
                             Vec3 place,
                             lattice::Axis axis) {
  std::set<int> runs;
  for (std::size_t r = 0; r < layout.covers.size(); ++r) {
    const layout::Cover& cover = layout.covers[r];
    for (const layout::Beam& beam : cover.beams) {
      for (int i = beam.start; i <= beam.last(); ++i) {
        const Vec3 hole = layout::holePosition(
            bench.problem.graph, bench.problem.graph.runs[r], cover.axis, i, beam.layer);
        if (cover.axis == axis && lattice::length(hole - place) < 1e-3) {
          runs.insert(static_cast<int>(r));
        }
      }
    }
  }
  return runs;
}

//! The groups of the joint whose own lines this mechanism holds.
std::set<std::size_t> groupsHeld(const LayoutBench& bench,
                                 const search::LayoutSnapshot& layout,
                                 std::size_t junction,
                                 const layout::PlacedMechanism& placed) {
  const guide::GuidingGraph& graph = bench.problem.graph;
  const Vec3 origin = graph.nodes[static_cast<std::size_t>(graph.junctions[junction].node)];
  std::set<std::size_t> groups;
  for (const mechanisms::MechanismCell& cell :
       testing::defaultTable().oriented(placed.oriented).shape.cells) {
    if (!cell.head) {
      continue;
    }
    const Vec3 place = origin + lattice::toVec3(cell.at + placed.at);
    for (const int run : runsWithHoleAt(bench, layout, place, cell.axis)) {
      const auto& runGroups = graph.joints.front().runGroups;
      for (std::size_t g = 0; g < runGroups.size(); ++g) {
        if (std::count(runGroups[g].begin(), runGroups[g].end(), run) > 0) {
          groups.insert(g);
        }
      }
    }
  }
  return groups;
}

struct JointSketch : ::testing::TestWithParam<std::uint64_t> {};

TEST_P(JointSketch, IsHeldByOneCoaxialPinAloneAcrossItsGroups) {
  LayoutBench bench(crowdedJoint());
  const search::LayoutSnapshot layout = solved(bench, bench.solver, GetParam());
  ASSERT_EQ(layout.tallies.violations(), 0);
  int across = 0;
  for (std::size_t j = 0; j < layout.junctions.size(); ++j) {
    for (const layout::PlacedMechanism& placed : layout.junctions[j].connection.mechanisms) {
      if (groupsHeld(bench, layout, j, placed).size() > 1) {
        ++across;
        EXPECT_GE(bench.problem.graph.junctions[j].joint, 0) << "held at junction " << j;
        for (const mechanisms::MechanismCell& cell :
             testing::defaultTable().oriented(placed.oriented).shape.cells) {
          const lattice::Cell p = cell.at + placed.at;
          EXPECT_TRUE(cell.head && cell.axis == lattice::Axis::kY && p.x == 0 && p.z == 0);
        }
      }
    }
  }
  EXPECT_EQ(across, 1);
}

TEST_P(JointSketch, HasAPinWithoutFrictionAtTheJoint) {
  LayoutBench bench(crowdedJoint());
  const search::LayoutSnapshot layout = solved(bench, bench.solver, GetParam());
  const model::Model model = buildModel(
      bench.problem, testing::defaultTable(), layout, "joint", sketch::writeSketch(crowdedJoint()));
  int free = 0;
  for (const model::PlacedPart& part : model.parts) {
    const parts::Part* real = parts::Catalogue::builtIn().find(part.part);
    free += real->partClass == parts::PartClass::kPin && !real->friction ? 1 : 0;
  }
  EXPECT_EQ(free, 1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, JointSketch, ::testing::Values(1U, 2U, 3U, 4U, 5U, 6U));

}  // namespace
}  // namespace liftarm::design
