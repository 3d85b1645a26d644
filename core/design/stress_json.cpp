#include <array>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/freedoms.h"
#include "analysis/freedoms_query.h"
#include "analysis/materials.h"
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
  return {{"ok", true},
          {"message", ""},
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

//! What one must know of the numbers before one believes them.
std::string caveats(const analysis::Scene& scene,
                    const analysis::StressOptions& options,
                    const analysis::StressReport& report) {
  std::string text;
  const auto add = [&](const std::string& sentence) {
    text += (text.empty() ? "" : ". Besides: ") + sentence;
  };
  constexpr double kLeans = 0.01;  // degrees
  if (report.tilt > kLeans) {
    add("It does not stand as drawn: it leans over by " + model::numberText(report.tilt, 1) +
        " degrees and rests so");
  }
  constexpr double kSmall = 0.1;  // of the length: small displacements are what is reckoned with
  analysis::Box box;
  for (const analysis::ScenePart& part : scene.parts) {
    box.add(part.box);
  }
  const double length = analysis::kMillimetresPerModule * lattice::length(box.max - box.min);
  if (report.maxDisplacement > kSmall * length) {
    add("it moves by more than a tenth of its length, too far for these numbers to hold");
  }
  if (options.friction == analysis::FitHold::kHeld) {
    const int ways =
        analysis::findFreedoms(analysis::makeFreedomsQuery(scene, {}, analysis::Friction::kFree))
            .internal;
    if (ways > 0) {
      add("friction alone holds " + std::to_string(ways) +
          " of its freedoms, and how stiff that is, is an assumption");
    }
  }
  return text;
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
    const analysis::StressReport report = analysis::reportStress(scene, state.value());
    answer = reportJson(report);
    answer["message"] = caveats(scene, options.value(), report);
  } else {
    answer = {{"ok", false}, {"message", state.value().message}, {"moving", state.value().moving}};
  }
  return answer.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace liftarm::design
