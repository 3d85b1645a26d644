#include "analysis/cover_matching.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace liftarm::analysis {
namespace {

using lattice::Vec3;

constexpr Vec3 kUp{0, 0, 1};

EdgeCover edgeAt(int line, double x, double z) {
  return {line, 0, {x, 0, z}, {x + 1, 0, z}, {}};
}

//! Matches covers by beams that all begin at x = 0.
void match(std::vector<EdgeCover>* edges) {
  for (EdgeCover& edge : *edges) {
    for (Cover& cover : edge.covers) {
      cover.place = edge.from.x + 0.5;
    }
  }
  matchCovers(*edges);
}

std::vector<int> partsOf(const EdgeCover& edge) {
  std::vector<int> parts;
  for (const Cover& cover : edge.covers) {
    parts.push_back(cover.part);
  }
  return parts;
}

TEST(MatchCovers, GivesABeamBetweenTwoLinesToTheOneThatTheModelSays) {
  // Lines at 0 and 2. Beam 0 lies at 1, for the upper line; beam 1 at -2, for the lower one.
  std::vector<EdgeCover> edges{edgeAt(0, 0, 0), edgeAt(1, 0, 2)};
  edges[0].covers = {{0, 1.0, kUp, false}, {1, -2.0, kUp, true}};
  edges[1].covers = {{0, -1.0, kUp, true}};
  match(&edges);
  EXPECT_EQ(partsOf(edges[0]), std::vector<int>{1});
  EXPECT_EQ(partsOf(edges[1]), std::vector<int>{0});
}

TEST(MatchCovers, LeavesNoEdgeBareForWhatTheModelSays) {
  std::vector<EdgeCover> edges{edgeAt(0, 0, 0), edgeAt(1, 0, 2)};
  edges[0].covers = {{0, 1.0, kUp, true}, {1, -1.0, kUp, false}};
  edges[1].covers = {{0, -1.0, kUp, false}};
  match(&edges);
  EXPECT_EQ(partsOf(edges[0]), std::vector<int>{1});
  EXPECT_EQ(partsOf(edges[1]), std::vector<int>{0});
}

TEST(MatchCovers, DoesNotTakeABeamThatSticksOutForTheNextLinesBeam) {
  // Beam 0 covers the edge at 0 and sticks out over the one at 1, four layers from that line's
  // beam.
  std::vector<EdgeCover> edges{edgeAt(0, 0, -1), edgeAt(1, 1, 0)};
  edges[0].covers = {{0, -1.0, kUp, true}};
  edges[1].covers = {{0, -2.0, kUp, false}, {1, 2.0, kUp, true}};
  match(&edges);
  EXPECT_EQ(partsOf(edges[0]), std::vector<int>{0});
  EXPECT_EQ(partsOf(edges[1]), std::vector<int>{1});
}

TEST(MatchCovers, TakesTheNearestWhereTheModelSaysNothing) {
  std::vector<EdgeCover> edges{edgeAt(0, 0, 0), edgeAt(1, 0, 3)};
  edges[0].covers = {{0, 1.0, kUp, false}, {1, 2.0, kUp, false}};
  edges[1].covers = {{0, -2.0, kUp, false}, {1, -1.0, kUp, false}};
  match(&edges);
  EXPECT_EQ(partsOf(edges[0]), std::vector<int>{0});
  EXPECT_EQ(partsOf(edges[1]), std::vector<int>{1});
}

TEST(MatchCovers, TellsTheParallelBarsOfAFrameApart) {
  std::vector<EdgeCover> edges{edgeAt(0, 0, 0), edgeAt(1, 0, 4)};
  edges[0].covers = {{0, 0.0, kUp, true, 0}};
  edges[1].covers = {{0, 0.0, kUp, true, 1}};
  match(&edges);
  EXPECT_EQ(partsOf(edges[0]), std::vector<int>{0});
  EXPECT_EQ(partsOf(edges[1]), std::vector<int>{0});
}

TEST(MatchCovers, IsNotDecidedByWhatRoundingLeavesOfALayer) {
  std::set<std::vector<int>> answers;
  for (const double noise : {-1e-10, 0.0, 1e-10}) {
    std::vector<EdgeCover> edges{edgeAt(0, 0, 0), edgeAt(1, 0, 2)};
    edges[0].covers = {{0, 1.0 + noise, kUp, true}, {1, -1.0, kUp, true}};
    edges[1].covers = {{0, -1.0, kUp, true}, {1, -1.0 - noise, kUp, true}};
    match(&edges);
    answers.insert(partsOf(edges[0]));
  }
  EXPECT_EQ(answers.size(), 1U);
}

}  // namespace
}  // namespace liftarm::analysis
