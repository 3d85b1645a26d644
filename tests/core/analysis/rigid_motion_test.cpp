#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/assembly.h"
#include "analysis/connection_check.h"
#include "analysis/coverage.h"
#include "analysis/disassembly.h"
#include "analysis/interpenetration.h"
#include "analysis/motion.h"
#include "analysis/real_parts.h"
#include "core/helpers/four_bars.h"
#include "core/helpers/hinged_sketch.h"
#include "core/helpers/solved.h"
#include "model/number_text.h"

namespace liftarm::analysis {
namespace {

using lattice::Pose;
using model::Model;

constexpr std::uint64_t kSketches = 12;
constexpr int kMotions = 3;
constexpr double kAgree = 0.5;  // degrees

//! What the checks say of a model and its sketch, both moved: no reader asks whether the lines may
//! stand so.
struct Verdict {
  Verdict(Model model, const sketch::Sketch& sketch, const Pose& motion) {
    for (model::PlacedPart& part : model.parts) {
      part.pose = testing::after(motion, part.pose);
    }
    model.sketchJson.clear();
    Scene scene = makeScene(model, parts::Catalogue::builtIn());
    scene.sketch = sketch;
    for (sketch::Line& line : scene.sketch->lines) {
      line.from = motion.apply(line.from);
      line.to = motion.apply(line.to);
    }
    for (sketch::Joint& joint : scene.sketch->joints) {
      joint.at = motion.apply(joint.at);
      joint.axis = motion.rotation * joint.axis;
    }
    const std::vector<EdgeCover> coverage = findCoverage(scene);
    const MotionReport report = analyseFreedoms(scene, coverage);
    for (const ItemResult& item : {checkRealParts(scene),
                                   checkInterpenetration(scene),
                                   checkConnections(scene),
                                   checkAssembly(scene, coverage),
                                   checkCoverage(scene, coverage),
                                   checkDisassembly(scene)}) {
      items.push_back(static_cast<int>(item.problems.size()));
    }
    joints = report.joints;
    freedoms = {report.free.internal, report.held.internal, report.free.beyondJoints};
  }

  std::vector<int> items;  // problems of each
  std::vector<int> freedoms;
  std::vector<JointRange> joints;
};

TEST(RigidMotion, ChangesNoVerdict) {
  base::Rng rng(7);
  int models = 0;
  for (std::uint64_t seed = 1; seed <= kSketches; ++seed) {
    const testing::Solved solved = testing::solve(testing::hingedSketch(seed));
    const sketch::Sketch sketch = testing::hingedSketch(seed);
    const Verdict before(solved.model, sketch, {});
    models += solved.report.at("buildable").get<bool>() ? 1 : 0;
    for (int motion = 0; motion < kMotions; ++motion) {
      SCOPED_TRACE("sketch " + std::to_string(seed) + ", motion " + std::to_string(motion));
      const Verdict moved(solved.model, sketch, testing::randomMotion(rng, 100));
      EXPECT_EQ(moved.items, before.items);
      EXPECT_EQ(moved.freedoms, before.freedoms);
      ASSERT_EQ(moved.joints.size(), before.joints.size());
      for (std::size_t j = 0; j < before.joints.size(); ++j) {
        EXPECT_EQ(moved.joints[j].turns, before.joints[j].turns);
        EXPECT_NEAR(moved.joints[j].from.degrees, before.joints[j].from.degrees, kAgree);
        EXPECT_NEAR(moved.joints[j].to.degrees, before.joints[j].to.degrees, kAgree);
      }
    }
  }
  EXPECT_GT(models, 6);
}

}  // namespace
}  // namespace liftarm::analysis
