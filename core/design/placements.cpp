#include "design/placements.h"

#include <nlohmann/json.hpp>

#include "design/covers_in_use.h"
#include "design/json_values.h"
#include "design/model_builder.h"
#include "layout/axle.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "search/cover_bound.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using search::CoverKind;

const char* nameOf(CoverKind kind) {
  switch (kind) {
    case CoverKind::kStraight:
      return "straight";
    case CoverKind::kBent:
      return "bent";
    case CoverKind::kFrame:
      return "frame";
    case CoverKind::kAxle:
      return "axle";
  }
  return "";
}

const std::string& partOf(search::CoverPart part) {
  const auto index = static_cast<std::size_t>(part.index);
  switch (part.kind) {
    case CoverKind::kStraight:
      break;
    case CoverKind::kBent:
      return layout::bentBeams()[index].part;
    case CoverKind::kFrame:
      return layout::frameBeams()[index].part;
    case CoverKind::kAxle:
      return layout::axleParts()[index].part;
  }
  return straightBeamPart(part.index).id;
}

ordered_json runsJson(const guide::GuidingGraph& graph) {
  ordered_json runs = ordered_json::array();
  for (const guide::GuideRun& run : graph.runs) {
    const auto node = [&](int n) { return pointJson(graph.nodes[static_cast<std::size_t>(n)]); };
    runs.push_back({{"from", node(run.nodes.front())}, {"to", node(run.nodes.back())}});
  }
  return runs;
}

int modulesOf(const sketch::Sketch& sketch) {
  int modules = 0;
  for (const sketch::Line& line : sketch.lines) {
    modules += line.length;
  }
  return modules;
}

}  // namespace

base::Result<std::string> placementsJson(std::string_view sketchJson,
                                         std::string_view settingsJson) {
  const base::Result<sketch::Sketch> sketch = sketch::readSketch(sketchJson);
  if (!sketch.ok()) {
    return sketch.error();
  }
  const base::Result<Settings> settings = readSettings(settingsJson);
  if (!settings.ok()) {
    return settings.error();
  }
  if (const int modules = modulesOf(sketch.value()); modules > kMostPlacedModules) {
    return base::Error{base::Status::kInvalidInput,
                       "the lines are " + std::to_string(modules) +
                           " modules long; what may be laid is listed for at most " +
                           std::to_string(kMostPlacedModules)};
  }
  const layout::LayoutProblem problem = layout::makeLayoutProblem(
      guide::buildGuidingGraph(sketch.value(), bridgingOf(settings.value())));
  const search::CoverTable table = coversInUse(problem, settings.value());
  ordered_json edges = ordered_json::array();
  for (const search::TableEdge& edge : table.edges) {
    edges.push_back({{"run", edge.run}, {"index", edge.index}});
  }
  ordered_json covers = ordered_json::array();
  for (const search::TableCover& cover : table.covers) {
    covers.push_back({{"kind", nameOf(cover.part.kind)},
                      {"part", partOf(cover.part)},
                      {"parts", cover.parts},
                      {"runs", cover.runs},
                      {"edges", cover.edges}});
  }
  ordered_json limits = ordered_json::array();
  for (const auto& [part, owned] : settings.value().owned) {
    limits.push_back({{"part", part}, {"owned", owned}});
  }
  return ordered_json{{"format", "liftarm-placements"},
                      {"version", 1},
                      {"name", sketch.value().name},
                      {"runs", runsJson(problem.graph)},
                      {"edges", edges},
                      {"covers", covers},
                      {"rivals", table.rivals},
                      {"limits", limits},
                      {"quickBound", search::coverLowerBound(table)}}
      .dump();
}

}  // namespace liftarm::design
