#include "analysis/coverage.h"

#include <gtest/gtest.h>

#include "analysis/scene.h"

namespace liftarm::analysis {
namespace {

constexpr lattice::Vec3 kY{0, 1, 0};

TEST(CountGaps, LeavesOutAnotherLinesBeamBesideABridgedEdge) {
  // Edge 1 goes on from the node at x = 1, where the first line's beam lies on layer 0. The beam
  // of the third line, three layers off, passes there too.
  const model::Model model;
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  std::vector<EdgeCover> coverage{{0, 0, {0, 0, 0}, {1, 0, 0}, {{0, 0.0, kY, true}}},
                                  {1, 0, {1, 0, 0}, {2, 0, 0}, {{1, -3.0, kY, false}}},
                                  {2, 0, {2, -4, 0}, {3, -4, 0}, {{1, 1.0, kY, true}}}};
  EXPECT_EQ(countGaps(scene, coverage), 0);
  coverage[2].covers[0].said = false;  // now it may be either line's
  EXPECT_GT(countGaps(scene, coverage), 0);
}

}  // namespace
}  // namespace liftarm::analysis
