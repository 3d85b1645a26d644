#include "design/report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "analysis/check.h"
#include "design/covers_in_use.h"
#include "design/json_values.h"
#include "design/keep_blame.h"
#include "design/measures.h"
#include "design/notes_json.h"
#include "design/owned_parts.h"
#include "design/paint.h"
#include "design/well_built_json.h"
#include "layout/components.h"
#include "objective/symmetry_measure.h"
#include "search/cover_bound.h"
#include "sketch/arrangement.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

json problemsJson(const analysis::CheckReport& check) {
  json problems = json::array();
  for (const analysis::Problem& problem : check.problems) {
    problems.push_back({{"kind", problem.kind},
                        {"message", problem.message},
                        {"at", problem.at ? json(pointJson(*problem.at)) : json()},
                        {"parts", problem.parts}});
  }
  return problems;
}

//! Straight stretches for which no beams of the lengths in use fit.
void addBareLines(const ReportInput& input, json* problems) {
  const search::LayoutSnapshot& best = input.search.best();
  const guide::GuidingGraph& graph = input.problem.graph;
  for (std::size_t r = 0; r < best.covers.size(); ++r) {
    if (!best.covers[r].empty()) {
      continue;
    }
    const guide::GuideRun& run = graph.runs[r];
    std::string message = "no beams in use make up the " + std::to_string(run.edgeCount()) +
                          " modules of the line from here";
    message += run.exact ? ": on an exact line they may neither overlap nor stick out" : "";
    problems->push_back(
        {{"kind", "line"},
         {"message", message},
         {"at", pointJson(graph.nodes[static_cast<std::size_t>(run.nodes.front())])},
         {"parts", json::array()}});
  }
}

json junctionProblem(std::string message, const lattice::Vec3& at) {
  return {{"kind", "junction"},
          {"message", std::move(message)},
          {"at", pointJson(at)},
          {"parts", json::array()}};
}

bool isCrowded(const ReportInput& input, const lattice::Vec3& at) {
  return input.crowded && lattice::length(input.crowded->at - at) < sketch::kSamePoint;
}

json keepProblem(const layout::KeepFault& fault) {
  return {{"kind", "keep"},
          {"message", fault.message},
          {"at", pointJson(fault.at)},
          {"line", fault.line},
          {"parts", json::array()}};
}

//! What is kept and is not there, where no reason is known.
std::vector<layout::KeepFault> unkeptOf(const ReportInput& input) {
  return findUnkept(input.sketch, input.problem, input.search.best().covers);
}

//! Why there is no layout, or not all that is kept is in it, before all that follows from it.
json causeJson(const ReportInput& input) {
  json causes = json::array();
  if (input.crowded) {
    causes.push_back(junctionProblem(messageOf(*input.crowded), input.crowded->at));
  }
  if (input.blamed) {
    causes.push_back(keepProblem(*input.blamed));
  } else {
    for (const layout::KeepFault& fault : unkeptOf(input)) {
      causes.push_back(keepProblem(fault));
    }
  }
  for (const layout::KeepFault& fault : input.problem.keepFaults) {
    causes.push_back(keepProblem(fault));
  }
  return causes;
}

//! Places where the search itself knows that it failed; the checks see their effects only. Of a
//! model that holds, nothing is said about how many beams lie in a stack.
void addSearchProblems(const ReportInput& input, bool holds, json* problems) {
  const search::LayoutSnapshot& best = input.search.best();
  for (std::size_t j = 0; j < best.junctions.size(); ++j) {
    const layout::JunctionState& state = best.junctions[j];
    const guide::GuidingGraph& graph = input.problem.graph;
    const lattice::Vec3 at = graph.nodes[static_cast<std::size_t>(graph.junctions[j].node)];
    const int overfull = holds ? state.overfull : 0;
    if (state.violations() == overfull || isCrowded(input, at)) {
      continue;
    }
    std::string message = "the lines that meet here could not all be joined";
    if (state.connection.failed == 0) {
      message = state.gaps > 0 ? "the beams stacked here leave an empty layer"
                               : "more beams are stacked here than a pin can hold";
    }
    problems->push_back(junctionProblem(std::move(message), at));
  }
  addBareLines(input, problems);
}

//! Parts that are owned too few of, and a problem for each.
json addMissing(const ReportInput& input, json* problems) {
  json missing = json::array();
  for (const MissingPart& part : missingParts(input.model, input.settings)) {
    missing.push_back({{"part", part.part}, {"needed", part.needed}, {"owned", part.owned}});
    problems->push_back({{"kind", "owned"},
                         {"message", part.message()},
                         {"at", nullptr},
                         {"parts", json::array()}});
  }
  return missing;
}

json itemsJson(const analysis::CheckReport& check) {
  json items = json::array();
  for (const analysis::CheckItem& item : check.items) {
    items.push_back(
        {{"id", item.id}, {"title", item.title}, {"ok", item.ok}, {"detail", item.detail}});
  }
  return items;
}

