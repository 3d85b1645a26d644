#include <nlohmann/json.hpp>

#include "design/design_session.h"
#include "design/json_values.h"
#include "instructions/sequence.h"
#include "model/model_json.h"

namespace liftarm::design {

namespace {

using nlohmann::ordered_json;

ordered_json addJson(const instructions::Add& add) {
  const lattice::Vec3 last = add.legs.empty() ? lattice::Vec3{} : add.legs.back();
  ordered_json json{{"parts", add.parts}, {"travel", pointJson(last)}};
  json["subgroup"] = add.subgroup < 0 ? ordered_json() : ordered_json(add.subgroup);
  if (add.legs.size() > 1) {
    json["via"] = ordered_json::array();
    for (std::size_t i = 0; i + 1 < add.legs.size(); ++i) {
      json["via"].push_back(pointJson(add.legs[i]));
    }
  }
  if (add.forced) {
    json["forced"] = true;
  }
  return json;
}

ordered_json sequenceJson(const instructions::Sequence& sequence) {
  ordered_json groups = ordered_json::array();
  for (std::size_t g = 0; g < sequence.groups.size(); ++g) {
    const instructions::Group& group = sequence.groups[g];
    groups.push_back({{"id", g},
                      {"parts", group.parts},
                      {"copies", group.copies},
                      {"mirrored", group.mirrored}});
  }
  ordered_json steps = ordered_json::array();
  for (const instructions::Step& step : sequence.steps) {
    ordered_json adds = ordered_json::array();
    for (const instructions::Add& add : step.adds) {
      adds.push_back(addJson(add));
    }
    steps.push_back({{"group", step.group}, {"adds", adds}, {"stable", step.stable}});
  }
  ordered_json stuck = ordered_json::array();
  for (const analysis::StuckParts& s : sequence.stuck) {
    stuck.push_back({{"parts", s.parts}, {"by", s.by}, {"message", s.message}});
  }
  return {{"assemblable", sequence.stuck.empty()},
          {"groups", groups},
          {"steps", steps},
          {"stuck", stuck}};
}

}  // namespace

base::Result<std::string> planAssemblyJson(std::string_view modelJson) {
  const base::Result<model::Model> model = model::readModel(modelJson);
  if (!model.ok()) {
    return model.error();
  }
  if (model.value().parts.size() > analysis::kMaxPartsTakenApart) {
    return base::Error{base::Status::kUnsupported,
                       "a building sequence is planned for at most " +
                           std::to_string(analysis::kMaxPartsTakenApart) + " parts"};
  }
  const analysis::Scene scene = analysis::makeScene(model.value(), parts::Catalogue::builtIn());
  return sequenceJson(instructions::planSequence(scene)).dump();
}

}  // namespace liftarm::design
