#include <array>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/scene.h"
#include "analysis/stress.h"
#include "design/design_session.h"
#include "design/json_values.h"
#include "design/stress_options.h"
#include "model/model_json.h"
#include "model/number_text.h"

namespace liftarm::design {

namespace {

using analysis::StressReport;
using lattice::Vec3;
using nlohmann::ordered_json;

constexpr int kDecimals = 9;  // forces and displacements of light models are small

double fine(double value) {
  return rounded(value, kDecimals);
}

ordered_json sampleJson(const analysis::StressSample& sample) {
  const Vec3 d = sample.displacement;
  return ordered_json::array({fine(sample.at.x),
                              fine(sample.at.y),
                              fine(sample.at.z),
                              fine(sample.stress),
                              fine(d.x),
                              fine(d.y),
                              fine(d.z)});
}

ordered_json reportJson(const StressReport& report) {
  ordered_json parts = ordered_json::array();
  ordered_json samples = ordered_json::array();
  for (const analysis::PartStress& part : report.parts) {
    parts.push_back({{"stress", fine(part.stress)},
                     {"safety", fine(part.safety)},
                     {"utilisation", fine(part.utilisation)}});
    ordered_json along = ordered_json::array();
    for (const analysis::StressSample& sample : part.samples) {
      along.push_back(sampleJson(sample));
    }
    samples.push_back(along);
  }
  ordered_json pins = ordered_json::array();
  for (const analysis::PinStress& pin : report.pins) {
    pins.push_back({{"part", pin.part},
                    {"shear", fine(pin.shear)},
                    {"safety", fine(pin.safety)},
                    {"torque", fine(pin.torque)}});
  }
  ordered_json reactions = ordered_json::array();
  for (const analysis::Reaction& reaction : report.reactions) {
    reactions.push_back({{"at", pointJson(reaction.at, kDecimals)},
                         {"force", pointJson(reaction.force, kDecimals)}});
  }
  constexpr double kLeans = 0.01;  // degrees
  const std::string leans = "It does not stand as drawn: it leans over by " +
                            model::numberText(report.tilt, 1) + " degrees and rests so";
  return {{"ok", true},
          {"message", report.tilt > kLeans ? leans : ""},
          {"maxStress", fine(report.maxStress)},
          {"safety", fine(report.safety)},
          {"maxDisplacement", fine(report.maxDisplacement)},
          {"weight", fine(report.weight)},
          {"imbalance", report.imbalance},
          {"tilt", fine(report.tilt)},
          {"up", pointJson(report.up, kDecimals)},
          {"parts", parts},
          {"samples", samples},
          {"pins", pins},
          {"reactions", reactions}};
}

}  // namespace

base::Result<std::string> analyseStressJson(std::string_view modelJson,
                                            std::string_view optionsJson) {
  const base::Result<model::Model> model = model::readModel(modelJson);
  if (!model.ok()) {
    return model.error();
  }
  const base::Result<analysis::StressOptions> options = readStressOptions(optionsJson);
  if (!options.ok()) {
    return options.error();
  }
  const analysis::Scene scene = analysis::makeScene(model.value(), parts::Catalogue::builtIn());
  const base::Result<analysis::StressState> state = analysis::solveStress(scene, options.value());
  if (!state.ok()) {
    return state.error();
  }
  ordered_json answer;
  if (state.value().stands) {
    answer = reportJson(analysis::reportStress(scene, state.value()));
  } else {
    answer = {{"ok", false}, {"message", state.value().message}, {"moving", state.value().moving}};
  }
  return answer.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace liftarm::design
