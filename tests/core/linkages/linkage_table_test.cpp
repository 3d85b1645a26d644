#include "linkages/linkage_table.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkages/linkage_json.h"
#include "linkages/linkage_sketch.h"
#include "sketch/moving_layers.h"
#include "sketch/sketch_json.h"

namespace liftarm::linkages {
namespace {

FourBarLimits fewLinks() {
  FourBarLimits limits;
  limits.mostCrank = 3;
  limits.mostRocker = 8;
  limits.mostFrame = 9;
  limits.mostCoupler = 9;
  return limits;
}

const LinkageTable& table() {
  static const LinkageTable made = [] {
    LinkageTable table(fewLinks());
    while (!table.advance(100)) {
    }
    return table;
  }();
  return made;
}

//! The curve of a linkage that is in the table.
std::vector<Point> curveOf(const FourBar& bar, int from, int to) {
  std::vector<Point> curve;
  const std::vector<Point> turns = turnsOf(180);
  for (int i = from; i < to; ++i) {
    curve.push_back(poseOf(bar, turns[static_cast<std::size_t>(i)]).point);
  }
  return curve;
}

FourBar known() {
  for (const Coupler& coupler : allCouplers(9)) {
    if (coupler.beam.second > 0 && coupler.length > 3.9) {
      const auto links = crankRockers(coupler.length, fewLinks());
      if (!links.empty()) {
        const auto [crank, rocker, frame] = links[links.size() / 2];
        return {crank, rocker, frame, coupler};
      }
    }
  }
  return {};
}

TEST(LinkageTable, FindsTheLinkageThatDrewAClosedPath) {
  const std::vector<Point> curve = curveOf(known(), 0, 180);
  const auto answers = table().find({{curve, true}});
  ASSERT_FALSE(answers.empty());
  EXPECT_LT(answers.front().match.error, 0.01);
}

TEST(LinkageTable, FindsItTurnedMirroredAndMoved) {
  const Placement placement{turnsOf(11)[3], true, {7, -2}};
  std::vector<Point> curve;
  for (const Point p : curveOf(known(), 0, 180)) {
    curve.push_back(placement.apply(p));
  }
  const auto answers = table().find({{curve, true}});
  ASSERT_FALSE(answers.empty());
  EXPECT_LT(answers.front().match.error, 0.01);
}

TEST(LinkageTable, FindsTheLinkageThatDrewAnOpenPath) {
  const auto answers = table().find({{curveOf(known(), 20, 90), false}});
  ASSERT_FALSE(answers.empty());
  EXPECT_LT(answers.front().match.error, 0.02);
}

TEST(LinkageTable, AnswersAreDifferentLinkages) {
  const auto answers = table().find({{curveOf(known(), 0, 180), true}});
  for (std::size_t i = 1; i < answers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const FourBar& a = answers[i].bar;
      const FourBar& b = answers[j].bar;
      EXPECT_FALSE(a.crank == b.crank && a.rocker == b.rocker && a.frame == b.frame &&
                   a.coupler.length == b.coupler.length);
    }
  }
}

TEST(LinkageTable, AWalkersPivotsAreAboveItsSole) {
  PathQuestion question{{{{-2, 0}, {2, 0}, {1, 1}, {-1, 1}}, true}, PathKind::kFoot};
  for (const LinkageAnswer& answer : table().find(question)) {
    for (const Point pivot : pivotsOf(answer)) {
      EXPECT_GE(pivot.v, 1.0);
    }
  }
}

TEST(LinkageTable, SlicesDoNotMatter) {
  FourBarLimits limits = fewLinks();
  limits.mostCoupler = 4;
  LinkageTable one(limits);
  LinkageTable other(limits);
  while (!one.advance(7)) {
  }
  while (!other.advance(100000)) {
  }
  ASSERT_EQ(one.curves(), other.curves());
  const PathQuestion question{{curveOf(known(), 0, 180), true}};
  const auto a = one.find(question);
  const auto b = other.find(question);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].match.error, b[i].match.error);
  }
}

TEST(LinkageSketch, IsLegalAndAsksForAFullTurnThatLayersAllow) {
  const auto answers = table().find({{curveOf(known(), 0, 180), true}});
  ASSERT_FALSE(answers.empty());
  for (const LinkageAnswer& answer : answers) {
    const std::string text = sketch::writeSketch(sketchOf(answer, {lattice::Axis::kY, 3.0}));
    const auto read = sketch::readSketch(text);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read.value().joints.size(), 4U);
    EXPECT_EQ(read.value().joints.front().range->front(), -180.0);
    EXPECT_FALSE(sketch::movingLayers(read.value(), 2).empty());
  }
}

TEST(LinkageSketch, ThePointOfTheSketchIsOnThePathOfThePoses) {
  const auto answers = table().find({{curveOf(known(), 0, 180), true}});
  ASSERT_FALSE(answers.empty());
  const LinkageAnswer& answer = answers.front();
  for (const FourBarPose& pose : posesOf(answer, 12)) {
    EXPECT_NEAR(length(pose.crankPin - pivotsOf(answer)[0]), answer.bar.crank, 1e-9);
    EXPECT_NEAR(length(pose.rockerPin - pivotsOf(answer)[1]), answer.bar.rocker, 1e-9);
  }
}

TEST(LinkageJson, RefusesWhatIsNoPathWithItsPlace) {
  const auto refusal = [](const std::string& text) {
    const auto read = readPath(text);
    return read.ok() ? std::string("accepted") : read.error().message;
  };
  const std::string head = R"({"format": "technic-path", "version": 1, "points": )";
  EXPECT_NE(refusal(head + "[[0,0,0]]}").find("points: 1 points"), std::string::npos);
  EXPECT_NE(refusal(head + "[[0,0,0],[1,2,3],[4,1,5]]}").find("no plane"), std::string::npos);
  EXPECT_NE(refusal(head + "[[0,0,0],[0.1,0,0]], \"kind\": \"line\"}").find("shorter"),
            std::string::npos);
  EXPECT_NE(refusal(head + R"([[0,0,0],[5,0,0]], "kind": "walk"})").find("kind: "),
            std::string::npos);
  EXPECT_EQ(refusal(head + "[[0,0,0],[5,0,0],[5,0,4]]}"), "accepted");
}

TEST(LinkageJson, AnswersLieInThePlaneOfThePath) {
  const auto reply = linkagesJson(
      table(),
      R"({"format": "technic-path", "version": 1, "points": [[4,0,0],[4,3,0],[4,3,2],[4,0,2]]})");
  ASSERT_TRUE(reply.ok()) << reply.error().message;
  const auto document = nlohmann::json::parse(reply.value());
  EXPECT_EQ(document.at("plane"), "x");
  ASSERT_FALSE(document.at("answers").empty());
  for (const auto& line : document.at("answers")[0].at("sketch").at("lines")) {
    EXPECT_EQ(line.at("from")[0], 4.0);
    EXPECT_EQ(line.at("holeAxis"), "x");
  }
}

}  // namespace
}  // namespace liftarm::linkages
