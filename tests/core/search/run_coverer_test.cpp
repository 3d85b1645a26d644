#include "search/run_coverer.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::search {
namespace {

using lattice::Axis;
using layout::Beam;
using layout::Cover;
using layout::Layout;
using testing::LayoutBench;

const std::vector<int> kLengths{2, 3, 5, 6, 7, 9, 11, 13, 15};

//! Whether a mechanism may bridge the edges next to this node, with the other runs' axes as they
//! are.
bool mixedAt(const Layout& layout, int runId, Axis axis, int index) {
  const guide::GuidingGraph& graph = layout.problem().graph;
  const guide::GuideRun& run = graph.runs[static_cast<std::size_t>(runId)];
  for (std::size_t j = 0; j < run.junctions.size(); ++j) {
    const guide::Junction& junction = graph.junctions[static_cast<std::size_t>(run.junctions[j])];
    if (run.junctionIndices[j] == index && guide::mayBridge(run, junction)) {
      return std::any_of(
          junction.incident.begin(), junction.incident.end(), [&](const guide::Incidence& i) {
            return i.run != runId && layout.run(i.run).cover.axis != axis;
          });
    }
  }
  return false;
}

//! Everything that must hold for a cover on its own, whatever stands around it.
void expectLegal(const Layout& layout, int runId, const Cover& cover) {
  const guide::GuidingGraph& graph = layout.problem().graph;
  const guide::GuideRun& run = graph.runs[static_cast<std::size_t>(runId)];
  EXPECT_TRUE(std::find(run.axes.begin(), run.axes.end(), cover.axis) != run.axes.end());
  ASSERT_FALSE(cover.beams.empty());
  std::vector<bool> covered(static_cast<std::size_t>(run.edgeCount()), false);
  for (const Beam& beam : cover.beams) {
    EXPECT_TRUE(std::find(kLengths.begin(), kLengths.end(), beam.holes) != kLengths.end());
    EXPECT_LE(beam.layer, guide::kMaxLayer);
    EXPECT_GE(beam.layer, -guide::kMaxLayer);
    EXPECT_GE(beam.start, run.exact ? 0 : -1);
    EXPECT_LE(beam.last(), run.edgeCount() + (run.exact ? 0 : 1));
    EXPECT_TRUE(!run.exact || beam.layer == 0);
    for (int edge = std::max(0, beam.start); edge < std::min(beam.last(), run.edgeCount());
         ++edge) {
      covered[static_cast<std::size_t>(edge)] = true;
    }
  }
  for (int edge = 0; edge < run.edgeCount(); ++edge) {
    EXPECT_TRUE(covered[static_cast<std::size_t>(edge)] ||
                mixedAt(layout, runId, cover.axis, edge) ||
                mixedAt(layout, runId, cover.axis, edge + 1))
        << "edge " << edge << " of run " << runId;
  }
  for (std::size_t a = 0; a < cover.beams.size(); ++a) {
    for (std::size_t b = a + 1; b < cover.beams.size(); ++b) {
      EXPECT_FALSE(overlap(layout::stadiumOf(graph, run, cover.axis, cover.beams[a]),
                           layout::stadiumOf(graph, run, cover.axis, cover.beams[b])))
          << "beams " << a << " and " << b << " of run " << runId;
      EXPECT_LT(cover.beams[a].last(), cover.beams[b].last());
    }
  }
}

void expectLegalProposals(const sketch::Sketch& sketch, std::uint64_t seed) {
  LayoutBench bench(sketch);
  Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, kLengths, CoverCosts{});
  base::Rng rng(seed);
  const std::vector<guide::GuideRun>& runs = bench.problem.graph.runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    layout.setCover(static_cast<int>(r), testing::randomCover(runs[r], &rng));
  }
  for (int step = 0; step < 150; ++step) {
    const auto run = static_cast<int>(rng.below(static_cast<std::uint32_t>(runs.size())));
    const guide::GuideRun& guideRun = runs[static_cast<std::size_t>(run)];
    const Axis axis = guideRun.axes[rng.below(static_cast<std::uint32_t>(guideRun.axes.size()))];
    const auto cover = coverer.propose(layout, {run, axis, {12.0 * rng.unit()}}, &rng);
    ASSERT_TRUE(cover.has_value());
    expectLegal(layout, run, *cover);
    layout.setCover(run, rng.below(3) == 0 ? testing::randomCover(guideRun, &rng) : *cover);
  }
}

TEST(RunCoverer, ProposesLegalCoversOnACube) {
  expectLegalProposals(testing::cubeSketch(6), 31);
}

TEST(RunCoverer, ProposesLegalCoversOnAGrid) {
  expectLegalProposals(testing::gridSketch(4), 32);
}

TEST(RunCoverer, ProposesLegalCoversOnAHouse) {
  expectLegalProposals(testing::houseSketch(), 33);
}

TEST(RunCoverer, ProposesLegalCoversOnLongLinesInSpace) {
  expectLegalProposals(testing::cornerSketch(37), 34);
}

