#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "search/run_coverer.h"

namespace liftarm::search {
namespace {

using lattice::Axis;
using layout::Beam;
using layout::Cover;
using layout::Layout;
using testing::LayoutBench;

const std::vector<int> kAllLengths{2, 3, 5, 6, 7, 9, 11, 13, 15};

//! The cost that RunCoverer's documentation gives to the cover of a line that stands alone.
double costOf(const Cover& cover, int edges, const CoverCosts& costs) {
  double cost = 0.0;
  for (std::size_t b = 0; b < cover.beams.size(); ++b) {
    const Beam& beam = cover.beams[b];
    cost += costs.beam * layout::partsOfBeam(beam.holes) + costs.hole * beam.holes +
            costs.layer * std::abs(beam.layer) +
            costs.layerHole * beam.holes * beam.layer * beam.layer;
    cost += beam.start < 0 ? costs.overhang : 0.0;
    cost += beam.last() > edges ? costs.overhang : 0.0;
    cost += b > 0 && cover.beams[b - 1].last() == beam.start ? costs.hinge : 0.0;
  }
  return cost;
}

//! The lowest cost over every chain of beams, by states (two last beams' ends): written for the
//! test, and tries all overlaps of one to three holes on neighbouring layers.
double bestByBruteForce(int edges, const CoverCosts& costs) {
  struct State {
    int before;  // last node of the beam before, or -2
    int last;
    int layer;

    bool operator<(const State& o) const {
      return std::tie(last, layer, before) < std::tie(o.last, o.layer, o.before);
    }
  };

  std::map<State, double> open;
  const auto offer = [&](State state, double cost) {
    const auto found = open.emplace(state, cost).first;
    found->second = std::min(found->second, cost);
  };
  const auto beamCost = [&](int start, int holes, int layer) {
    return costOf({Axis::kZ, {{start, holes, layer}}}, edges, costs);
  };
  for (const int holes : kAllLengths) {
    for (int start = -1; start <= 0; ++start) {
      for (int layer = -guide::kMaxLayer; layer <= guide::kMaxLayer; ++layer) {
        if (start + holes - 1 <= edges + 1) {
          offer({-2, start + holes - 1, layer}, beamCost(start, holes, layer));
        }
      }
    }
  }
  double best = 1e18;
  while (!open.empty()) {
    const auto [state, cost] = *open.begin();
    open.erase(open.begin());
    if (state.last >= edges) {
      best = std::min(best, cost);
      continue;
    }
    for (int shared = 1; shared <= 3; ++shared) {
      const int start = state.last - shared + 1;
      if (start <= state.before || start < 0) {
        continue;  // it would reach back to a beam of its own layer
      }
      for (const int layer : {state.layer - 1, state.layer + 1}) {
        for (const int holes : kAllLengths) {
          const int last = start + holes - 1;
          if (last > state.last && last <= edges + 1 && layer >= -guide::kMaxLayer &&
              layer <= guide::kMaxLayer) {
            offer({state.last, last, layer},
                  cost + beamCost(start, holes, layer) + (shared == 1 ? costs.hinge : 0.0));
          }
        }
      }
    }
  }
  return best;
}

void expectTrueMinimum(const CoverCosts& costs) {
  for (int edges = 1; edges <= 20; ++edges) {
    LayoutBench bench(testing::lineSketch(edges));
    const Layout layout(bench.problem, bench.solver);
    RunCoverer coverer(bench.problem, kAllLengths, costs);
    base::Rng rng(1);
    const auto cover = coverer.propose(layout, {0, Axis::kZ}, &rng);
    ASSERT_TRUE(cover.has_value());
    EXPECT_NEAR(costOf(*cover, edges, costs), bestByBruteForce(edges, costs), 1e-9) << edges;
  }
}

TEST(RunCoverer, FindsTheTrueMinimumOnALineThatStandsAlone) {
  expectTrueMinimum(CoverCosts{});
}

TEST(RunCoverer, FindsTheTrueMinimumWhereLongBeamsAreDear) {
  CoverCosts costs;
  costs.beam = 0.1;
  costs.hole = 1.0;
  costs.hinge = 5.0;
  expectTrueMinimum(costs);
}

TEST(RunCoverer, FindsTheTrueMinimumWhereBeamsMayStickOut) {
  CoverCosts costs;
  costs.overhang = 0.0;
  costs.layerHole = 0.5;
  expectTrueMinimum(costs);
}

}  // namespace
}  // namespace liftarm::search
