#include <benchmark/benchmark.h>

#include "analysis/check.h"
#include "analysis/disassembly.h"
#include "instructions/sequence.h"

namespace liftarm::bench {
namespace {

using lattice::Vec3;

model::PlacedPart placed(const char* part, Vec3 at, Vec3 x, Vec3 y) {
  model::PlacedPart result;
  result.part = part;
  result.pose = {at, lattice::fromColumns(x, y, lattice::cross(x, y))};
  return result;
}

//! Mats of four crossed layers of 15-hole beams, eight to a layer, with a pin at every other
//! crossing: 128 parts each, one mat on top of the other.
model::Model mats(int count) {
  constexpr Vec3 kX{1, 0, 0};
  constexpr Vec3 kY{0, 1, 0};
  constexpr Vec3 kZ{0, 0, 1};
  model::Model model;
  for (int mat = 0; mat < count; ++mat) {
    for (int layer = 0; layer < 4; ++layer) {
      const double z = 5.0 * mat + layer;
      for (int i = 0; i < 8; ++i) {
        const double across = 2.0 * i - 7;
        model.parts.push_back(layer % 2 == 0 ? placed("32278", {0, across, z}, -kY, kX)
                                             : placed("32278", {across, 0, z}, kX, kY));
        // Every other crossing: the layers above and below take the others.
        for (int j = (i + layer) % 2; layer < 3 && j < 8; j += 2) {
          const double along = 2.0 * j - 7;
          const Vec3 at =
              layer % 2 == 0 ? Vec3{along, across, z + 0.5} : Vec3{across, along, z + 0.5};
          model.parts.push_back(placed("2780", at, kZ, kX));
        }
      }
    }
  }
  return model;
}

void disassembly(benchmark::State& state) {
  const model::Model model = mats(static_cast<int>(state.range(0)));
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  std::size_t stuck = 0;
  for (auto _ : state) {
    stuck = analysis::planDisassembly(scene).stuck.size();
  }
  state.counters["parts"] = static_cast<double>(model.parts.size());
  state.counters["stuck"] = static_cast<double>(stuck);
}

BENCHMARK(disassembly)->Arg(2)->Arg(8)->Unit(benchmark::kMillisecond);

void buildingSequence(benchmark::State& state) {
  const model::Model model = mats(static_cast<int>(state.range(0)));
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  for (auto _ : state) {
    benchmark::DoNotOptimize(instructions::planSequence(scene));
  }
  state.counters["parts"] = static_cast<double>(model.parts.size());
}

BENCHMARK(buildingSequence)->Arg(2)->Arg(8)->Unit(benchmark::kMillisecond);

//! All checks of DESIGN 5 that are there.
void allChecks(benchmark::State& state) {
  const model::Model model = mats(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(analysis::checkModel(model, parts::Catalogue::builtIn()));
  }
  state.counters["parts"] = static_cast<double>(model.parts.size());
}

BENCHMARK(allChecks)->Arg(2)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace liftarm::bench