TEST(RunCoverer, KeepsBeamsInOrderOfTheirStart) {
  // After a bridged first edge a beam may reach back behind the one before it, which then covers
  // nothing of its own.
  LayoutBench bench(testing::cubeSketch(6));
  Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, kLengths, CoverCosts{});
  base::Rng rng(31);
  const std::vector<guide::GuideRun>& runs = bench.problem.graph.runs;
  for (int step = 0; step < 300; ++step) {
    const auto run = static_cast<std::size_t>(rng.below(static_cast<std::uint32_t>(runs.size())));
    layout.setCover(static_cast<int>(run), testing::randomCover(runs[run], &rng));
    const auto cover =
        coverer.propose(layout, {static_cast<int>(run), runs[run].axes.front(), {12.0}}, &rng);
    ASSERT_TRUE(cover.has_value());
    for (std::size_t b = 1; b < cover->beams.size(); ++b) {
      EXPECT_LT(cover->beams[b - 1].start, cover->beams[b].start);
    }
  }
}

TEST(RunCoverer, ProposesLegalCoversForExactLines) {
  sketch::Sketch sketch = testing::houseSketch();
  for (sketch::Line& line : sketch.lines) {
    line.exact = line.length % 2 == 0;
  }
  LayoutBench bench(sketch);
  Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, kLengths, CoverCosts{});
  base::Rng rng(35);
  const std::vector<guide::GuideRun>& runs = bench.problem.graph.runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto cover =
        coverer.propose(layout, {static_cast<int>(r), runs[r].axes.front(), {5.0}}, &rng);
    if (cover) {
      expectLegal(layout, static_cast<int>(r), *cover);
      for (const Beam& beam : cover->beams) {
        EXPECT_TRUE(!runs[r].exact || beam.layer == 0);
      }
    }
  }
}

TEST(RunCoverer, KeepsClearOfABeamInItsWay) {
  LayoutBench bench(testing::sketchFrom({{{-4, 0, 0}, {4, 0, 0}}, {{0, -4, 0}, {0, 4, 0}}}));
  Layout layout(bench.problem, bench.solver);
  layout.setCover(0, {Axis::kZ, {{0, 9, 0}}});
  RunCoverer coverer(bench.problem, kLengths, CoverCosts{});
  base::Rng rng(1);
  const auto cover = coverer.propose(layout, {1, Axis::kZ}, &rng);
  ASSERT_TRUE(cover.has_value());
  layout.setCover(1, *cover);
  layout.settle();
  EXPECT_EQ(layout.tallies().violations(), 0);
}

TEST(RunCoverer, StaysAboveTheGround) {
  sketch::Sketch sketch = testing::squareSketch(8);
  sketch.ground = 0.0;
  LayoutBench bench(sketch);
  const Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, kLengths, CoverCosts{});
  base::Rng rng(2);
  for (int i = 0; i < 30; ++i) {
    const auto cover = coverer.propose(layout, {i % 4, Axis::kZ, {12.0}}, &rng);
    ASSERT_TRUE(cover.has_value());
    for (const Beam& beam : cover->beams) {
      EXPECT_GE(beam.layer, 0);
    }
  }
}

TEST(RunCoverer, LeavesNoLayerOfAnExactLineThatNoBeamFits) {
  // Four holes: there is no such beam, and a second one would need another layer.
  sketch::Sketch sketch = testing::lineSketch(3);
  sketch.lines.front().exact = true;
  LayoutBench bench(sketch);
  const Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, kLengths, CoverCosts{});
  base::Rng rng(1);
  if (const auto cover = coverer.propose(layout, {0, Axis::kZ}, &rng)) {
    for (const Beam& beam : cover->beams) {
      EXPECT_EQ(beam.layer, 0);
    }
  }
}

TEST(RunCoverer, GivesFixedBeamsAloneALengthThatIsNotAllowed) {
  LayoutBench bench(testing::lineSketch(20));
  const Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, {3, 5}, CoverCosts{});
  base::Rng rng(1);
  for (int start = 0; start <= 14; ++start) {
    const Beam wanted{start, 7, 1};
    const auto cover = coverer.propose(layout, {0, Axis::kZ, {9.0}, {&wanted, 1}}, &rng);
    ASSERT_TRUE(cover.has_value());
    int fixed = 0;
    for (const Beam& beam : cover->beams) {
      const bool isFixed = beam == Beam{start, 7, 1};
      fixed += isFixed ? 1 : 0;
      EXPECT_TRUE(isFixed || beam.holes == 3 || beam.holes == 5);
    }
    EXPECT_EQ(fixed, 1);
  }
  const auto free = coverer.propose(layout, {0, Axis::kZ, {9.0}}, &rng);
  ASSERT_TRUE(free.has_value());
  for (const Beam& beam : free->beams) {
    EXPECT_LE(beam.holes, 5);
  }
}

TEST(RunCoverer, SaysSoWhenNoAllowedLengthFits) {
  LayoutBench bench(testing::lineSketch(3));
  const Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, {15}, CoverCosts{});
  base::Rng rng(1);
  EXPECT_FALSE(coverer.propose(layout, {0, Axis::kZ}, &rng).has_value());
}

}  // namespace
}  // namespace liftarm::search
