#include "search/cover_table.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "search/annealer.h"
#include "search/cover_bound.h"

// The bounds on beams hold for what the table lists: so whatever a search lays must be in it.

namespace liftarm::search {
namespace {

using layout::Beam;
using Edges = std::set<std::pair<int, int>>;  // run and edge

Edges edgesOf(const CoverTable& table, const TableCover& cover) {
  Edges edges;
  for (const int e : cover.edges) {
    const TableEdge& edge = table.edges[static_cast<std::size_t>(e)];
    edges.emplace(edge.run, edge.index);
  }
  return edges;
}

//! The edges of the table that one part of a layout covers, whose arm on a run this is.
Edges edgesOf(const CoverTable& table,
              const std::vector<layout::Cover>& covers,
              int run,
              const Beam& beam) {
  Edges edges;
  for (int r = 0; r < static_cast<int>(covers.size()); ++r) {
    for (const Beam& other : covers[static_cast<std::size_t>(r)].beams) {
      const bool same =
          (r == run && other == beam) || (beam.isArm() && layout::isOneBeam(run, beam, r, other));
      for (const TableEdge& edge : table.edges) {
        if (same && edge.run == r && other.start <= edge.index && edge.index < other.last()) {
          edges.emplace(r, edge.index);
        }
      }
    }
  }
  return edges;
}

//! Whether each beam of a layout is in the table, and no edge of it is bare.
void expectListed(const sketch::Sketch& sketch, AnnealingOptions options) {
  options.starts = 10;
  options.minIterations = 400;
  options.maxRounds = 1;
  testing::LayoutBench bench(sketch);
  Annealer annealer(bench.problem, bench.solver, options);
  while (!annealer.advance(500)) {
  }
  const CoverTable table = makeCoverTable(bench.problem, options);
  const std::vector<layout::Cover>& covers = annealer.best().covers;
  Edges covered;
  for (int run = 0; run < static_cast<int>(covers.size()); ++run) {
    for (const Beam& beam : covers[static_cast<std::size_t>(run)].beams) {
      const Edges edges = edgesOf(table, covers, run, beam);
      covered.insert(edges.begin(), edges.end());
      EXPECT_TRUE(std::any_of(table.covers.begin(),
                              table.covers.end(),
                              [&](const auto& cover) {
                                return edgesOf(table, cover) == edges &&
                                       (cover.part.kind == CoverKind::kStraight) == !beam.isArm();
                              }))
          << "run " << run << " from " << beam.start << ", holes " << beam.holes;
    }
  }
  for (const TableEdge& edge : table.edges) {
    EXPECT_TRUE(covered.count({edge.run, edge.index}) == 1 ||
                covers[static_cast<std::size_t>(edge.run)].axle.used())
        << "edge " << edge.index << " of run " << edge.run;
  }
  EXPECT_LE(coverLowerBound(table), annealer.best().tallies.beams + annealer.best().tallies.axles);
}

TEST(CoverTable, ListsWhateverTheSearchLays) {
  for (const sketch::Sketch& sketch : {testing::cubeSketch(2),
                                       testing::cubeSketch(7),
                                       testing::cornerSketch(16),
                                       testing::houseSketch(),
                                       testing::triangleSketch(4),
                                       testing::gridSketch(4),
                                       testing::ladderSketch(),
                                       testing::smallHSketch(),
                                       testing::benchSketch()}) {
    expectListed(sketch, {});
  }
}

TEST(CoverTable, ListsWhateverTheSearchLaysOfShortBeams) {
  AnnealingOptions options;
  options.lengths = {2, 3, 5};
  for (const sketch::Sketch& sketch : {testing::cubeSketch(7), testing::houseSketch()}) {
    expectListed(sketch, options);
  }
}

CoverTable tableOf(const sketch::Sketch& sketch, const AnnealingOptions& options = {}) {
  return makeCoverTable(layout::makeLayoutProblem(testing::graphOf(sketch)), options);
}

bool has(const CoverTable& table, CoverKind kind) {
  return std::any_of(table.covers.begin(), table.covers.end(), [&](const TableCover& cover) {
    return cover.part.kind == kind;
  });
}

TEST(CoverTable, HasNoPartThatIsSwitchedOff) {
  const sketch::Sketch sketch = testing::benchSketch();
  for (const CoverKind kind : {CoverKind::kBent, CoverKind::kFrame, CoverKind::kAxle}) {
    EXPECT_TRUE(has(tableOf(sketch), kind));
    AnnealingOptions options;
    options.parts.corners = kind != CoverKind::kBent;
    options.parts.frames = kind != CoverKind::kFrame;
    options.parts.axles = kind != CoverKind::kAxle;
    EXPECT_FALSE(has(tableOf(sketch, options), kind));
  }
}

TEST(CoverTable, LeavesOutEdgesThatAMechanismMayBridge) {
  // Three lines at right angles have no hole axis in common: the first edge of each may be bridged.
  const CoverTable table = tableOf(testing::cornerSketch(4));
  EXPECT_EQ(table.edges.size(), 9U);
  EXPECT_TRUE(std::none_of(table.edges.begin(), table.edges.end(), [](const TableEdge& edge) {
    return edge.index == 0;
  }));
}

TEST(CoverTable, LeavesOutMoreWhereHoleAxesMayDifferAnyway) {
  const layout::LayoutProblem problem =
      layout::makeLayoutProblem(testing::graphOf(testing::teeSketch()));
  EXPECT_EQ(makeCoverTable(problem, {}).edges.size(), 14U);
  EXPECT_EQ(makeCoverTable(problem, {}, Bridging::kWherePossible).edges.size(), 11U);
}

TEST(CoverTable, AxlesThatWouldCrossAreRivals) {
  const CoverTable table = tableOf(testing::cornerSketch(4));
  ASSERT_EQ(table.rivals.size(), 1U);
  for (const int cover : table.rivals.front()) {
    EXPECT_EQ(table.covers[static_cast<std::size_t>(cover)].part.kind, CoverKind::kAxle);
  }
}

}  // namespace
}  // namespace liftarm::search
