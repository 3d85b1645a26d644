#include "rivals/rivals.h"

#include <algorithm>
#include <array>
#include <utility>

#include "rivals/ant_colony.h"
#include "rivals/beam_search.h"
#include "rivals/greedy.h"
#include "rivals/population.h"
#include "rivals/random_walk.h"
#include "rivals/schedules.h"

namespace liftarm::rivals {

namespace {

using Made = std::unique_ptr<search::LayoutSearch>;

template <typename Search>
Made make(const layout::LayoutProblem& problem,
          layout::ConnectionSolver& solver,
          RivalOptions options) {
  return std::make_unique<Search>(problem, solver, std::move(options));
}

struct Rival {
  std::string_view name;
  Made (*make)(const layout::LayoutProblem&, layout::ConnectionSolver&, RivalOptions);
};

constexpr std::array<Rival, 5> kRivals{{
    {"random", make<RandomWalk>},
    {"greedy", make<Greedy>},
    {"beam-search", make<BeamSearch>},
    {"ant-colony", make<AntColony>},
    {"population", make<Population>},
}};

struct Schedule {
  std::string_view name;
  std::unique_ptr<search::Cooling> (*make)(const search::CoolingPlan&);
};

constexpr std::array<Schedule, 4> kSchedules{{
    {"linear", makeLinear},
    {"logarithmic", makeLogarithmic},
    {"optimum", makeOptimum},
    {"thermodynamic", makeThermodynamic},
}};

template <typename Table>
std::vector<std::string_view> namesOf(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& row : table) {
    names.push_back(row.name);
  }
  return names;
}

}  // namespace

std::vector<std::string_view> rivalNames() {
  return namesOf(kRivals);
}

std::unique_ptr<search::LayoutSearch> makeRival(std::string_view name,
                                                const layout::LayoutProblem& problem,
                                                layout::ConnectionSolver& solver,
                                                RivalOptions options) {
  const auto* const found = std::find_if(
      kRivals.begin(), kRivals.end(), [&](const Rival& rival) { return rival.name == name; });
  return found == kRivals.end() ? nullptr : found->make(problem, solver, std::move(options));
}

std::vector<std::string_view> scheduleNames() {
  return namesOf(kSchedules);
}

search::MakeCooling coolingOf(std::string_view name) {
  const auto* const found =
      std::find_if(kSchedules.begin(), kSchedules.end(), [&](const Schedule& schedule) {
        return schedule.name == name;
      });
  return found == kSchedules.end() ? search::MakeCooling{} : search::MakeCooling{found->make};
}

int problemSize(const layout::LayoutProblem& problem) {
  return std::max(1, static_cast<int>(problem.graph.runs.size()) / 2 - 1);
}

}  // namespace liftarm::rivals
