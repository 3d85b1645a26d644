#include "design/stress_deck.h"

#include "analysis/scene.h"
#include "analysis/stress.h"
#include "exporters/ansys.h"
#include "exporters/calculix.h"

namespace liftarm::design {

base::Result<std::string> writeStressDeck(const model::Model& model, const std::string& format) {
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  std::string title = model.name.empty() ? "Model" : model.name;
  analysis::StressOptions options;
  base::Result<analysis::StressState> state = analysis::solveStress(scene, options);
  if (state.ok() && !state.value().stands) {
    options.friction = analysis::FitHold::kLocked;
    title += " (all fits locked)";
    state = analysis::solveStress(scene, options);
  }
  if (!state.ok()) {
    return state.error();
  }
  if (!state.value().stands) {
    return base::Error{base::Status::kSingular, state.value().message};
  }
  return format == "inp" ? exporters::writeCalculix(state.value(), title)
                         : exporters::writeAnsys(state.value(), title);
}

}  // namespace liftarm::design
