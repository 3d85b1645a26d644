#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "analysis/check.h"
#include "core/helpers/layouts.h"
#include "design/model_builder.h"
#include "layout/stack.h"
#include "search/annealer.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using testing::LayoutBench;

struct NamedSketch {
  const char* name;
  sketch::Sketch sketch;
};

std::vector<NamedSketch> smallSketches() {
  return {{"square", testing::squareSketch(8)},
          {"corner", testing::cornerSketch(5)},
          {"tee", testing::teeSketch()},
          {"triangle", testing::triangleSketch(2)},
          {"grid", testing::gridSketch(2)},
          {"cube", testing::cubeSketch(6)},
          {"smallCube", testing::cubeSketch(4)},
          {"house", testing::houseSketch()},
          {"seesaw", testing::seesawSketch()}};
}

search::LayoutSnapshot snapshotOf(const layout::Layout& layout) {
  search::LayoutSnapshot snapshot;
  for (std::size_t r = 0; r < layout.problem().graph.runs.size(); ++r) {
    snapshot.covers.push_back(layout.run(static_cast<int>(r)).cover);
  }
  for (std::size_t j = 0; j < layout.problem().graph.junctions.size(); ++j) {
    snapshot.junctions.push_back(layout.junction(static_cast<int>(j)));
  }
  snapshot.tallies = layout.tallies();
  return snapshot;
}

//! Spacers are none.
bool isBeam(const model::Model& model, int part) {
  const std::string& id = model.parts[static_cast<std::size_t>(part)].part;
  return id != layout::kSpacerPart &&
         parts::Catalogue::builtIn().find(id)->partClass == parts::PartClass::kBeam;
}

struct LayoutModel : ::testing::TestWithParam<NamedSketch> {
  LayoutModel() : bench(GetParam().sketch), text(sketch::writeSketch(GetParam().sketch)) {}

  [[nodiscard]] model::Model modelOf(const search::LayoutSnapshot& snapshot) const {
    return buildModel(bench.problem, testing::defaultTable(), snapshot, "test", text);
  }

  LayoutBench bench;
  std::string text;
};

//! Problems in which a connector or a pin takes part, as text.
std::string connectorProblems(const model::Model& model) {
  std::string text;
  for (const analysis::Problem& problem :
       analysis::checkModel(model, parts::Catalogue::builtIn()).problems) {
    const bool ofThisKind =
        problem.kind == "collision" || problem.kind == "sharedHole" || problem.kind == "badFit";
    const bool beamsOnly = std::all_of(
        problem.parts.begin(), problem.parts.end(), [&](int part) { return isBeam(model, part); });
    if (ofThisKind && !beamsOnly) {
      text += problem.kind + ": " + problem.message + "\n";
    }
  }
  return text;
}

struct LayoutOnTheWay : LayoutModel {};

TEST_P(LayoutOnTheWay, HasConnectorsThatCollideWithNothingWhereBeamsDoNot) {
  // Layouts on the way of a search: joined as far as it went, often with gaps and failures.
  search::AnnealingOptions options;
  options.starts = 5;
  options.startTemperature = 30.0;
  search::Annealer annealer(bench.problem, bench.solver, options);
  int seen = 0;
  for (int step = 0; step < 400 && seen < 40; ++step) {
    annealer.advance(5);
    if (annealer.current().tallies().collisions == 0) {
      ++seen;
      EXPECT_EQ(connectorProblems(modelOf(snapshotOf(annealer.current()))), "")
          << "after " << annealer.iterations() << " moves";
    }
  }
  EXPECT_GT(seen, 0);
}

TEST_P(LayoutModel, IsBuildableWhereTheSearchCountsNoViolation) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    search::AnnealingOptions options;
    options.seed = seed;
    options.starts = 10;
    options.minIterations = 300;
    options.iterationsPerRun = 40;
    options.maxRounds = 2;
    search::Annealer annealer(bench.problem, bench.solver, options);
    while (!annealer.advance(1000)) {
    }
    if (annealer.best().tallies.violations() == 0) {
      const analysis::CheckReport report =
          analysis::checkModel(modelOf(annealer.best()), parts::Catalogue::builtIn());
      std::string messages;
      for (const analysis::Problem& problem : report.problems) {
        messages += problem.kind + ": " + problem.message + "\n";
      }
      EXPECT_TRUE(report.buildable) << "seed " << seed << "\n" << messages;
    }
  }
}

TEST_P(LayoutModel, CountsTheBeamsAndBricksOfTheTallies) {
  search::AnnealingOptions options;
  options.starts = 10;
  options.minIterations = 100;
  options.iterationsPerRun = 10;
  options.maxRounds = 0;
  search::Annealer annealer(bench.problem, bench.solver, options);
  while (!annealer.advance(1000)) {
  }
  const analysis::CheckReport report =
      analysis::checkModel(modelOf(annealer.best()), parts::Catalogue::builtIn());
  const layout::Tallies& tallies = annealer.best().tallies;
  EXPECT_EQ(report.counts.beams, tallies.beams);
  EXPECT_EQ(report.counts.bricks, tallies.beams + tallies.connectors);
}

INSTANTIATE_TEST_SUITE_P(Sketches,
                         LayoutModel,
                         ::testing::ValuesIn(smallSketches()),
                         [](const auto& row) { return std::string(row.param.name); });

std::vector<NamedSketch> sketchesBut(const std::string& name) {
  std::vector<NamedSketch> sketches = smallSketches();
  sketches.erase(std::remove_if(sketches.begin(),
                                sketches.end(),
                                [&](const NamedSketch& row) { return row.name == name; }),
                 sketches.end());
  return sketches;
}

INSTANTIATE_TEST_SUITE_P(Sketches,
                         LayoutOnTheWay,
                         ::testing::ValuesIn(sketchesBut("house")),
                         [](const auto& row) { return std::string(row.param.name); });

// A square connector's corner reaches into a slanted beam: the clearance is of round ends only.
INSTANTIATE_TEST_SUITE_P(Slanted,
                         LayoutOnTheWay,
                         ::testing::Values(NamedSketch{"house", testing::houseSketch()}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Mechanisms, AreFreeOfCollisionsAndHoldTogetherOnTheirOwn) {
  const mechanisms::MechanismTable& table = testing::defaultTable();
  for (std::size_t id = 0; id < table.size(); ++id) {
    model::Model model;
    for (const mechanisms::MechanismPart& part : table.oriented(static_cast<int>(id)).shape.parts) {
      model::PlacedPart placed;
      placed.part = part.id;
      placed.pose = part.pose;
      model.parts.push_back(placed);
    }
    for (const analysis::Problem& problem :
         analysis::checkModel(model, parts::Catalogue::builtIn()).problems) {
      EXPECT_NE(problem.kind, "collision") << id << ": " << problem.message;
    }
  }
}

}  // namespace
}  // namespace liftarm::design
