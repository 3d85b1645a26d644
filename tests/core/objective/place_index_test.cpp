#include "objective/place_index.h"

#include <cmath>

#include <gtest/gtest.h>

namespace liftarm::objective {
namespace {

using lattice::Axis;

TEST(PlaceIndex, FindsWhatWasEnteredThere) {
  PlaceIndex index;
  index.add(Axis::kX, {1, 2, 3}, 7);
  EXPECT_EQ(index.find(Axis::kX, {1, 2, 3}), 7);
}

TEST(PlaceIndex, TellsAxesApart) {
  PlaceIndex index;
  index.add(Axis::kX, {1, 2, 3}, 7);
  EXPECT_EQ(index.find(Axis::kY, {1, 2, 3}), -1);
}

TEST(PlaceIndex, FindsPlacesThatRoundingMovedAcrossABucketsWall) {
  PlaceIndex index;
  index.add(Axis::kZ, {0.125, 0.375, -0.625}, 1);
  EXPECT_EQ(index.find(Axis::kZ, {0.125 - 1e-9, 0.375 + 1e-9, -0.625 - 1e-9}), 1);
}

TEST(PlaceIndex, TellsPlacesInOneBucketApart) {
  PlaceIndex index;
  index.add(Axis::kZ, {2.4, 0, 0}, 1);
  index.add(Axis::kZ, {2.45, 0, 0}, 2);
  EXPECT_EQ(index.find(Axis::kZ, {2.45, 0, 0}), 2);
}

TEST(PlaceIndex, GivesTheFirstOfSeveral) {
  PlaceIndex index;
  index.add(Axis::kZ, {0, 0, 0}, 4);
  index.add(Axis::kZ, {0, 0, 0}, 5);
  EXPECT_EQ(index.find(Axis::kZ, {0, 0, 0}), 4);
}

}  // namespace
}  // namespace liftarm::objective
