#include "layout/frame_sites.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "layout/frame_beam.h"

namespace liftarm::layout {
namespace {

using lattice::Vec3;

std::vector<FrameSite> sitesOf(const sketch::Sketch& sketch, const std::string& part) {
  std::vector<FrameSite> sites;
  for (const FrameSite& site : makeLayoutProblem(testing::graphOf(sketch)).sites) {
    if (frameBeams()[static_cast<std::size_t>(site.frame)].part == part) {
      sites.push_back(site);
    }
  }
  return sites;
}

TEST(FrameSites, ARectangleOf4By6HasOneForTheFrameOfItsSize) {
  const std::vector<FrameSite> sites = sitesOf(testing::rectangleSketch(4, 6), "64179");
  ASSERT_EQ(sites.size(), 1U);
  EXPECT_EQ(sites[0].axis, lattice::Axis::kZ);
  EXPECT_EQ(sites[0].arms.size(), 4U);
  EXPECT_EQ(sitesOf(testing::rectangleSketch(6, 4), "64179").size(), 1U);
}

TEST(FrameSites, OtherRectanglesHaveNoneForIt) {
  EXPECT_TRUE(sitesOf(testing::rectangleSketch(4, 5), "64179").empty());
  EXPECT_TRUE(sitesOf(testing::rectangleSketch(6, 6), "64179").empty());
}

TEST(FrameSites, BarsMayStickOutPastTheEndsOfRunsByOneModule) {
  // Rails of 8, rungs 1 from their ends: the frame's bars are 10 long.
  const sketch::Sketch shorter = testing::sketchFrom({{{0, 1, 0}, {0, 9, 0}},
                                                      {{4, 1, 0}, {4, 9, 0}},
                                                      {{0, 2, 0}, {4, 2, 0}},
                                                      {{0, 8, 0}, {4, 8, 0}}});
  EXPECT_EQ(sitesOf(shorter, "64178").size(), 1U);
  sketch::Sketch exact = shorter;
  exact.lines[0].exact = true;
  EXPECT_TRUE(sitesOf(exact, "64178").empty());
}

TEST(FrameSites, OnExactLinesAreForLayer0) {
  sketch::Sketch exact = testing::rectangleSketch(4, 6);
  EXPECT_FALSE(sitesOf(exact, "64179").at(0).exact);
  exact.lines[2].exact = true;
  EXPECT_TRUE(sitesOf(exact, "64179").at(0).exact);
}

TEST(FrameSites, ALineWithAnotherHoleAxisHasNone) {
  sketch::Sketch turned = testing::rectangleSketch(4, 6);
  turned.lines[1].holeAxis = lattice::Axis::kX;
  EXPECT_TRUE(sitesOf(turned, "64179").empty());
}

TEST(FrameSites, AnExactLineOfOneHoleAxisTakesNoHoleThatGoesAnotherWay) {
  sketch::Sketch bearing = testing::rectangleSketch(4, 6);
  bearing.lines[1].holeAxis = lattice::Axis::kZ;
  EXPECT_EQ(sitesOf(bearing, "64179").size(), 1U);
  bearing.lines[1].exact = true;
  EXPECT_TRUE(sitesOf(bearing, "64179").empty());
}

TEST(FrameSites, AJointAtACornerLeavesNone) {
  for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{4, 6, 0}, Vec3{0, 6, 0}}) {
    sketch::Sketch hinged = testing::rectangleSketch(4, 6);
    hinged.joints.push_back({corner, {0, 0, 1}, {}});
    EXPECT_TRUE(sitesOf(hinged, "64179").empty());
  }
}

TEST(FrameSites, AJointWhereTheHoleGoesAnotherWayLeavesNone) {
  // A lever on the middle of a long side, where the frame has no hole along z.
  const auto withLever = [](double y) {
    sketch::Sketch sketch = testing::rectangleSketch(4, 6);
    const sketch::Sketch lever = testing::sketchFrom({{{4, y, 0}, {10, y, 0}}});
    sketch.lines.push_back(lever.lines.front());
    sketch.joints.push_back({{4, y, 0}, {0, 0, 1}, {{1}, {4}}});
    return sketch;
  };
  EXPECT_TRUE(sitesOf(withLever(3), "64179").empty());
  EXPECT_EQ(sitesOf(withLever(2), "64179").size(), 1U);  // there it has one
}

TEST(FrameSites, PoseBringsEveryHoleOntoItsNode) {
  for (const sketch::Sketch& sketch : {testing::rectangleSketch(4, 6),
                                       testing::smallHSketch(),
                                       testing::ladderSketch(),
                                       testing::benchSketch(),
                                       testing::gridSketch(3)}) {
    const LayoutProblem problem = makeLayoutProblem(testing::graphOf(sketch));
    ASSERT_FALSE(problem.sites.empty());
    for (std::size_t s = 0; s < problem.sites.size(); ++s) {
      const FrameSite& site = problem.sites[s];
      const std::string& id = frameBeams()[static_cast<std::size_t>(site.frame)].part;
      const parts::Part& part = *parts::Catalogue::builtIn().find(id);
      int own = 0;
      for (const SiteArm& arm : site.arms) {
        const guide::GuideRun& run = problem.graph.runs[static_cast<std::size_t>(arm.run)];
        EXPECT_EQ(arm.beam.site, static_cast<int>(s));
        EXPECT_GE(arm.beam.start, -1);
        EXPECT_LE(arm.beam.last(), run.edgeCount() + 1);
        for (int i = arm.beam.start; i <= arm.beam.last(); ++i) {
          const Vec3 at = holePosition(problem.graph, run, site.axis, i, 0);
          const Vec3 axis =
              lattice::unitVector(arm.beam.hasHoleAt(i) ? site.axis : axisAcross(run, site.axis));
          EXPECT_TRUE(std::any_of(
              part.features.begin(),
              part.features.end(),
              [&](const parts::Feature& hole) {
                return lattice::length(site.pose.apply(hole.center) - at) < 1e-6 &&
                       std::abs(lattice::dot(site.pose.rotation * hole.axis, axis)) > 0.999;
              }))
              << id << " run " << arm.run << " node " << i;
        }
        own += arm.own;
      }
      EXPECT_EQ(own, static_cast<int>(part.features.size())) << id;
      EXPECT_TRUE(std::is_sorted(site.arms.begin(),
                                 site.arms.end(),
                                 [](const auto& a, const auto& b) { return a.run < b.run; }));
    }
  }
}

TEST(FrameSites, AreNotNearJunctionsOffTheirLattice) {
  // A brace in the direction of 3-4-5 ends off the lattice, where a post begins.
  sketch::Sketch braced = testing::rectangleSketch(4, 6);
  const sketch::Sketch braces =
      testing::sketchFrom({{{4, 0, 0}, {5.8, 2.4, 0}}, {{5.8, 2.4, 0}, {5.8, 2.4, 4}}});
  braced.lines.insert(braced.lines.end(), braces.lines.begin(), braces.lines.end());
  EXPECT_TRUE(sitesOf(braced, "64179").empty());
}

}  // namespace
}  // namespace liftarm::layout
