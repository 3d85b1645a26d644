#include <memory>

#include <benchmark/benchmark.h>

#include "bench/sketch_files.h"
#include "core/helpers/layouts.h"
#include "guide/orientation.h"
#include "search/annealer.h"

namespace liftarm::bench {
namespace {

using testing::LayoutBench;

const char* const kSketches[] = {"public/examples/cube.sketch.json",
                                 "public/examples/house.sketch.json",
                                 "public/examples/airplane.sketch.json",
                                 "../shared/sketches/airplane.sketch.json"};

//! The sketch of this benchmark's argument; without it the benchmark is skipped and says so.
std::optional<sketch::Sketch> sketchOf(benchmark::State& state) {
  const char* path = kSketches[state.range(0)];
  std::optional<sketch::Sketch> sketch = readSketchFile(path);
  if (sketch) {
    state.SetLabel(path);
  } else {
    state.SkipWithError((std::string("missing: ") + path).c_str());
  }
  return sketch;
}

void forSketches(benchmark::internal::Benchmark* b) {
  for (std::size_t i = 0; i < std::size(kSketches); ++i) {
    b->Arg(static_cast<std::int64_t>(i));
  }
}

//! Moves per second of stage two, from its first layout on.
void annealerMoves(benchmark::State& state) {
  const auto sketch = sketchOf(state);
  if (!sketch) {
    return;
  }
  LayoutBench bench(*sketch);
  search::AnnealingOptions options;
  options.maxRounds = 1000;
  options.iterationsPerRun = 1000000;  // one long round: no end while we measure
  search::Annealer annealer(bench.problem, bench.solver, options);
  annealer.advance(1);
  for (auto _ : state) {
    annealer.advance(1);
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(annealerMoves)->Apply(forSketches)->MinTime(0.5);

//! One exact cover of one run (dynamic programming) in a finished layout.
void coverOfOneRun(benchmark::State& state) {
  const auto sketch = sketchOf(state);
  if (!sketch) {
    return;
  }
  LayoutBench bench(*sketch);
  const search::AnnealingOptions options;
  search::Annealer annealer(bench.problem, bench.solver, options);
  annealer.advance(200);
  search::RunCoverer coverer(bench.problem, options.lengths, search::CoverCosts{});
  base::Rng rng(1);
  const auto runs = static_cast<std::uint32_t>(bench.problem.graph.runs.size());
  for (auto _ : state) {
    const auto run = static_cast<int>(rng.below(runs));
    const lattice::Axis axis = annealer.current().run(run).cover.axis;
    benchmark::DoNotOptimize(coverer.propose(annealer.current(), {run, axis, {5.0}}, &rng));
  }
}

BENCHMARK(coverOfOneRun)->Apply(forSketches)->MinTime(0.2);

//! A corner of three lines that the solver has not seen before.
void connectionMiss(benchmark::State& state) {
  layout::LocalProblem problem;
  problem.clear();
  for (int i = 0; i < 5; ++i) {
    problem.addHole({{i, 0, 0}, lattice::Axis::kZ, 0, false});
    problem.addHole({{0, i, 1}, lattice::Axis::kZ, 1, false});
    if (i < 3) {
      problem.addHole({{1, 1, i + 2}, lattice::Axis::kX, 2, false});
    }
  }
  problem.terminals = 3;
  for (auto _ : state) {
    layout::ConnectionSolver solver(testing::defaultTable());
    benchmark::DoNotOptimize(solver.solve(problem));
  }
}

BENCHMARK(connectionMiss);

void connectionHit(benchmark::State& state) {
  layout::LocalProblem problem;
  problem.clear();
  for (int i = 0; i < 5; ++i) {
    problem.addHole({{i, 0, 0}, lattice::Axis::kZ, 0, false});
    problem.addHole({{0, i, 1}, lattice::Axis::kZ, 1, false});
  }
  problem.terminals = 2;
  layout::ConnectionSolver solver(testing::defaultTable());
  for (auto _ : state) {
    benchmark::DoNotOptimize(solver.solve(problem));
  }
}

BENCHMARK(connectionHit);

void stageOne(benchmark::State& state) {
  const auto sketch = sketchOf(state);
  if (!sketch) {
    return;
  }
  const guide::GuidingGraph graph = testing::graphOf(*sketch);
  base::Rng rng(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        guide::estimateOrientation(graph, search::AnnealingOptions{}.starts, &rng));
  }
}

BENCHMARK(stageOne)->Apply(forSketches)->Unit(benchmark::kMillisecond)->MinTime(0.1);

void composition(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(mechanisms::MechanismTable(
        mechanisms::composeMechanisms(parts::Catalogue::builtIn(),
                                      {{"2780", "6558", "87082", "15100", "48989", "55615"},
                                       static_cast<int>(state.range(0)),
                                       9})));
  }
}

BENCHMARK(composition)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->MinTime(0.1);

//! A search from start to end with the default settings.
void wholeSolve(benchmark::State& state) {
  const auto sketch = sketchOf(state);
  if (!sketch) {
    return;
  }
  int violations = 0;
  int beams = 0;
  for (auto _ : state) {
    LayoutBench bench(*sketch);
    search::Annealer annealer(bench.problem, bench.solver, {});
    while (!annealer.advance(1000)) {
    }
    violations = annealer.best().tallies.violations();
    beams = annealer.best().tallies.beams;
  }
  state.counters["violations"] = violations;
  state.counters["beams"] = beams;
}

BENCHMARK(wholeSolve)->Apply(forSketches)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace liftarm::bench
