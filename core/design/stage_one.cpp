#include "design/stage_one.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "design/settings.h"
#include "guide/orientation.h"
#include "layout/components.h"
#include "search/paper_orientation.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {

namespace {

using guide::GuidingGraph;
using guide::Orientation;
using nlohmann::json;

constexpr int kRandomOnes = 100;

int differencesOf(const GuidingGraph& graph, const Orientation& runs) {
  int differences = 0;
  for (const guide::Junction& junction : graph.junctions) {
    differences +=
        search::axisDifferences(graph, runs, junction, search::junctionAxis(graph, runs, junction));
  }
  return differences;
}

json figuresOf(const GuidingGraph& graph, const Orientation& runs) {
  std::vector<layout::Cover> covers(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    covers[r].axis = runs[r];
  }
  return json{{"differences", differencesOf(graph, runs)},
              {"components", layout::findComponents(graph, covers).count}};
}

//! "Initially, we randomize all hole orientation variables."
json randomOnes(const GuidingGraph& graph, base::Rng* rng) {
  int sum = 0;
  int least = -1;
  int most = 0;
  for (int i = 0; i < kRandomOnes; ++i) {
    Orientation runs;
    for (const guide::GuideRun& run : graph.runs) {
      runs.push_back(run.axes[rng->below(static_cast<std::uint32_t>(run.axes.size()))]);
    }
    const int differences = differencesOf(graph, runs);
    sum += differences;
    least = least < 0 ? differences : std::min(least, differences);
    most = std::max(most, differences);
  }
  return json{
      {"differences", static_cast<double>(sum) / kRandomOnes}, {"least", least}, {"most", most}};
}

}  // namespace

base::Result<std::string> stageOneJson(std::string_view sketchJson, std::string_view settingsJson) {
  const base::Result<sketch::Reading> reading = sketch::readDrawing(sketchJson);
  if (!reading.ok()) {
    return reading.error();
  }
  const base::Result<Settings> settings = readSettings(settingsJson);
  if (!settings.ok()) {
    return settings.error();
  }
  const GuidingGraph graph = guide::buildGuidingGraph(reading.value().sketch);
  base::Rng rng(settings.value().annealing.seed);
  const json random = randomOnes(graph, &rng);
  const Orientation paper = search::paperStageOne(graph, &rng).runs;
  const Orientation ours =
      guide::estimateOrientation(graph, settings.value().annealing.starts, &rng);
  return json{{"name", reading.value().sketch.name},
              {"nodes", graph.nodes.size()},
              {"runs", graph.runs.size()},
              {"random", random},
              {"paper", figuresOf(graph, paper)},
              {"default", figuresOf(graph, ours)}}
      .dump();
}

}  // namespace liftarm::design
