#include "layout/connection_solver.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::layout {
namespace {

using lattice::Axis;
using lattice::Cell;
using mechanisms::MechanismCell;
using testing::defaultTable;

struct LocalBeam {
  Cell from;
  Cell step;
  int holes = 5;
  Axis axis = Axis::kZ;
  bool terminal = true;
};

LocalProblem problemOf(const std::vector<LocalBeam>& beams) {
  LocalProblem problem;
  problem.clear();
  int terminal = 0;
  for (const LocalBeam& beam : beams) {
    Cell cell = beam.from;
    for (int i = 0; i < beam.holes; ++i, cell = cell + beam.step) {
      if (inBox(cell)) {
        problem.addHole({cell, beam.axis, beam.terminal ? terminal : -1, false});
      }
    }
    terminal += beam.terminal ? 1 : 0;
  }
  problem.terminals = terminal;
  return problem;
}

//! Checks a connection against the problem cell by cell, without the solver's own code.
//! \return The number of clusters of terminals that its mechanisms leave.
int clustersOf(const LocalProblem& problem, const Connection& connection) {
  std::set<Cell> taken;
  std::vector<int> cluster(static_cast<std::size_t>(problem.terminals));
  for (std::size_t t = 0; t < cluster.size(); ++t) {
    cluster[t] = problem.cluster[t];
  }
  for (const PlacedMechanism& placed : connection.mechanisms) {
    std::vector<int> held;
    for (const MechanismCell& cell : defaultTable().oriented(placed.oriented).shape.cells) {
      const Cell p = cell.at + placed.at;
      EXPECT_TRUE(inBox(p));
      EXPECT_TRUE(taken.insert(p).second) << "two mechanisms share a cell";
      EXPECT_FALSE(problem.blocked(boxIndex(p))) << "a mechanism stands in a blocked cell";
      const LocalHole* hole = problem.holeAt(boxIndex(p));
      if (hole == nullptr) {
        continue;
      }
      EXPECT_TRUE(cell.head) << "a body stands in a beam";
      EXPECT_EQ(hole->axis, cell.axis) << "a head crosses a hole";
      EXPECT_FALSE(hole->used) << "a hole is used twice";
      if (hole->terminal >= 0) {
        held.push_back(hole->terminal);
      }
    }
    for (const int terminal : held) {
      const int from = cluster[static_cast<std::size_t>(terminal)];
      const int to = cluster[static_cast<std::size_t>(held.front())];
      std::replace(cluster.begin(), cluster.end(), from, to);
    }
  }
  return static_cast<int>(std::set<int>(cluster.begin(), cluster.end()).size());
}

LocalProblem stackOfTwo() {
  return problemOf({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}}});
}

LocalProblem cornerInSpace() {
  return problemOf(
      {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}}, {{1, 1, 2}, {0, 0, 1}, 3, Axis::kX}});
}

//! Up to four beams at random near the middle, and some blocked cells.
LocalProblem randomProblem(base::Rng* rng) {
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(rng->below(static_cast<std::uint32_t>(high - low + 1)));
  };
  std::vector<LocalBeam> beams;
  std::set<Cell> taken;
  const int count = between(2, 4);
  for (int tries = 0; static_cast<int>(beams.size()) < count && tries < 100; ++tries) {
    LocalBeam beam;
    const int direction = between(0, 2);
    beam.step[direction] = between(0, 1) == 0 ? 1 : -1;
    beam.axis = lattice::axisFromIndex((direction + between(1, 2)) % 3);
    beam.from = {between(-1, 1), between(-1, 1), between(-1, 1)};
    beam.holes = between(3, 5);
    beam.terminal = beams.size() < 2 || between(0, 3) > 0;
    std::set<Cell> cells;
    Cell cell = beam.from;
    for (int i = 0; i < beam.holes; ++i, cell = cell + beam.step) {
      cells.insert(cell);
    }
    if (std::none_of(cells.begin(), cells.end(), [&](Cell c) { return taken.count(c) != 0; })) {
      taken.insert(cells.begin(), cells.end());
      beams.push_back(beam);
    }
  }
  LocalProblem problem = problemOf(beams);
  for (int i = 0; i < 6; ++i) {
    const Cell cell{between(-3, 3), between(-3, 3), between(-3, 3)};
    if (problem.holeAt(boxIndex(cell)) == nullptr) {
      problem.block(boxIndex(cell));
    }
  }
  return problem;
}

TEST(ConnectionSolver, PinsAStackOfTwoWithOneShortPin) {
  ConnectionSolver solver(defaultTable());
  const Connection& connection = solver.solve(stackOfTwo());
  EXPECT_EQ(connection.failed, 0);
  ASSERT_EQ(connection.mechanisms.size(), 1U);
  const mechanisms::Mechanism& shape =
      defaultTable().oriented(connection.mechanisms.front().oriented).shape;
  EXPECT_EQ(shape.parts.front().id, "2780");
}

TEST(ConnectionSolver, JoinsACornerInSpace) {
  ConnectionSolver solver(defaultTable());
  const LocalProblem problem = cornerInSpace();
  const Connection& connection = solver.solve(problem);
  EXPECT_EQ(connection.failed, 0);
  EXPECT_EQ(clustersOf(problem, connection), 1);
}

