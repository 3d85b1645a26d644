#pragma once

#include <cstdint>
#include <memory>

#include "design/attempt.h"
#include "objective/mobility.h"

namespace liftarm::design {

//! Searches with other seeds where what was found is not what a builder builds.
inline constexpr std::uint32_t kBetterSeeds = 3;

//! One search with all that it looks at.
struct Attempts::Attempt {
  Attempt(const sketch::Sketch& wanted,
          const Settings& settings,
          const mechanisms::MechanismTable& table)
      : solver(table, settings.connection),
        problem(problemOf(wanted, settings)),
        mobility(problem, table) {}

  Wishes wishes;
  double value = 0.0;  // of its best layout, with what being symmetric is worth taken off
  bool alike = false;  // whether that layout is symmetric
  int faults = 0;      // of how its model stands, where it is to stand
  int freedoms = 0;    // of that layout, also where the search ended before it asked
  layout::ConnectionSolver solver;
  layout::LayoutProblem problem;
  objective::Mobility mobility;
  std::unique_ptr<search::LayoutSearch> search;
};

}  // namespace liftarm::design