//! The straight stretches whose beams are not symmetric though the sketch says they should be.
json asymmetricJson(const ReportInput& input) {
  const guide::GuidingGraph& graph = input.problem.graph;
  const std::vector<layout::Cover>& covers = input.search.best().covers;
  json stretches = json::array();
  if (covers.empty() || graph.symmetries.empty()) {
    return stretches;
  }
  for (const int id : objective::asymmetricRuns(graph, covers, symmetryGroups(graph))) {
    const guide::GuideRun& run = graph.runs[static_cast<std::size_t>(id)];
    const auto node = [&](int n) { return pointJson(graph.nodes[static_cast<std::size_t>(n)]); };
    stretches.push_back({{"from", node(run.nodes.front())}, {"to", node(run.nodes.back())}});
  }
  return stretches;
}

//! Empty layers in stacks that a spacer fills.
int filledGaps(const search::LayoutSnapshot& best) {
  std::size_t count = 0;
  for (const layout::JunctionState& state : best.junctions) {
    count += state.spacers.size();
  }
  return static_cast<int>(count);
}

//! Fewest beams of any layout with no more axles along lines than this one: where an axle covers a
//! line no beam needs to.
int beamsLowerBound(const ReportInput& input) {
  const int bound = search::coverLowerBound(coversInUse(input.problem, input.settings));
  return std::max(0, bound - input.search.best().tallies.axles);
}

}  // namespace

std::string makeReport(const ReportInput& input) {
  const search::LayoutSnapshot& best = input.search.best();
  const layout::Components components =
      best.covers.empty() ? layout::Components{}
                          : layout::findComponents(input.problem.graph, best.covers);
  const objective::Measures measures = measuresOf(input.problem, input.table, best);
  const analysis::CheckReport check =
      analysis::checkModel(input.model, parts::Catalogue::builtIn());
  json problems = causeJson(input);
  for (json& problem : problemsJson(check)) {
    problems.push_back(std::move(problem));
  }
  addSearchProblems(input, check.buildable, &problems);
  const json missing = addMissing(input, &problems);
  json terms = json::object();
  for (const objective::Term& term : objective::kTerms) {
    terms[std::string(term.name)] = rounded(term.value(measures));
  }
  const layout::Tallies& tallies = best.tallies;
  // A stack of more beams than one pin holds is no fault where all of them are held all the same.
  const int broken = tallies.violations() - (check.buildable ? tallies.overfull : 0);
  return json{
      {"name", input.sketch.name},
      {"seed", input.settings.annealing.seed},
      {"preset", std::string(objective::nameOf(input.settings.preset))},
      {"method", input.settings.method},
      {"lines", input.problem.graph.lines},
      {"length", input.problem.graph.edges},
      {"pieces", input.problem.graph.pieces},
      {"components", components.count},
      {"beams", check.counts.beams},
      {"beamsLowerBound", beamsLowerBound(input)},
      {"bricks", check.counts.bricks},
      {"axles", tallies.axles},
      // By the layout, which knows whose line each beam lies on; from the placed parts alone, a
      // beam beside a parallel line one module away counts for both.
      {"gaps", tallies.gaps},
      {"filledGaps", filledGaps(best)},
      {"collisions", std::max(check.counts.collisions, tallies.collisions)},
      {"uncovered", check.counts.uncovered},
      {"failedConnections", std::max(check.counts.failedConnections, tallies.failedConnections)},
      {"pinHeadRatio", rounded(1.0 - objective::pinHeadRatio(measures))},
      {"deviation", rounded(objective::deviation(measures))},
      {"layerRange", measures.componentRange},
      {"rigidSubsets", measures.rigidSubsets},
      {"freedoms", check.motion.free.internal},
      {"freedomsHeld", check.motion.held.internal},
      {"freedomsBeyondJoints", check.motion.free.beyondJoints},
      {"balanced", check.motion.balance.has_value() && check.motion.balance->stable},
      {"assemblable", check.assemblable},
      {"symmetryDeviation", rounded(measures.symmetryDeviation)},
      {"asymmetric", asymmetricJson(input)},
      {"mass", rounded(check.counts.mass)},
      {"size", pointJson(check.counts.size)},
      {"missing", missing},
      {"unusualColours", countUnusualColours(input.model)},
      {"buildable",
       check.buildable && broken == 0 && missing.empty() && !best.covers.empty() &&
           input.problem.keepFaults.empty() && unkeptOf(input).empty()},
      {"items", itemsJson(check)},
      {"wellBuilt", wellBuiltJson(check.wellBuilt)},
      {"notes", notesJson(input.notes)},
      {"problems", problems},
      {"objective", rounded(objective::value(measures, input.settings.annealing.weights))},
      {"terms", terms},
      {"iterations", input.search.iterations()},
      {"grown", input.search.grown()}}
      .dump();
}

}  // namespace liftarm::design