TEST(ConnectionSolver, ReportsBeamsThatAreTooFarApart) {
  ConnectionSolver solver(defaultTable());
  EXPECT_EQ(
      solver.solve(problemOf({{{-4, -4, -4}, {1, 0, 0}, 2}, {{3, 4, 4}, {1, 0, 0}, 2}})).failed, 1);
}

TEST(ConnectionSolver, NeedsNothingForBeamsThatAreJoinedElsewhere) {
  ConnectionSolver solver(defaultTable());
  LocalProblem problem = stackOfTwo();
  problem.join(0, 1);
  const Connection& connection = solver.solve(problem);
  EXPECT_EQ(connection.failed, 0);
  EXPECT_TRUE(connection.mechanisms.empty());
}

TEST(ConnectionSolver, NeverOverlapsBodiesOrHeads) {
  ConnectionSolver solver(defaultTable());
  base::Rng rng(21);
  int joined = 0;
  for (int i = 0; i < 400; ++i) {
    const LocalProblem problem = randomProblem(&rng);
    const Connection& connection = solver.solve(problem);
    EXPECT_EQ(clustersOf(problem, connection), connection.failed + 1) << "problem " << i;
    joined += connection.failed == 0 ? 1 : 0;
  }
  EXPECT_GT(joined, 40);
}

TEST(ConnectionSolver, GivesTheSameAnswerToTheSameProblem) {
  ConnectionSolver solver(defaultTable());
  ConnectionSolver fresh(defaultTable());
  base::Rng rng(22);
  for (int i = 0; i < 60; ++i) {
    const LocalProblem problem = randomProblem(&rng);
    const Connection first = solver.solve(problem);
    for (const Connection& other : {solver.solve(problem), fresh.solve(problem)}) {
      EXPECT_EQ(first.failed, other.failed);
      EXPECT_EQ(first.cost, other.cost);
      ASSERT_EQ(first.mechanisms.size(), other.mechanisms.size());
      for (std::size_t m = 0; m < first.mechanisms.size(); ++m) {
        EXPECT_EQ(first.mechanisms[m].oriented, other.mechanisms[m].oriented);
        EXPECT_EQ(first.mechanisms[m].at, other.mechanisms[m].at);
      }
    }
  }
}

TEST(ConnectionSolver, KeepsItsAnswers) {
  ConnectionSolver solver(defaultTable());
  solver.solve(stackOfTwo());
  solver.solve(stackOfTwo());
  EXPECT_EQ(solver.misses(), 1U);
  EXPECT_EQ(solver.hits(), 1U);
}

TEST(ConnectionSolver, JoinsTurningGroupsByOneCoaxialPinOnly) {
  ConnectionSolver solver(defaultTable());
  LocalProblem problem = stackOfTwo();
  problem.isJoint = true;
  problem.jointAxis = Axis::kZ;
  problem.group[0] = 0;
  problem.group[1] = 1;
  const Connection& connection = solver.solve(problem);
  ASSERT_EQ(connection.failed, 0);
  ASSERT_EQ(connection.mechanisms.size(), 1U);
  const PlacedMechanism& placed = connection.mechanisms.front();
  for (const MechanismCell& cell : defaultTable().oriented(placed.oriented).shape.cells) {
    const Cell p = cell.at + placed.at;
    EXPECT_TRUE(cell.head && cell.axis == Axis::kZ && p.x == 0 && p.y == 0);
  }
}

TEST(ConnectionSolver, LeavesTurningGroupsApartRatherThanLockThem) {
  // Only a corner connector could join these two, and that would stop the joint.
  ConnectionSolver solver(defaultTable());
  LocalProblem problem = problemOf({{{1, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 0, 1}, 3, Axis::kX}});
  ASSERT_EQ(solver.solve(problem).failed, 0);
  problem.isJoint = true;
  problem.jointAxis = Axis::kY;
  problem.group[0] = 0;
  problem.group[1] = 1;
  EXPECT_EQ(solver.solve(problem).failed, 1);
}

TEST(LocalProblem, HashDoesNotDependOnTheOrderOfBlockedCells) {
  LocalProblem a = stackOfTwo();
  LocalProblem b = stackOfTwo();
  a.block(5);
  a.block(9);
  b.block(9);
  b.block(5);
  b.block(9);
  EXPECT_EQ(a.hash(), b.hash());
}

TEST(LocalProblem, HashTellsUsedHolesFromFreeOnes) {
  const LocalProblem a = stackOfTwo();
  LocalProblem b = stackOfTwo();
  b.useHole(boxIndex({0, 0, 0}));
  EXPECT_NE(a.hash(), b.hash());
}

TEST(LocalProblem, HashDoesNotDependOnTheOrderOfHoles) {
  LocalProblem a;
  LocalProblem b;
  a.clear();
  b.clear();
  a.addHole({{0, 0, 0}, Axis::kZ, 0, false});
  a.addHole({{1, 0, 0}, Axis::kX, 1, false});
  b.addHole({{1, 0, 0}, Axis::kX, 1, false});
  b.addHole({{0, 0, 0}, Axis::kZ, 0, false});
  EXPECT_EQ(a.hash(), b.hash());
}

TEST(LocalProblem, TwoBeamsInOneCellBlockIt) {
  LocalProblem problem;
  problem.clear();
  problem.addHole({{0, 0, 0}, Axis::kZ, 0, false});
  problem.addHole({{0, 0, 0}, Axis::kX, 1, false});
  EXPECT_TRUE(problem.blocked(boxIndex({0, 0, 0})));
}

}  // namespace
}  // namespace liftarm::layout
