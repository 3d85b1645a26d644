#include "rivals/schedules.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "rivals/rivals.h"

namespace liftarm::rivals {
namespace {

constexpr search::CoolingPlan kPlan{2000.0, 1e-4, 800};

//! Temperatures of a walk whose energy has a deviation of one and falls by `drift` a move.
std::vector<double> temperatures(search::Cooling& cooling, double drift) {
  std::vector<double> all{kPlan.start};
  double energy = 1000.0;
  for (std::uint64_t move = 0; move < kPlan.moves; ++move) {
    const double change = (move % 2 == 0 ? 1.0 : -1.0) - drift;
    energy += change;
    all.push_back(cooling.next({all.back(), energy, change}));
  }
  return all;
}

TEST(Schedules, StayBetweenTheirEnds) {
  for (const std::string_view name : scheduleNames()) {
    const auto cooling = coolingOf(name)(kPlan);
    for (const double t : temperatures(*cooling, 0.1)) {
      ASSERT_GT(t, 0.0) << name;
      ASSERT_LE(t, kPlan.start) << name;
    }
  }
}

TEST(LinearSchedule, EndsCold) {
  const auto cooling = makeLinear(kPlan);
  const std::vector<double> all = temperatures(*cooling, 0.0);
  EXPECT_NEAR(all[400], 1000.0, 3.0);
  EXPECT_NEAR(all.back(), kPlan.end, 1e-9);
}

TEST(LogarithmicSchedule, IsTheLogarithm) {
  const auto cooling = makeLogarithmic(kPlan);
  const std::vector<double> all = temperatures(*cooling, 0.0);
  EXPECT_NEAR(all[6], 2000.0 * std::log(2.0) / std::log(8.0), 1e-9);
}

TEST(OptimumSchedule, NeverHeats) {
  const auto cooling = makeOptimum(kPlan);
  const std::vector<double> all = temperatures(*cooling, 0.05);
  for (std::size_t i = 1; i < all.size(); ++i) {
    ASSERT_LE(all[i], all[i - 1]);
  }
  EXPECT_LT(all.back(), 1.0);
}

TEST(OptimumSchedule, CoolsSlowlierWhereTheEnergyVariesMore) {
  const auto calm = makeOptimum(kPlan);
  const auto wild = makeOptimum(kPlan);
  double coldest = 500.0;
  double hottest = 500.0;
  for (int i = 0; i < 4; ++i) {
    coldest = calm->next({500.0, 100.0 + (i % 2), 0.0});
    hottest = wild->next({500.0, 100.0 + 1000.0 * (i % 2), 0.0});
  }
  EXPECT_LT(coldest, hottest);
}

TEST(ThermodynamicSchedule, StaysHotWhileNothingIsGained) {
  const auto cooling = makeThermodynamic(kPlan);
  EXPECT_EQ(cooling->next({kPlan.start, 10.0, 5.0}), kPlan.start);
  EXPECT_EQ(cooling->next({kPlan.start, 5.0, 0.0}), kPlan.start);
}

TEST(ThermodynamicSchedule, IsChangeOverEntropy) {
  const auto cooling = makeThermodynamic(kPlan);
  cooling->next({100.0, 10.0, 4.0});  // entropy -0.04
  EXPECT_NEAR(cooling->next({100.0, 3.0, -5.0}), 25.0, 1e-9);
}

TEST(Schedules, GiveThePapersMethodItsNumberOfMoves) {
  testing::LayoutBench bench(testing::squareSketch(4));
  search::PaperOptions options;
  options.coolingRate = 0.98;
  search::PaperSearch exponential(bench.problem, bench.solver, options);
  exponential.advance(100000);
  for (const std::string_view name : scheduleNames()) {
    options.cooling = coolingOf(name);
    search::PaperSearch other(bench.problem, bench.solver, options);
    EXPECT_TRUE(other.advance(100000));
    EXPECT_EQ(other.iterations(), exponential.iterations()) << name;
    EXPECT_FALSE(other.best().covers.empty()) << name;
  }
}

TEST(Schedules, HaveNoNameForTheExponentialOne) {
  EXPECT_FALSE(coolingOf("exponential"));
}

}  // namespace
}  // namespace liftarm::rivals
