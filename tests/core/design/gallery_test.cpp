//! The gallery: every model is buildable, and its building steps hold each part once. Large ones,
//! whose models come with the page, take seconds to search for: tests/contract/gallery-made.test.ts
//! judges what is shipped of them.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/disassembly_state.h"
#include "design/design_session.h"
#include "instructions/sequence.h"
#include "model/model_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::filesystem::path galleryFolder() {
  return std::filesystem::path(LIFTARM_SOURCE_DIR) / "public" / "gallery";
}

std::vector<std::string> galleryFiles() {
  std::vector<std::string> files;
  const json index = json::parse(textOf(galleryFolder() / "index.json"));
  for (const json& row : index.at("models")) {
    if (!row.value("made", false)) {
      files.push_back(row.at("file").get<std::string>());
    }
  }
  return files;
}

std::string nameOf(const ::testing::TestParamInfo<std::string>& info) {
  // The folder too: the first steps and the gallery may have a drawing of one name each.
  const std::filesystem::path path(info.param);
  std::string name = path.parent_path().filename().string() + "_" + path.filename().string();
  name.resize(name.size() - std::string(".sketch.json").size());
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

struct SolvedFile {
  json report;
  std::string model;
};

SolvedFile solveFile(const std::string& file, int seed) {
  auto created = DesignSession::create(textOf(galleryFolder() / file),
                                       json{{"seed", seed}, {"preset", "simple"}}.dump());
  EXPECT_TRUE(created.ok());
  if (!created.ok()) {
    return {};
  }
  const auto session = std::move(created).value();
  while (!session->advance(20000)) {
  }
  return {json::parse(session->reportJson()), session->modelJson()};
}

struct Gallery : ::testing::TestWithParam<std::string> {};

TEST_P(Gallery, IsBuildableWithSeveralSeeds) {
  for (const int seed : {1, 2}) {
    const SolvedFile solved = solveFile(GetParam(), seed);
    EXPECT_TRUE(solved.report.value("buildable", false))
        << "seed " << seed << ": " << solved.report.value("problems", json::array()).dump();
  }
}

TEST_P(Gallery, HasStepsThatHoldEachPartOnce) {
  const SolvedFile solved = solveFile(GetParam(), 1);
  const auto planned = planAssemblyJson(solved.model);
  ASSERT_TRUE(planned.ok());
  const json plan = json::parse(planned.value());
  EXPECT_TRUE(plan.at("assemblable").get<bool>()) << plan.at("stuck").dump();
  std::map<int, std::multiset<int>> added;
  for (const json& step : plan.at("steps")) {
    for (const json& add : step.at("adds")) {
      EXPECT_FALSE(add.value("forced", false));
      for (const json& part : add.at("parts")) {
        added[step.at("group").get<int>()].insert(part.get<int>());
      }
    }
  }
  for (const json& group : plan.at("groups")) {
    const auto parts = group.at("parts").get<std::multiset<int>>();
    EXPECT_EQ(added[group.at("id").get<int>()], parts) << "group " << group.at("id");
  }
  EXPECT_EQ(added[0].size(), json::parse(solved.model).at("parts").size());
}

//! How many sets the parts fall into that nothing holds together.
std::size_t countPieces(const std::vector<std::vector<int>>& neighbours, std::set<int> open) {
  std::size_t pieces = 0;
  for (; !open.empty(); ++pieces) {
    std::vector<int> set{*open.begin()};
    open.erase(open.begin());
    for (std::size_t i = 0; i < set.size(); ++i) {
      for (const int next : neighbours[static_cast<std::size_t>(set[i])]) {
        if (open.erase(next) > 0) {
          set.push_back(next);
        }
      }
    }
  }
  return pieces;
}

//! The steps after which parts hang in the air, one sentence each.
std::vector<std::string> hangingSteps(const model::Model& model) {
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  const std::vector<std::vector<int>> neighbours = analysis::findNeighbours(scene);
  std::map<int, std::set<int>> built;
  std::vector<std::string> found;
  int number = 0;
  for (const instructions::Step& step : instructions::planSequence(scene).steps) {
    std::set<int>& of = built[step.group];
    for (const instructions::Add& add : step.adds) {
      of.insert(add.parts.begin(), add.parts.end());
    }
    ++number;
    const std::size_t pieces = countPieces(neighbours, of);
    // Several pieces may stand side by side on the table.
    if (!step.stable && pieces > 1) {
      found.push_back("step " + std::to_string(number) + " of group " + std::to_string(step.group) +
                      " leaves " + std::to_string(pieces) + " pieces");
    }
  }
  return found;
}

TEST_P(Gallery, HasNoStepAfterWhichPartsHangInTheAir) {
  const auto model = model::readModel(solveFile(GetParam(), 1).model);
  ASSERT_TRUE(model.ok());
  EXPECT_THAT(hangingSteps(model.value()), ::testing::IsEmpty());
}

//! A picture of one part alone says nothing, and the next one shows it again.
TEST_P(Gallery, ShowsNoFirstPartAloneBeforeTheSubassemblyThatGoesOnIt) {
  const auto model = model::readModel(solveFile(GetParam(), 1).model);
  ASSERT_TRUE(model.ok());
  const analysis::Scene scene = analysis::makeScene(model.value(), parts::Catalogue::builtIn());
  std::map<int, std::vector<instructions::Step>> stepsOf;
  for (const instructions::Step& step : instructions::planSequence(scene).steps) {
    stepsOf[step.group].push_back(step);
  }
  for (const auto& [group, steps] : stepsOf) {
    const std::vector<instructions::Add>& first = steps.front().adds;
    const bool alone = first.size() == 1 && first.front().subgroup < 0 && steps.size() > 1;
    EXPECT_FALSE(alone && steps[1].adds.front().subgroup >= 0) << "group " << group;
  }
}

//! Two models of the gallery with their gears, as the page has put them in.
TEST(GearedGallery, HasNoStepAfterWhichPartsHangInTheAir) {
  for (const char* name : {"gear-box", "winch"}) {
    const auto model =
        model::readModel(textOf(std::filesystem::path(LIFTARM_SOURCE_DIR) / "tests" / "data" /
                                "geared" / (std::string(name) + ".model.json")));
    ASSERT_TRUE(model.ok()) << name;
    EXPECT_THAT(hangingSteps(model.value()), ::testing::IsEmpty()) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Public, Gallery, ::testing::ValuesIn(galleryFiles()), nameOf);

}  // namespace
}  // namespace liftarm::design
