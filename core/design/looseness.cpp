#include "design/looseness.h"

#include <string>
#include <vector>

#include "analysis/balance.h"
#include "analysis/check.h"
#include "analysis/coverage.h"
#include "analysis/freedoms_query.h"
#include "analysis/motion.h"
#include "analysis/scene.h"
#include "analysis/well_built_items.h"
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

int countStandingFaults(const layout::LayoutProblem& problem,
                        const mechanisms::MechanismTable& table,
                        const sketch::Sketch& sketch,
                        const search::LayoutSnapshot& snapshot) {
  const model::Model model = buildModel(problem, table, snapshot, "", sketch::writeSketch(sketch));
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  const std::vector<analysis::EdgeCover> coverage = analysis::findCoverage(scene);
  analysis::MotionReport motion;
  motion.balance = analysis::checkBalance(scene);
  double faults = 0.0;
  for (const analysis::Figure& figure :
       analysis::judgeStanding({scene, coverage, motion}).figures) {
    const bool isFault =
        figure.name == "belowBase" || figure.name == "liftedFeet" || figure.name == "fallsOver";
    faults += isFault ? figure.value : 0.0;
  }
  return static_cast<int>(faults);
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
