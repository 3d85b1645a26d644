#include "gears/train.h"

#include <cmath>
#include <cstddef>
#include <set>

#include <gtest/gtest.h>

#include "base/rng.h"
#include "gears/gear_sizes.h"
#include "parts/catalogue.h"

namespace liftarm::gears {
namespace {

std::vector<int> teethInStock() {
  std::vector<int> teeth;
  for (const GearSize& size : gearSizesOf(parts::Catalogue::builtIn().parts())) {
    teeth.push_back(size.teeth);
  }
  return teeth;
}

TrainRequest requestFrom(Place to, double ratio) {
  TrainRequest request;
  request.to = to;
  request.ratio = ratio;
  request.teeth = teethInStock();
  return request;
}

//! Gears that mesh, by their places alone: the first of each two is nearer to the driving shaft.
std::vector<std::pair<TrainGear, TrainGear>> meshesOf(const Train& train) {
  std::vector<std::pair<TrainGear, TrainGear>> meshes;
  for (const TrainGear& p : train.gears) {
    for (const TrainGear& q : train.gears) {
      const Place way = train.shafts[static_cast<std::size_t>(q.shaft)] -
                        train.shafts[static_cast<std::size_t>(p.shaft)];
      const double apart = std::hypot(way.u, way.v);
      if (p.shaft < q.shaft && p.plane == q.plane && apart * 16 - p.teeth - q.teeth < 1e-9) {
        meshes.emplace_back(p, q);
      }
    }
  }
  return meshes;
}

double ratioOf(const Train& train) {
  double ratio = 1.0;
  for (const auto& [driving, driven] : meshesOf(train)) {
    ratio *= static_cast<double>(driven.teeth) / static_cast<double>(driving.teeth);
  }
  return ratio;
}

TEST(GearSizes, AreTheEightThatMeshOnTheLattice) {
  EXPECT_EQ(teethInStock(), (std::vector<int>{8, 12, 16, 20, 24, 28, 36, 40}));
  int meshes = 0;
  for (const int a : teethInStock()) {
    for (const int b : teethInStock()) {
      meshes += meshOnLattice(a, b) ? 1 : 0;
    }
  }
  EXPECT_EQ(meshes, 18);
}

TEST(Train, TakesTwoGearsWhereTwoWillDo) {
  const auto train = findTrain(requestFrom({3, 0}, 5.0));
  ASSERT_TRUE(train.has_value());
  ASSERT_EQ(train->gears.size(), 2U);
  EXPECT_EQ(train->gears[0].teeth, 8);
  EXPECT_EQ(train->gears[1].teeth, 40);
  EXPECT_TRUE(train->reverses());
}

TEST(Train, MultipliesRatiosOverAShaftInBetween) {
  const auto train = findTrain(requestFrom({5, 0}, 15.0));
  ASSERT_TRUE(train.has_value());
  EXPECT_EQ(train->shafts.size(), 3U);
  EXPECT_EQ(train->gears.size(), 4U);
  EXPECT_NEAR(train->ratio, 15.0, 1e-12);
}

TEST(Train, BridgesADistanceByGearsThatChangeNoRatio) {
  const auto train = findTrain(requestFrom({15, 0}, 1.0));
  ASSERT_TRUE(train.has_value());
  EXPECT_EQ(train->shafts.size(), 4U);
  EXPECT_EQ(train->gears.size(), 4U);
}

TEST(Train, GoesRoundACornerWhereShaftsLieNotInARow) {
  const auto train = findTrain(requestFrom({3, 2}, 3.0));
  ASSERT_TRUE(train.has_value());
  EXPECT_NEAR(train->ratio, 3.0, 0.03 * 3.0);
}

TEST(Train, StandsWhereThereAreBearingsAlone) {
  TrainRequest request = requestFrom({5, 0}, 15.0);
  request.bears = [](Place place) { return place.v == 0 && place.u == 2; };
  const auto train = findTrain(request);
  ASSERT_TRUE(train.has_value());
  EXPECT_EQ(train->shafts[1], (Place{2, 0}));
  request.bears = [](Place /*at*/) { return false; };
  EXPECT_FALSE(findTrain(request).has_value());
}

TEST(Train, KeepsClearOfWhatTurnsThereAlready) {
  TrainRequest request = requestFrom({3, 0}, 5.0);
  const auto alone = findTrain(request);
  request.taken = {{{5, 0}, 0, tipRadius(24)}};
  const auto beside = findTrain(request);
  ASSERT_TRUE(alone.has_value() && beside.has_value());
  EXPECT_EQ(alone->gears.front().plane, 0);
  EXPECT_EQ(beside->gears.front().plane, 1);
}

TEST(Train, HasTheRatioThatItSaysForAnyPairOfShafts) {
  base::Rng rng(7);
  for (int i = 0; i < 40; ++i) {
    const auto place = [&] { return static_cast<int>(rng.below(25)) - 12; };
    const Place to{place(), place()};
    const double ratio = 1.0 + static_cast<double>(rng.below(190)) / 10.0;
    if (to == Place{}) {
      continue;
    }
    const auto train = findTrain(requestFrom(to, i % 2 == 0 ? ratio : 1.0 / ratio));
    ASSERT_TRUE(train.has_value()) << to.u << ' ' << to.v << ' ' << ratio;
    EXPECT_EQ(meshesOf(*train).size() + 1, train->shafts.size());
    EXPECT_NEAR(ratioOf(*train), train->ratio, 1e-9);
    EXPECT_EQ(train->shafts.back(), to);
  }
}

}  // namespace
}  // namespace liftarm::gears
