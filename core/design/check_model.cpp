#include <nlohmann/json.hpp>

#include "analysis/check.h"
#include "design/design_session.h"
#include "design/json_values.h"
#include "design/motion_json.h"
#include "design/well_built_json.h"
#include "model/model_json.h"

namespace liftarm::design {

namespace {

using nlohmann::ordered_json;

ordered_json problemJson(const analysis::Problem& problem) {
  ordered_json json{{"kind", problem.kind}, {"message", problem.message}};
  if (problem.at.has_value()) {
    json["at"] = pointJson(*problem.at);
  }
  json["parts"] = problem.parts;
  return json;
}

ordered_json reportJson(const std::string& name, const analysis::CheckReport& report) {
  ordered_json items = ordered_json::array();
  for (const analysis::CheckItem& item : report.items) {
    items.push_back(
        {{"id", item.id}, {"title", item.title}, {"ok", item.ok}, {"detail", item.detail}});
  }
  ordered_json problems = ordered_json::array();
  for (const analysis::Problem& problem : report.problems) {
    problems.push_back(problemJson(problem));
  }
  const analysis::CheckCounts& counts = report.counts;
  const ordered_json motion = motionJson(report.motion);
  return {{"name", name},
          {"buildable", report.buildable},
          {"beams", counts.beams},
          {"bricks", counts.bricks},
          {"gaps", counts.gaps},
          {"collisions", counts.collisions},
          {"uncovered", counts.uncovered},
          {"failedConnections", counts.failedConnections},
          {"assemblable", report.assemblable},
          {"freedoms", motion.at("freedoms")},
          {"joints", motion.at("joints")},
          {"balance", motion.at("balance")},
          {"mass", rounded(counts.mass)},
          {"size", pointJson(counts.size)},
          {"items", items},
          {"wellBuilt", wellBuiltJson(report.wellBuilt)},
          {"problems", problems}};
}

}  // namespace

base::Result<std::string> checkModelJson(std::string_view modelJson) {
  const base::Result<model::Model> model = model::readModel(modelJson);
  if (!model.ok()) {
    return model.error();
  }
  const analysis::CheckReport report =
      analysis::checkModel(model.value(), parts::Catalogue::builtIn());
  return reportJson(model.value().name, report)
      .dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace liftarm::design
