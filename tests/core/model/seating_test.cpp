#include "model/seating.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/four_bars.h"
#include "core/helpers/sketches.h"
#include "core/helpers/solved.h"

namespace liftarm::model {
namespace {

double errorOf(const Model& model) {
  std::vector<const parts::Part*> parts;
  for (const PlacedPart& part : model.parts) {
    parts.push_back(parts::Catalogue::builtIn().find(part.part));
  }
  return seatingError(model, parts, findConnections(model, parts::Catalogue::builtIn()));
}

Model seated(Model model) {
  seatHeads(model, parts::Catalogue::builtIn());
  return model;
}

Model shaken(Model model, base::Rng& rng, double by) {
  for (PlacedPart& part : model.parts) {
    for (double& entry : part.pose.rotation.m) {
      entry += by * (2 * rng.unit() - 1);
    }
    for (int k = 0; k < 3; ++k) {
      part.pose.position[k] += by * (2 * rng.unit() - 1);
    }
  }
  return model;
}

bool samePoses(const Model& a, const Model& b) {
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    if (!(a.parts[i].pose.position == b.parts[i].pose.position) ||
        a.parts[i].pose.rotation.m != b.parts[i].pose.rotation.m) {
      return false;
    }
  }
  return true;
}

TEST(Seating, TakesTheRoundingOfFourDecimalsOut) {
  base::Rng rng(1);
  for (const Model& model :
       {testing::crankAndRocker(1.0), testing::squareWithAxle(), testing::stackedThinBeams()}) {
    const Model rough = shaken(model, rng, 5e-5);
    EXPECT_GT(errorOf(rough), 1e-5);
    EXPECT_LT(errorOf(seated(rough)), 1e-9);
  }
}

//! A frame with both diagonals and a post, solved: its many pins in one plane hardly tell how far
//! what they hold may yield out of it.
Model bracedFrame() {
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {12, 0, 0}},
                                               {{0, 9, 0}, {12, 9, 0}},
                                               {{0, 0, 0}, {0, 9, 0}},
                                               {{12, 0, 0}, {12, 9, 0}},
                                               {{0, 0, 0}, {12, 9, 0}},
                                               {{0, 9, 0}, {12, 0, 0}},
                                               {{2, 0, 0}, {2, 0, 3}}});
  return testing::solve(sketch, {{"rounds", 0}}).model;
}

Model turnedAndRounded(Model model, double degrees, double unit) {
  model::PlacedPart frame;
  testing::turn(frame, {0, 0, 1}, degrees);
  for (PlacedPart& part : model.parts) {
    part.pose = testing::after(frame.pose, part.pose);
    for (double& entry : part.pose.rotation.m) {
      entry = unit * std::round(entry / unit);
    }
    for (int k = 0; k < 3; ++k) {
      part.pose.position[k] = unit * std::round(part.pose.position[k] / unit);
    }
  }
  return model;
}

TEST(Seating, MovesNoPartFurtherThanRoundingMay) {
  std::vector<Model> models = testing::buildableModels();
  models.push_back(bracedFrame());
  for (const Model& model : models) {
    for (const double degrees : {10.0, 33.0, 121.0}) {
      for (const double unit : {1e-9, 1e-6, 1e-4}) {
        const Model rounded = turnedAndRounded(model, degrees, unit);
        const Model result = seated(rounded);
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
          const lattice::Vec3 move = result.parts[i].pose.position - rounded.parts[i].pose.position;
          EXPECT_LT(lattice::length(move), 100 * unit)
              << model.name << " part " << i << ", " << degrees << " degrees, " << unit;
        }
      }
    }
  }
}

TEST(Seating, LeavesExactModelsAsTheyAre) {
  for (const Model& model : testing::buildableModels()) {
    EXPECT_TRUE(samePoses(seated(model), model)) << model.name;
  }
}

TEST(Seating, LeavesAFaultWhereItIs) {
  Model model = testing::squareFrame();
  testing::turn(model.parts[0], {0, 0, 1}, 2.0);
  EXPECT_TRUE(samePoses(seated(model), model));
  Model moved = testing::crankAndRocker(1.0);
  moved.parts[5].pose.position.z += 0.05;
  EXPECT_TRUE(samePoses(seated(moved), moved));
}

}  // namespace
}  // namespace liftarm::model
