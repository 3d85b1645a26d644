#include "analysis/disassembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/disassembly_state.h"
#include "base/rng.h"
#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using parts::Prism;
using testing::kX;
using testing::kY;
using testing::kZ;

DisassemblyPlan planOf(const model::Model& model) {
  return planDisassembly(makeScene(model, parts::Catalogue::builtIn()));
}

//! A bar of 0.8 x 0.8 modules from one point to another, as a prism.
Prism bar(Vec3 from, Vec3 to) {
  const Vec3 along = lattice::normalized(to - from);
  const Vec3 across = std::abs(along.z) > 0.5 ? kX : kZ;
  return {from, to, across, 0.4, 0.4};
}

parts::Part partOf(const std::string& id, std::vector<Prism> solid) {
  parts::Part part;
  part.id = id;
  part.name = id;
  part.solid = std::move(solid);
  part.boundsMin = {-4, -4, -4};
  part.boundsMax = {4, 4, 4};
  return part;
}

//! Parts of a made-up catalogue, each in its own place.
struct MadeUp {
  explicit MadeUp(std::vector<parts::Part> made) : catalogue(std::move(made)) {
    for (const parts::Part& part : catalogue.parts()) {
      model.parts.push_back({part.id, 71, {}, -1, 0, 0});
    }
  }

  [[nodiscard]] DisassemblyPlan plan() const {
    return planDisassembly(makeScene(model, catalogue));
  }

  parts::Catalogue catalogue;
  model::Model model;
};

//! A closed ring in the XY plane.
std::vector<Prism> ring(double r) {
  return {bar({-r, -r, 0}, {r, -r, 0}),
          bar({r, -r, 0}, {r, r, 0}),
          bar({r, r, 0}, {-r, r, 0}),
          bar({-r, r, 0}, {-r, -r, 0})};
}

