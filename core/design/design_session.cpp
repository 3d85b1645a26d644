#include "design/design_session.h"

#include <nlohmann/json.hpp>

#include "design/model_builder.h"
#include "design/report.h"
#include "design/settings.h"
#include "guide/beam_bound.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

mechanisms::MechanismTable makeTable(const Settings& settings) {
  mechanisms::CompositionOptions options;
  options.partIds = settings.connectors;
  options.maxParts = settings.mechanismParts;
  return mechanisms::MechanismTable(
      mechanisms::composeMechanisms(parts::Catalogue::builtIn(), options));
}

class Session final : public DesignSession {
 public:
  Session(sketch::Sketch sketch, Settings settings)
      : sketch_(std::move(sketch)),
        settings_(std::move(settings)),
        table_(makeTable(settings_)),
        solver_(table_),
        problem_(layout::makeLayoutProblem(guide::buildGuidingGraph(sketch_))),
        annealer_(problem_, solver_, settings_.annealing) {}

  bool advance(std::uint32_t iterations) override { return annealer_.advance(iterations); }

  [[nodiscard]] std::string progressJson() const override {
    const layout::Tallies& t = annealer_.best().tallies;
    return json{{"done", annealer_.done()},
                {"phase", annealer_.phase()},
                {"iterations", annealer_.iterations()},
                {"fraction", annealer_.fraction()},
                {"objective", annealer_.best().energy},
                {"temperature", annealer_.temperature()},
                {"beams", t.beams},
                {"gaps", t.gaps},
                {"collisions", t.collisions},
                {"failedConnections", t.failedConnections},
                {"improvements", annealer_.improvements()}}
        .dump();
  }

  [[nodiscard]] std::string modelJson() const override { return model::writeModel(model()); }

  [[nodiscard]] std::string reportJson() const override {
    return makeReport({problem_, settings_, table_, annealer_, sketch_, model()});
  }

 private:
  [[nodiscard]] model::Model model() const {
    const std::string sketchText = sketch::writeSketch(sketch_);
    if (annealer_.best().covers.empty()) {
      return {sketch_.name, {}, sketchText};  // asked before the first step
    }
    return buildModel(problem_, table_, annealer_.best(), sketch_.name, sketchText);
  }

  sketch::Sketch sketch_;
  Settings settings_;
  mechanisms::MechanismTable table_;
  layout::ConnectionSolver solver_;
  layout::LayoutProblem problem_;
  search::Annealer annealer_;
};

}  // namespace

base::Result<std::unique_ptr<DesignSession>> DesignSession::create(std::string_view sketchJson,
                                                                   std::string_view settingsJson) {
  base::Result<sketch::Sketch> sketch = sketch::readSketch(sketchJson);
  if (!sketch.ok()) {
    return sketch.error();
  }
  base::Result<Settings> settings = readSettings(settingsJson);
  if (!settings.ok()) {
    return settings.error();
  }
  std::unique_ptr<DesignSession> session =
      std::make_unique<Session>(std::move(sketch).value(), std::move(settings).value());
  return session;
}

}  // namespace liftarm::design
