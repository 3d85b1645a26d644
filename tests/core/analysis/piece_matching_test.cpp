#include "analysis/piece_matching.h"

#include <gtest/gtest.h>

namespace liftarm::analysis {
namespace {

EdgeCover edge(int line, std::vector<int> parts) {
  EdgeCover result;
  result.line = line;
  for (const int part : parts) {
    result.covers.push_back({part, 0.0, {0, 0, 1}});
  }
  return result;
}

TEST(PieceMatching, GivesEachPieceAnAssemblyOfItsOwn) {
  // Either beam could stand for piece 0, only the first for piece 1.
  const PieceMatching matching = matchPieces({edge(0, {0, 1}), edge(1, {0})}, {0, 1}, {0, 1});
  EXPECT_EQ(matching.assemblyOfPiece, (std::vector<int>{1, 0}));
}

TEST(PieceMatching, AnAssemblyMustCoverEveryCoveredEdgeOfItsPiece) {
  const PieceMatching matching = matchPieces({edge(0, {0, 1}), edge(0, {0})}, {0, 1}, {0});
  EXPECT_EQ(matching.assemblyOfPiece, std::vector<int>{0});
}

TEST(PieceMatching, EdgesLeftToMechanismsAskForNoBeam) {
  const PieceMatching matching = matchPieces({edge(0, {}), edge(0, {0})}, {0}, {0});
  EXPECT_EQ(matching.assemblyOfPiece, std::vector<int>{0});
}

TEST(PieceMatching, APieceWithoutAnyBeamIsNotCovered) {
  const PieceMatching matching = matchPieces({edge(0, {0}), edge(1, {})}, {0}, {0, 1});
  EXPECT_EQ(matching.assemblyOfPiece, (std::vector<int>{0, -1}));
  EXPECT_FALSE(matching.covered[1]);
}

TEST(PieceMatching, TakesAwayCoversOfOtherPieces) {
  std::vector<EdgeCover> coverage{edge(0, {0, 1}), edge(1, {0})};
  keepOwnCovers({0, 1}, {0, 1}, coverage);
  ASSERT_EQ(coverage[0].covers.size(), 1U);
  EXPECT_EQ(coverage[0].covers[0].part, 1);
}

}  // namespace
}  // namespace liftarm::analysis