std::vector<int> sortedPartsOf(const DisassemblyGroup& group) {
  std::vector<int> parts;
  for (const Removal& removal : group.removals) {
    parts.insert(parts.end(), removal.parts.begin(), removal.parts.end());
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

TEST(Disassembly, EveryPartLeavesOnce) {
  for (const model::Model& model : testing::buildableModels()) {
    for (const DisassemblyGroup& group : planOf(model).groups) {
      EXPECT_EQ(sortedPartsOf(group), group.parts) << model.name;
    }
  }
}

TEST(Disassembly, OnlyWhatIsLeftInTheEndHasNoMove) {
  for (const model::Model& model : testing::buildableModels()) {
    for (const DisassemblyGroup& group : planOf(model).groups) {
      for (const Removal& removal : group.removals) {
        EXPECT_EQ(removal.legs.empty(), &removal == &group.removals.back()) << model.name;
      }
    }
  }
}

TEST(Disassembly, APinLeavesBeforeTheBeamThatHoldsIt) {
  const DisassemblyPlan plan = planOf(testing::squareFrame());
  ASSERT_EQ(plan.groups.size(), 1U);
  std::vector<int> order;
  for (const Removal& removal : plan.groups.front().removals) {
    order.push_back(removal.parts.front());
  }
  const auto when = [&](int part) { return std::find(order.begin(), order.end(), part); };
  // Beams 2 and 3 lie on top; each pin is free after one of them and holds to 0 or 1 below.
  for (const int pin : {4, 5, 6, 7}) {
    EXPECT_TRUE(when(pin) > when(2) || when(pin) > when(3)) << pin;
  }
}

TEST(Disassembly, ARingAroundABarWithKnobsIsStuck) {
  const MadeUp made({partOf("ring", ring(1.5)),
                     partOf("barbell",
                            {bar({0, 0, -2}, {0, 0, 2}),
                             bar({-3, 0, 2.5}, {3, 0, 2.5}),
                             bar({-3, 0, -2.5}, {3, 0, -2.5})})});
  const DisassemblyPlan plan = made.plan();
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_EQ(plan.stuck.front().parts.size(), 1U);
  EXPECT_EQ(plan.stuck.front().by.size(), 1U);
  EXPECT_NE(plan.stuck.front().message.find("barbell"), std::string::npos);
  EXPECT_NE(plan.stuck.front().message.find("ring"), std::string::npos);
}

TEST(Disassembly, WhatIsStuckIsAProblemWithBothParts) {
  const MadeUp made({partOf("ring", ring(1.5)),
                     partOf("barbell",
                            {bar({0, 0, -2}, {0, 0, 2}),
                             bar({-3, 0, 2.5}, {3, 0, 2.5}),
                             bar({-3, 0, -2.5}, {3, 0, -2.5})})});
  const ItemResult result = checkDisassembly(makeScene(made.model, made.catalogue));
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems.front().kind, "stuck");
  EXPECT_EQ(result.problems.front().parts.size(), 2U);
}

TEST(Disassembly, ARingLeavesABarWithOneKnobAtItsFreeEnd) {
  const MadeUp made({partOf("ring", ring(1.5)),
                     partOf("club", {bar({0, 0, -2}, {0, 0, 2}), bar({-3, 0, 2.5}, {3, 0, 2.5})})});
  const DisassemblyPlan plan = made.plan();
  EXPECT_TRUE(plan.stuck.empty());
  const Removal& first = plan.groups.front().removals.front();
  ASSERT_EQ(first.legs.size(), 1U);
  EXPECT_NEAR(std::abs(lattice::dot(lattice::normalized(first.legs.front()), kZ)), 1.0, 1e-9);
}

TEST(Disassembly, APegInABendIsDrawnOutAndThenLeavesSideways) {
  // A tunnel along x with a roof that ends at x = 1.6 and a wall across at x = 5.
  std::vector<Prism> tunnel;
  for (const double z : {-1.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      tunnel.push_back(bar({-1.5, y, z}, {z > 0 ? 1.2 : 5.0, y, z}));
    }
  }
  for (const double y : {-1.0, 1.0}) {
    tunnel.push_back(bar({-1.5, y, 0}, {5, y, 0}));
    tunnel.push_back(bar({-1.5, y, 1}, {5, y, 1}));
  }
  tunnel.push_back(bar({-1.5, -1, 0}, {-1.5, 1, 0}));
  tunnel.push_back(bar({5, -1, 0}, {5, 1, 0}));
  tunnel.push_back(bar({5, -1, 1}, {5, 1, 1}));
  const MadeUp made({partOf("tunnel", tunnel), partOf("peg", {bar({-0.5, 0, 0}, {0.5, 0, 0})})});
  const DisassemblyPlan plan = made.plan();
  EXPECT_TRUE(plan.stuck.empty());
  const Removal& first = plan.groups.front().removals.front();
  ASSERT_EQ(first.parts.size(), 1U);
  EXPECT_EQ(made.model.parts[static_cast<std::size_t>(first.parts.front())].part, "peg");
  ASSERT_EQ(first.legs.size(), 2U);
  EXPECT_GT(lattice::dot(first.legs[0], kX), 1.0);
  EXPECT_GT(lattice::dot(first.legs[1], kZ), 1.0);
}

TEST(Disassembly, AWishedUnitLeavesAsAWhole) {
  model::Model model = testing::squareFrame();
  const model::Model other = testing::squareFrame();
  for (model::PlacedPart part : other.parts) {
    part.pose.position = part.pose.position + Vec3{0, 0, 2};
    model.parts.push_back(part);
  }
  // Pins hold the upper square to the lower one.
  for (const double y : {2.0, 6.0}) {
    model.parts.push_back(testing::pinAt("2780", {0, y, 1.5}, kZ));
    model.parts.back().pose.position = {0, y, 1.5};
  }
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  const std::vector<int> upper{8, 9, 10, 11, 12, 13, 14, 15};
  const DisassemblyPlan plan = planDisassembly(scene, {{upper}, {}});
  EXPECT_TRUE(std::any_of(plan.groups.begin(), plan.groups.end(), [&](const auto& group) {
    return group.parts == upper;
  }));
}

TEST(Disassembly, PartsThatAreNotInTheCatalogueArePassedOver) {
  model::Model model = testing::squareFrame();
  model.parts.push_back({"no-such-part", 71, {}, -1, 0, 0});
  const DisassemblyPlan plan = planOf(model);
  EXPECT_TRUE(plan.stuck.empty());
  EXPECT_EQ(plan.groups.front().parts.size(), 8U);
}

TEST(Disassembly, PartsThatTakeTheSameSpaceAreToldElsewhere) {
  model::Model model = testing::squareFrame();
  model.parts.push_back(testing::beamAt("32523", {4, 0, 0}, kY, kZ));
  EXPECT_TRUE(planOf(model).stuck.empty());
}

TEST(Disassembly, AnEmptyModelComesApart) {
  const DisassemblyPlan plan = planOf(model::Model{});
  ASSERT_EQ(plan.groups.size(), 1U);
  EXPECT_TRUE(plan.groups.front().removals.empty());
}

//! All that a part waits for, found part by part.
std::set<int> waitedFor(const BlockingGraph& graph, int direction, int part) {
  std::set<int> found{part};
  std::vector<int> open{part};
  while (!open.empty()) {
    const int next = open.back();
    open.pop_back();
    for (const int blocker : graph.blockers(direction, next)) {
      if (found.insert(blocker).second) {
        open.push_back(blocker);
      }
    }
  }
  return found;
}

TEST(DisassemblyState, ClosuresAreWhatEachPartWaitsForEachOnce) {
  base::Rng rng(7);
  std::vector<parts::Part> made;
  for (int i = 0; i < 60; ++i) {
    const auto anywhere = [&] { return 6.0 * rng.unit() - 3.0; };
    const Vec3 from{anywhere(), anywhere(), anywhere()};
    const Vec3 way = std::array{kX, kY, kZ}[static_cast<std::size_t>(i % 3)];
    made.push_back(partOf("p" + std::to_string(i), {bar(from, from + way)}));
  }
  const MadeUp heap(std::move(made));
  const Scene scene = makeScene(heap.model, heap.catalogue);
  const BlockingGraph graph(scene, Sweep(scene));
  const std::vector<std::vector<int>> neighbours = findNeighbours(scene);
  std::vector<int> all(scene.parts.size());
  std::iota(all.begin(), all.end(), 0);
  const DisassemblyState state(graph, neighbours, all);
  for (std::size_t d = 0; d < graph.directions().size(); ++d) {
    std::set<std::set<int>> wanted;
    for (const int part : all) {
      wanted.insert(waitedFor(graph, static_cast<int>(d), part));
    }
    std::set<std::set<int>> given;
    for (const std::vector<int>& set : state.closures(static_cast<int>(d))) {
      EXPECT_TRUE(std::is_sorted(set.begin(), set.end()));
      EXPECT_TRUE(given.emplace(set.begin(), set.end()).second) << "found twice";
    }
    EXPECT_EQ(given, wanted);
  }
}

}  // namespace
}  // namespace liftarm::analysis
