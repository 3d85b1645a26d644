#include "search/orbit_covers.h"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "layout/bent_beam.h"
#include "search/cover_steps.h"
#include "search/search_state.h"

namespace liftarm::search {
namespace {

using lattice::Axis;
using layout::Beam;
using layout::Cover;
using testing::LayoutBench;

//! A rectangle of 8 by 6 that a mirror cuts in half; an L beam in one of its lower corners.
class MirroredRectangle : public ::testing::Test {
 protected:
  static sketch::Sketch mirrored() {
    sketch::Sketch sketch = testing::rectangleSketch(8, 6);
    sketch::Symmetry symmetry;
    symmetry.kind = sketch::Symmetry::Kind::kReflection;
    symmetry.normal = {1, 0, 0};
    symmetry.offset = 4.0;
    sketch.symmetries = {symmetry};
    return sketch;
  }

  MirroredRectangle()
      : bench_(mirrored()), covers_(bench_.problem, {2, 3, 5, 7, 9, 11, 13, 15}), rng_(1) {
    const guide::GuidingGraph& graph = bench_.problem.graph;
    for (std::size_t r = 0; r < graph.runs.size(); ++r) {
      const lattice::Vec3 middle = 0.5 * (graph.nodes[at(graph.runs[r].nodes.front())] +
                                          graph.nodes[at(graph.runs[r].nodes.back())]);
      base_ = middle.y < 1.0 ? static_cast<int>(r) : base_;
      left_ = middle.x < 1.0 ? static_cast<int>(r) : left_;
      right_ = middle.x > 7.0 ? static_cast<int>(r) : right_;
    }
    std::vector<layout::Bend> bends;
    layout::addBends(graph, layout::bentBeamIndex("32526"), base_, left_, 0, &bends);
    for (const layout::Bend& bend : bends) {
      if (bend.arm.holes == 3 && covers_.hasRoom(base_, Axis::kZ, bend.arm)) {
        arm_ = bend.arm;
        mateArm_ = bend.mateArm;
      }
    }
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  std::optional<Cover> propose(const std::vector<Beam>& fixed) {
    layout::Layout layout(bench_.problem, bench_.solver);
    RunCoverer coverer(bench_.problem, {2, 3, 5, 7, 9, 11, 13, 15}, {});
    CoverRequest request{base_, Axis::kZ};
    request.fixed = fixed;
    return covers_.propose(&coverer, &layout, request, &rng_);
  }

  LayoutBench bench_;
  OrbitCovers covers_;
  base::Rng rng_;
  int base_ = -1;
  int left_ = -1;
  int right_ = -1;
  Beam arm_;
  Beam mateArm_;
};

TEST_F(MirroredRectangle, TakesABentBeamAtBothEndsOfTheLineThatTheMirrorCuts) {
  ASSERT_EQ(arm_.mate, left_);
  EXPECT_TRUE(covers_.mayBend(base_, left_, Axis::kZ, 0));
  const std::optional<Cover> cover = propose({arm_});
  ASSERT_TRUE(cover.has_value());
  const std::vector<Beam> arms = layout::armsOf(*cover);
  ASSERT_EQ(arms.size(), 2U);
  EXPECT_EQ(arms[0], arm_);
  EXPECT_EQ(arms[1].mate, right_);
  EXPECT_EQ(arms[1].start, 8 - arm_.last());
}

TEST_F(MirroredRectangle, KeepsTheArmsOfACoverThatHasThemAtBothEnds) {
  const std::optional<Cover> first = propose({arm_});
  ASSERT_TRUE(first.has_value());
  const std::optional<Cover> again = propose(layout::armsOf(*first));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(layout::armsOf(*again), layout::armsOf(*first));
}

TEST_F(MirroredRectangle, HasNoRoomForAnArmThatMeetsItsImage) {
  Beam longArm = arm_;
  longArm.start = 0;
  longArm.holes = 5;  // to the middle
  EXPECT_FALSE(covers_.hasRoom(base_, Axis::kZ, longArm));
  EXPECT_FALSE(propose({longArm}).has_value());
}

TEST_F(MirroredRectangle, PutsTheImageOfABentBeamOnTheOtherSide) {
  layout::Layout layout(bench_.problem, bench_.solver);
  covers_.place(&layout, left_, {Axis::kZ, {mateArm_}});
  const Cover& image = layout.run(right_).cover;
  ASSERT_EQ(image.beams.size(), 1U);
  EXPECT_EQ(image.beams[0].mate, base_);
}

TEST_F(MirroredRectangle, FreesBothRunsOfABentBeam) {
  std::vector<Cover> covers(bench_.problem.graph.runs.size());
  covers[at(base_)].beams = {arm_};
  covers[at(left_)].beams = {mateArm_};
  covers_.release(left_, covers);
  EXPECT_FALSE(covers_.binds(left_));
  EXPECT_FALSE(covers_.binds(right_));
  EXPECT_FALSE(covers_.binds(base_));
}

TEST_F(MirroredRectangle, LosesBothImagesOfABentBeamThatIsTakenOff) {
  SearchState state(bench_.problem, bench_.solver, {});
  state.place(left_, {Axis::kZ, {mateArm_, {4, 3, 1}}});
  state.place(base_, propose({arm_}).value());
  straighten(state, left_, {});
  for (const int run : {base_, left_, right_}) {
    EXPECT_FALSE(layout::hasArms(state.coverOf(run))) << run;
  }
}

}  // namespace
}  // namespace liftarm::search
