// The planner's moves, replayed with real solids that the planner never sees.

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/disassembly.h"
#include "analysis/disassembly_state.h"
#include "core/helpers/models.h"
#include "core/helpers/replay.h"
#include "core/helpers/shared_data.h"
#include "design/design_session.h"
#include "model/model_json.h"

namespace liftarm::analysis {
namespace {

//! A sketch of the data beside the project or of our own examples.
std::optional<std::string> sketchText(const std::string& path) {
  if (path.rfind("sketches/", 0) == 0) {
    return testing::readSharedFile(path + ".sketch.json");
  }
  std::ifstream file(std::string(LIFTARM_SOURCE_DIR) + "/" + path + ".sketch.json");
  if (!file) {
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(file), {});
}

model::Model solved(const std::string& path) {
  const std::optional<std::string> sketch = sketchText(path);
  if (!sketch.has_value()) {
    ADD_FAILURE() << "no sketch " << path;
    return {};
  }
  auto session = design::DesignSession::create(*sketch, "{}");
  EXPECT_TRUE(session.ok()) << path;
  while (!session.value()->advance(20000)) {
  }
  return model::readModel(session.value()->modelJson()).value();
}

//! All that is met when the plan is played, group by group.
std::vector<std::string> replayed(const model::Model& model, const DisassemblyPlan& plan) {
  testing::Replay replay(model);
  std::vector<std::string> found;
  for (const DisassemblyGroup& group : plan.groups) {
    std::vector<testing::ReplayMove> moves;
    for (const Removal& removal : group.removals) {
      if (!removal.forced) {
        moves.push_back({removal.parts, removal.legs});
      }
    }
    for (std::string& message : replay.play(group.parts, moves)) {
      found.push_back(std::move(message));
    }
  }
  return found;
}

//! Whether parts hang together by heads in holes.
bool hangTogether(const Scene& scene, const std::vector<int>& parts) {
  const std::vector<std::vector<int>> neighbours = findNeighbours(scene);
  std::set<int> open(parts.begin(), parts.end());
  std::vector<int> found{parts.front()};
  open.erase(parts.front());
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const int next : neighbours[static_cast<std::size_t>(found[i])]) {
      if (open.erase(next) > 0) {
        found.push_back(next);
      }
    }
  }
  return open.empty();
}

void expectTakenApart(const model::Model& model) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  const DisassemblyPlan plan = planDisassembly(scene);
  EXPECT_TRUE(plan.stuck.empty()) << plan.stuck.front().message;
  for (const DisassemblyGroup& group : plan.groups) {
    EXPECT_TRUE(&group == &plan.groups.front() || hangTogether(scene, group.parts)) << model.name;
  }
  for (const std::string& message : replayed(model, plan)) {
    ADD_FAILURE() << model.name << ": " << message;
  }
}

struct ReplayedSketch : ::testing::TestWithParam<std::string> {};

TEST_P(ReplayedSketch, ComesApartWithoutTouching) {
  LIFTARM_NEED_SHARED_DATA();
  expectTakenApart(solved(GetParam()));
}

//! All sketches beside the project, and some of ours.
std::vector<std::string> replayedSketches() {
  std::vector<std::string> paths;
  for (const std::string& name : testing::sharedFileNames("sketches", ".sketch.json")) {
    paths.push_back("sketches/" + name);
  }
  for (const char* name : {"hexagon", "seesaw", "table"}) {
    paths.push_back(std::string("public/examples/") + name);
  }
  return paths;
}

INSTANTIATE_TEST_SUITE_P(All,
                         ReplayedSketch,
                         ::testing::ValuesIn(replayedSketches()),
                         [](const auto& row) {
                           return row.param.substr(row.param.rfind('/') + 1);
                         });

TEST(Replay, HandMadeModelsComeApartWithoutTouching) {
  LIFTARM_NEED_SHARED_DATA();
  for (const model::Model& model : testing::buildableModels()) {
    expectTakenApart(model);
  }
}

TEST(Replay, FindsAMoveThroughAPart) {
  LIFTARM_NEED_SHARED_DATA();
  const model::Model square = testing::squareFrame();
  testing::Replay replay(square);
  // Part 0 lies under parts 2 and 3.
  EXPECT_FALSE(replay.play({0, 1, 2, 3, 4, 5, 6, 7}, {{{0}, {{0, 0, 2}}}}).empty());
  EXPECT_TRUE(replay.play({0, 1}, {{{0}, {{0, 0, 2}}}}).empty());
}

}  // namespace
}  // namespace liftarm::analysis
