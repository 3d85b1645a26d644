#include "design/looseness.h"

#include <string>

#include "analysis/check.h"
#include "analysis/freedoms_query.h"
#include "analysis/scene.h"
#include "design/model_builder.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {

std::function<bool(const search::LayoutSnapshot&)> makeBuildable(
    const layout::LayoutProblem& problem,
    const mechanisms::MechanismTable& table,
    const sketch::Sketch& sketch) {
  const std::string text = sketch::writeSketch(sketch);
  return [&problem, &table, text](const search::LayoutSnapshot& snapshot) {
    const model::Model model = buildModel(problem, table, snapshot, "", text);
    return analysis::isBuildable(model, parts::Catalogue::builtIn());
  };
}

std::function<int(const search::LayoutSnapshot&)> makeHeld(
    const layout::LayoutProblem& problem, const mechanisms::MechanismTable& table) {
  return [&problem, &table](const search::LayoutSnapshot& snapshot) {
    const model::Model model = buildModel(problem, table, snapshot, "", "");
    const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
    return analysis::findFreedoms(analysis::makeFreedomsQuery(scene, {}, analysis::Friction::kHeld))
        .internal;
  };
}

}  // namespace liftarm::design
