// Whole models solved by CalculiX from our decks: the same displacements within 2 %.

#include "exporters/calculix.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/helpers/models.h"
#include "core/helpers/solved.h"

namespace liftarm::exporters {
namespace {

using analysis::Six;
using lattice::Vec3;

//! False skips a test on a developer's machine; with CI=true a missing CalculiX is a failure.
bool haveCalculix() {
  if (std::system("command -v ccx > /dev/null 2>&1") == 0) {
    return true;
  }
  const char* ci = std::getenv("CI");
  if (ci != nullptr && std::string_view(ci) == "true") {
    ADD_FAILURE() << "CI=true, but calculix-ccx is missing";
  }
  return false;
}

analysis::StressState solvedState(const model::Model& model,
                                  const analysis::StressOptions& options) {
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  base::Result<analysis::StressState> state = analysis::solveStress(scene, options);
  if (!state.ok() || !state.value().stands) {
    ADD_FAILURE() << model.name << ": "
                  << (state.ok() ? state.value().message : state.error().message);
    return {};
  }
  return std::move(state).value();
}

//! Node by node what CalculiX prints.
std::map<int, Vec3> readDisplacements(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::map<int, Vec3> result;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    int node = 0;
    Vec3 u;
    if (fields >> node >> u.x >> u.y >> u.z) {
      result[node] = u;
    }
  }
  return result;
}

std::map<int, Vec3> runCalculix(const std::string& deck, const std::string& name) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       ("liftarm-ccx-" + name + "-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "deck.inp") << deck;
  const std::string command = "cd '" + folder.string() + "' && ccx deck > deck.log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  const std::map<int, Vec3> result = readDisplacements(folder / "deck.dat");
  std::filesystem::remove_all(folder);
  return result;
}

//! Greatest difference over all nodes as a share of the greatest displacement.
double difference(const analysis::StressState& state, const std::map<int, Vec3>& theirs) {
  double greatest = 0.0;
  double apart = 0.0;
  for (std::size_t i = 0; i < state.displacements.size(); ++i) {
    const Six& six = state.displacements[i];
    const Vec3 ours{six[0], six[1], six[2]};
    const auto found = theirs.find(static_cast<int>(i) + 1);
    if (found == theirs.end()) {
      return 1.0;
    }
    greatest = std::max(greatest, lattice::length(ours));
    apart = std::max(apart, lattice::length(ours - found->second));
  }
  return apart / greatest;
}

#define LIFTARM_NEED_CALCULIX()                              \
  do {                                                       \
    if (!haveCalculix()) {                                   \
      GTEST_SKIP() << "calculix-ccx is not on this machine"; \
    }                                                        \
  } while (false)

struct WholeModel : ::testing::TestWithParam<const char*> {};

TEST_P(WholeModel, IsDisplacedAsCalculixSays) {
  LIFTARM_NEED_CALCULIX();
  const analysis::StressState state = solvedState(testing::solvedExample(GetParam()), {});
  ASSERT_TRUE(state.stands);
  EXPECT_LT(difference(state, runCalculix(writeCalculix(state, GetParam()), GetParam())), 0.02);
}

TEST_P(WholeModel, IsDisplacedAsCalculixSaysUnderALoad) {
  LIFTARM_NEED_CALCULIX();
  const model::Model model = testing::solvedExample(GetParam());
  analysis::StressOptions options;
  options.loads.push_back({testing::middlePart(model), {0.002, 0.001, -0.5}});
  const analysis::StressState state = solvedState(model, options);
  ASSERT_TRUE(state.stands);
  EXPECT_LT(difference(state, runCalculix(writeCalculix(state, GetParam()), GetParam())), 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    Some, WholeModel, ::testing::Values("cube", "house", "table", "airplane", "bridge", "tower"));

TEST(Deck, OfATriangleOfFreePinsIsDisplacedAsCalculixSays) {
  LIFTARM_NEED_CALCULIX();
  analysis::StressOptions options;
  options.friction = analysis::FitHold::kFree;
  options.loads.push_back({{0, 1, 8}, {0, 0, -3.0}});
  const analysis::StressState state = solvedState(testing::pythagoreanTriangle(), options);
  ASSERT_TRUE(state.stands);
  EXPECT_LT(difference(state, runCalculix(writeCalculix(state, "triangle"), "triangle")), 0.02);
}

TEST(Deck, OfAModelWithABushIsDisplacedAsCalculixSays) {
  LIFTARM_NEED_CALCULIX();
  const analysis::StressState state = solvedState(testing::squareWithAxle(), {});
  ASSERT_TRUE(state.stands);
  EXPECT_LT(difference(state, runCalculix(writeCalculix(state, "bush"), "bush")), 0.02);
}

TEST(Deck, HasNoLineThatCalculixCannotRead) {
  const analysis::StressState state = solvedState(testing::squareFrame(), {});
  std::istringstream deck(writeCalculix(state, "name\nwith *a line break"));
  std::string line;
  int lines = 0;
  while (std::getline(deck, line)) {
    EXPECT_LE(line.size(), 132U) << line;
    EXPECT_FALSE(line.empty());
    ++lines;
  }
  EXPECT_GT(lines, 100);
}

}  // namespace
}  // namespace liftarm::exporters
