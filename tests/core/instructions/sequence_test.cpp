#include "instructions/sequence.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/models.h"
#include "core/helpers/replay.h"
#include "core/helpers/shared_data.h"
#include "design/design_session.h"
#include "instructions/congruence.h"
#include "model/model_json.h"

namespace liftarm::instructions {
namespace {

using lattice::Vec3;

model::Model solvedExample(const std::string& name) {
  std::ifstream file(std::string(LIFTARM_SOURCE_DIR) + "/public/examples/" + name + ".sketch.json");
  const std::string sketch(std::istreambuf_iterator<char>(file), {});
  auto session = design::DesignSession::create(sketch, "{}");
  EXPECT_TRUE(session.ok()) << name;
  while (!session.value()->advance(20000)) {
  }
  return model::readModel(session.value()->modelJson()).value();
}

//! Four squares one beside the other: a part number of copies of one subassembly.
model::Model fourSquares() {
  model::Model model = testing::squareFrame();
  const model::Model square = model;
  for (const double shift : {20.0, 40.0, 60.0}) {
    for (model::PlacedPart part : square.parts) {
      part.pose.position = part.pose.position + Vec3{shift, 0, 0};
      model.parts.push_back(part);
    }
  }
  return model;
}

//! Solved once for all tests.
const std::vector<model::Model>& models() {
  static const std::vector<model::Model> kModels = [] {
    std::vector<model::Model> all = testing::buildableModels();
    all.push_back(fourSquares());
    for (const char* name : {"cart", "cube", "house", "box-shelf", "letter-a"}) {
      all.push_back(solvedExample(name));
    }
    return all;
  }();
  return kModels;
}

Sequence sequenceOf(const model::Model& model) {
  return planSequence(analysis::makeScene(model, parts::Catalogue::builtIn()));
}

TEST(Sequence, EveryPartOfAGroupIsAddedOnceWhereItIsBuilt) {
  for (const model::Model& model : models()) {
    const Sequence sequence = sequenceOf(model);
    std::vector<std::vector<int>> added(sequence.groups.size());
    for (const Step& step : sequence.steps) {
      std::vector<int>& of = added[static_cast<std::size_t>(step.group)];
      for (const Add& add : step.adds) {
        of.insert(of.end(), add.parts.begin(), add.parts.end());
      }
    }
    for (std::size_t g = 0; g < added.size(); ++g) {
      std::sort(added[g].begin(), added[g].end());
      EXPECT_EQ(added[g], sequence.groups[g].parts) << model.name << " group " << g;
    }
    EXPECT_EQ(sequence.groups.front().parts.size(), model.parts.size()) << model.name;
  }
}

TEST(Sequence, AGroupIsFinishedBeforeItIsUsed) {
  for (const model::Model& model : models()) {
    const Sequence sequence = sequenceOf(model);
    std::vector<std::size_t> left(sequence.groups.size(), 0);
    for (std::size_t g = 0; g < left.size(); ++g) {
      left[g] = sequence.groups[g].parts.size();
    }
    for (const Step& step : sequence.steps) {
      for (const Add& add : step.adds) {
        if (add.subgroup >= 0) {
          EXPECT_EQ(left[static_cast<std::size_t>(add.subgroup)], 0U) << model.name;
        }
        left[static_cast<std::size_t>(step.group)] -= add.parts.size();
      }
    }
  }
}

TEST(Sequence, AnAddedGroupIsTheGroupOrOneOfItsCopies) {
  for (const model::Model& model : models()) {
    const Sequence sequence = sequenceOf(model);
    for (const Step& step : sequence.steps) {
      for (const Add& add : step.adds) {
        EXPECT_EQ(add.parts.size() > 1, add.subgroup >= 0) << model.name;
        if (add.subgroup < 0) {
          continue;
        }
        const Group& group = sequence.groups[static_cast<std::size_t>(add.subgroup)];
        bool known = group.parts == add.parts;
        for (std::vector<int> copy : group.copies) {
          std::sort(copy.begin(), copy.end());
          known = known || copy == add.parts;
        }
        EXPECT_TRUE(known) << model.name;
      }
    }
  }
}

TEST(Sequence, CopiesHaveTheSamePartsInTheSameOrder) {
  for (const model::Model& model : models()) {
    const Sequence sequence = sequenceOf(model);
    for (const Group& group : sequence.groups) {
      ASSERT_EQ(group.copies.size(), group.mirrored.size());
      ASSERT_EQ(group.copies.size(), group.poses.size());
      for (const std::vector<int>& copy : group.copies) {
        ASSERT_EQ(copy.size(), group.parts.size());
        for (std::size_t i = 0; i < copy.size(); ++i) {
          EXPECT_EQ(model.parts[static_cast<std::size_t>(copy[i])].part,
                    model.parts[static_cast<std::size_t>(group.parts[i])].part);
        }
      }
    }
  }
}

//! Four squares of squares: what is built apart has parts that are built apart.
model::Model squaresOfPairs() {
  model::Model model = fourSquares();
  const model::Model row = model;
  for (model::PlacedPart part : row.parts) {
    part.pose.position = part.pose.position + Vec3{0, 40, 3};
    model.parts.push_back(part);
  }
  return model;
}

TEST(Sequence, WithItsCopiesBuildsEachPartOnce) {
  std::vector<model::Model> all = models();
  all.push_back(squaresOfPairs());
  for (const model::Model& model : all) {
    const Sequence sequence = planSequence(analysis::makeScene(model, parts::Catalogue::builtIn()));
    std::size_t built = 0;
    for (const Step& step : sequence.steps) {
      for (const Add& add : step.adds) {
        const std::size_t times =
            1 + sequence.groups[static_cast<std::size_t>(step.group)].copies.size();
        built += add.subgroup < 0 ? times * add.parts.size() : 0;
      }
    }
    EXPECT_EQ(built, model.parts.size()) << model.name;
  }
}

TEST(Sequence, RepeatedSquaresAreBuiltOnce) {
  const Sequence sequence = sequenceOf(fourSquares());
  ASSERT_EQ(sequence.groups.size(), 2U);
  EXPECT_EQ(sequence.groups[1].copies.size(), 3U);
  EXPECT_EQ(
      std::count(sequence.groups[1].mirrored.begin(), sequence.groups[1].mirrored.end(), true), 0);
}

TEST(Sequence, AStepHasAFewParts) {
  for (const model::Model& model : models()) {
    for (const Step& step : sequenceOf(model).steps) {
      EXPECT_GE(step.adds.size(), 1U);
      EXPECT_LE(step.adds.size(), 6U);
    }
  }
}

TEST(Sequence, OnlyTheFirstPartOfAGroupNeedsNoMove) {
  for (const model::Model& model : models()) {
    std::set<int> begun;
    for (const Step& step : sequenceOf(model).steps) {
      for (const Add& add : step.adds) {
        EXPECT_EQ(add.legs.empty(), begun.insert(step.group).second) << model.name;
      }
    }
  }
}

// Backwards, with real solids: what cannot be taken off that way cannot be put on this way.
TEST(Sequence, NoStepMovesAPartThroughAnother) {
  LIFTARM_NEED_SHARED_DATA();
  for (const model::Model& model : models()) {
    const Sequence sequence = sequenceOf(model);
    EXPECT_TRUE(sequence.stuck.empty()) << model.name;
    std::vector<std::vector<testing::ReplayMove>> moves(sequence.groups.size());
    for (auto step = sequence.steps.rbegin(); step != sequence.steps.rend(); ++step) {
      for (auto add = step->adds.rbegin(); add != step->adds.rend(); ++add) {
        testing::ReplayMove move{add->parts, {}};
        for (auto leg = add->legs.rbegin(); leg != add->legs.rend(); ++leg) {
          move.legs.push_back(-*leg);
        }
        moves[static_cast<std::size_t>(step->group)].push_back(move);
      }
    }
    testing::Replay replay(model);
    for (std::size_t g = 0; g < moves.size(); ++g) {
      for (const std::string& message : replay.play(sequence.groups[g].parts, moves[g])) {
        ADD_FAILURE() << model.name << ": " << message;
      }
    }
  }
}

TEST(Sequence, AFlatFrameIsStableAllTheWay) {
  for (const Step& step : sequenceOf(testing::squareFrame()).steps) {
    EXPECT_TRUE(step.stable);
  }
}

double lowestOf(const analysis::Scene& scene, const std::vector<int>& parts) {
  double lowest = 1e9;
  for (const int part : parts) {
    lowest = std::min(lowest, scene.parts[static_cast<std::size_t>(part)].box.min.z);
  }
  return lowest;
}

//! All examples but four, of which the planner still builds a part in the air first
//! (docs/disassembly.md): cart, airplane, house and tower.
TEST(Sequence, BeginsOnTheTableAndGoesUp) {
  for (const char* name : {"square-frame",
                           "table",
                           "chair",
                           "ladder",
                           "box-shelf",
                           "braced-square",
                           "bridge",
                           "cube",
                           "grid",
                           "hexagon",
                           "letter-a",
                           "seesaw",
                           "windmill"}) {
    const model::Model model = solvedExample(name);
    const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
    const Sequence sequence = planSequence(scene);
    const double table = lowestOf(scene, sequence.groups.front().parts);
    const auto first = std::find_if(sequence.steps.begin(),
                                    sequence.steps.end(),
                                    [](const Step& step) { return step.group == 0; });
    ASSERT_NE(first, sequence.steps.end());
    std::vector<int> begun;
    for (const Add& add : first->adds) {
      begun.insert(begun.end(), add.parts.begin(), add.parts.end());
    }
    EXPECT_LT(lowestOf(scene, begun), table + 0.6) << name;
  }
}

TEST(Match, FindsAMirrorImageOnlyWhereATurnWillNotDo) {
  // An L of two beams and a pin on one end: its mirror image is no turn of it.
  const auto hook = [](double side, Vec3 at) {
    return std::vector<model::PlacedPart>{
        testing::beamAt("32316", at + Vec3{2 * side, 0, 0}, {1, 0, 0}, {0, 0, 1}),
        testing::beamAt("32523", at + Vec3{0, 1, 1}, {0, 1, 0}, {0, 0, 1}),
        testing::pinAt("2780", at + Vec3{0, 0, 0.5}, {0, 0, 1}),
        testing::pinAt("2780", at + Vec3{4 * side, 0, 0.5}, {0, 0, 1})};
  };
  model::Model model;
  for (const auto& [side, at] :
       std::vector<std::pair<double, Vec3>>{{1, {0, 0, 0}}, {-1, {30, 0, 0}}, {1, {60, 0, 0}}}) {
    for (const model::PlacedPart& part : hook(side, at)) {
      model.parts.push_back(part);
    }
  }
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  const auto mirrored = findMatch(scene, {0, 1, 2, 3}, {4, 5, 6, 7});
  const auto same = findMatch(scene, {0, 1, 2, 3}, {8, 9, 10, 11});
  ASSERT_TRUE(mirrored && same);
  EXPECT_TRUE(mirrored->mirrored);
  EXPECT_FALSE(same->mirrored);
  EXPECT_EQ(same->parts, (std::vector<int>{8, 9, 10, 11}));
  EXPECT_FALSE(findMatch(scene, {0, 1, 2}, {4, 5, 7}));
}

TEST(AssemblyJson, HasTheKeysThatThePageReads) {
  using nlohmann::json;
  const auto text = design::planAssemblyJson(model::writeModel(fourSquares()));
  ASSERT_TRUE(text.ok());
  const json plan = json::parse(text.value());
  EXPECT_TRUE(plan.at("assemblable").get<bool>());
  EXPECT_TRUE(plan.at("stuck").empty());
  EXPECT_EQ(plan.at("groups").at(0).at("id"), 0);
  EXPECT_EQ(plan.at("groups").at(1).at("copies").size(), 3U);
  for (const json& step : plan.at("steps")) {
    EXPECT_TRUE(step.at("stable").is_boolean());
    for (const json& add : step.at("adds")) {
      EXPECT_EQ(add.at("travel").size(), 3U);
      EXPECT_EQ(add.at("subgroup").is_null(), add.at("parts").size() == 1U);
    }
  }
}

TEST(AssemblyJson, RefusesWhatIsNoModel) {
  EXPECT_FALSE(design::planAssemblyJson("{}").ok());
}

}  // namespace
}  // namespace liftarm::instructions
