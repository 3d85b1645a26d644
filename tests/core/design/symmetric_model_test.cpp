#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/sketches.h"
#include "design/design_session.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

sketch::Sketch mirrored(sketch::Sketch sketch, int axis, double offset) {
  sketch::Symmetry symmetry;
  symmetry.kind = sketch::Symmetry::Kind::kReflection;
  symmetry.normal = {0, 0, 0};
  symmetry.normal[axis] = 1.0;
  symmetry.offset = offset;
  sketch.symmetries.push_back(symmetry);
  return sketch;
}

json reportOf(const sketch::Sketch& sketch, int seed, int orbits = 1) {
  const json settings{{"seed", seed}, {"set", {{"search.orbits", orbits}}}};
  auto session = DesignSession::create(sketch::writeSketch(sketch), settings.dump());
  EXPECT_TRUE(session.ok());
  while (!session.value()->advance(2000)) {
  }
  return json::parse(session.value()->reportJson());
}

//! Edges of 20, longer than the longest beam: where they are joined has to agree as well.
sketch::Sketch mirroredBox() {
  return mirrored(mirrored(mirrored(testing::cubeSketch(20), 0, 10.0), 1, 10.0), 2, 10.0);
}

TEST(SymmetricModel, OfAMirroredBoxForEverySeed) {
  for (int seed = 1; seed <= 5; ++seed) {
    const json report = reportOf(mirroredBox(), seed);
    EXPECT_TRUE(report["buildable"].get<bool>()) << seed;
    EXPECT_EQ(report["symmetryDeviation"].get<double>(), 0.0) << seed;
    EXPECT_TRUE(report["asymmetric"].empty()) << report["asymmetric"];
  }
}

TEST(SymmetricModel, IsNotWhatTheSearchFindsByItself) {
  const json report = reportOf(mirroredBox(), 1, 0);
  EXPECT_TRUE(report["buildable"].get<bool>());
  EXPECT_GT(report["symmetryDeviation"].get<double>(), 0.0);
  EXPECT_FALSE(report["asymmetric"].empty());
}

TEST(SymmetricModel, OfAHouseFromFrontToBack) {
  for (int seed = 1; seed <= 3; ++seed) {
    const json report = reportOf(mirrored(testing::houseSketch(), 1, 4.0), seed);
    EXPECT_TRUE(report["buildable"].get<bool>()) << seed;
    EXPECT_EQ(report["symmetryDeviation"].get<double>(), 0.0) << seed;
  }
}

//! Two rafters meet in the mirror with holes along the ridge: on one layer they would collide.
TEST(SymmetricModel, NamesTheRaftersThatNoPartsCanMirror) {
  const json report = reportOf(mirrored(testing::houseSketch(), 0, 4.0), 1);
  EXPECT_TRUE(report["buildable"].get<bool>());
  EXPECT_EQ(report["asymmetric"].size(), 4U);
  for (const json& stretch : report["asymmetric"]) {
    EXPECT_NE(stretch["from"][2], stretch["to"][2]) << stretch;
    EXPECT_NE(stretch["from"][0], stretch["to"][0]) << stretch;
  }
}

}  // namespace
}  // namespace liftarm::design
