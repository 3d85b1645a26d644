#include "objective/hinge_graph.h"

#include <gtest/gtest.h>

namespace liftarm::objective {
namespace {

using lattice::Axis;
using lattice::Vec3;
using Lines = std::vector<std::pair<Axis, Vec3>>;

//! Bars of a plane, each pinned at points whose lines run along z.
class PlaneLinkage {
 public:
  explicit PlaneLinkage(const std::vector<Vec3>& points) {
    for (const Vec3& point : points) {
      lines_.emplace_back(Axis::kZ, point);
    }
    first_.assign(points.size(), -1);
  }

  void bar(std::initializer_list<int> points) {
    const int body = graph_.addBody(true);
    for (const int p : points) {
      int& first = first_[static_cast<std::size_t>(p)];
      if (first >= 0) {
        graph_.addHinge(p, first, body);
      } else {
        first = body;
      }
    }
  }

  int mobility() {
    graph_.setLines(lines_);
    return graph_.mobility();
  }

 private:
  HingeGraph graph_;
  Lines lines_;
  std::vector<int> first_;
};

TEST(HingeGraph, ASquareOfFourBarsFolds) {
  PlaneLinkage square({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  square.bar({0, 1});
  square.bar({1, 2});
  square.bar({2, 3});
  square.bar({3, 0});
  EXPECT_EQ(square.mobility(), 1);
}

TEST(HingeGraph, ABracedSquareIsRigid) {
  PlaneLinkage square({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  square.bar({0, 1});
  square.bar({1, 2});
  square.bar({2, 3});
  square.bar({3, 0});
  square.bar({0, 2});
  EXPECT_EQ(square.mobility(), 0);
}

TEST(HingeGraph, ATriangleIsRigid) {
  PlaneLinkage triangle({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}});
  triangle.bar({0, 1});
  triangle.bar({1, 2});
  triangle.bar({2, 0});
  EXPECT_EQ(triangle.mobility(), 0);
}

TEST(HingeGraph, AParallelogramWithAThirdBarMovesThoughItsCountSaysNot) {
  // Gruebler counts 3 (5 - 1) - 2 * 6 = 0: the third bar is parallel, so it says nothing new.
  PlaneLinkage linkage({{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {0, 5, 0}, {4, 5, 0}, {8, 5, 0}});
  linkage.bar({0, 1, 2});
  linkage.bar({3, 4, 5});
  linkage.bar({0, 3});
  linkage.bar({1, 4});
  linkage.bar({2, 5});
  EXPECT_EQ(linkage.mobility(), 1);
}

TEST(HingeGraph, TwoBarsOnTwoPinsAreOne) {
  PlaneLinkage pair({{0, 0, 0}, {1, 0, 0}});
  pair.bar({0, 1});
  pair.bar({0, 1});
  EXPECT_EQ(pair.mobility(), 0);
}

TEST(HingeGraph, ThreeBarsOnOnePinHaveTwoFreedoms) {
  PlaneLinkage fan({{0, 0, 0}});
  fan.bar({0});
  fan.bar({0});
  fan.bar({0});
  EXPECT_EQ(fan.mobility(), 2);
}

TEST(HingeGraph, AConnectorThatSpinsIsNoFreedom) {
  HingeGraph graph;
  const int beam = graph.addBody(true);
  const int connector = graph.addBody(false);
  graph.addHinge(0, beam, connector);
  graph.setLines({{Axis::kX, {0, 0, 0}}});
  EXPECT_EQ(graph.mobility(), 0);
}

TEST(HingeGraph, ABeamThatHangsOnASpinningConnectorMovesInTwoWays) {
  HingeGraph graph;
  const int beam = graph.addBody(true);
  const int connector = graph.addBody(false);
  const int other = graph.addBody(true);
  graph.addHinge(0, beam, connector);
  graph.addHinge(1, connector, other);
  graph.setLines({{Axis::kX, {0, 0, 0}}, {Axis::kY, {0, 0, 0}}});
  EXPECT_EQ(graph.mobility(), 2);
}

TEST(HingeGraph, MergedBodiesAreOneFromThenOn) {
  HingeGraph graph;
  const int a = graph.addBody(true);
  const int b = graph.addBody(true);
  const int c = graph.addBody(true);
  graph.addHinge(0, a, b);
  graph.addHinge(1, b, c);
  graph.merge(a, c);
  graph.setLines({{Axis::kX, {0, 0, 0}}, {Axis::kX, {0, 3, 0}}});
  EXPECT_EQ(graph.mobility(), 0);
  EXPECT_EQ(graph.rootOf(a), graph.rootOf(b));
}

}  // namespace
}  // namespace liftarm::objective
