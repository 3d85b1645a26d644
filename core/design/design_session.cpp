#include "design/design_session.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include <nlohmann/json.hpp>

#include "design/earlier_json.h"
#include "design/looseness.h"
#include "design/measures.h"
#include "design/model_builder.h"
#include "design/report.h"
#include "design/settings.h"
#include "guide/beam_bound.h"
#include "layout/stack.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

mechanisms::MechanismTable makeTable(const Settings& settings) {
  mechanisms::CompositionOptions options;
  std::copy_if(settings.connectors.begin(),
               settings.connectors.end(),
               std::back_inserter(options.partIds),
               [](const std::string& id) { return id != layout::kSpacerPart; });
  options.maxParts = settings.mechanismParts;
  return mechanisms::MechanismTable(
      mechanisms::composeMechanisms(parts::Catalogue::builtIn(), options));
}

//! The paper's method knows no spacers.
bool fillsGaps(const Settings& settings) {
  return settings.method != kPaperMethod &&
         std::find(settings.connectors.begin(), settings.connectors.end(), layout::kSpacerPart) !=
             settings.connectors.end();
}

//! The search that the settings name.
std::unique_ptr<search::LayoutSearch> makeSearch(const layout::LayoutProblem& problem,
                                                 layout::ConnectionSolver& solver,
                                                 const Settings& settings,
                                                 const sketch::Sketch& sketch) {
  if (settings.method == kPaperMethod) {
    search::PaperOptions options = settings.paper;
    options.seed = settings.annealing.seed;
    options.corners = settings.annealing.parts.corners;
    options.lengths = settings.annealing.lengths;
    options.weights = settings.annealing.weights;
    return std::make_unique<search::PaperSearch>(problem, solver, std::move(options));
  }
  search::AnnealingOptions options = settings.annealing;
  options.held = makeHeld(problem, solver.table());
  if (objective::isRigid(settings.preset)) {
    options.freedoms = makeLooseness(problem, solver.table(), sketch);
  }
  options.buildable = makeBuildable(problem, solver.table(), sketch);
  return std::make_unique<search::Annealer>(problem, solver, std::move(options));
}

class Session final : public DesignSession {
 public:
  Session(sketch::Sketch sketch, Settings settings)
      : sketch_(std::move(sketch)),
        settings_(std::move(settings)),
        table_(makeTable(settings_)),
        solver_(table_),
        problem_(
            layout::makeLayoutProblem(guide::buildGuidingGraph(sketch_), fillsGaps(settings_))),
        search_(makeSearch(problem_, solver_, settings_, sketch_)) {}

  bool advance(std::uint32_t iterations) override { return search_->advance(iterations); }

  [[nodiscard]] std::string progressJson() const override {
    const layout::Tallies& t = search_->best().tallies;
    return json{{"done", search_->done()},
                {"phase", search_->phase()},
                {"iterations", search_->iterations()},
                {"fraction", search_->fraction()},
                {"objective", search_->best().energy},
                {"temperature", search_->temperature()},
                {"beams", t.beams},
                {"gaps", t.gaps},
                {"collisions", t.collisions},
                {"failedConnections", t.failedConnections},
                {"improvements", search_->improvements()},
                {"terms", termsJson()}}
        .dump();
  }

  [[nodiscard]] std::string modelJson() const override { return model::writeModel(model()); }

  [[nodiscard]] std::string layoutJson() const override {
    return earlierJson(
               search::earlierLayout(problem_.graph, problem_.sites, search_->best().covers))
        .dump();
  }

  [[nodiscard]] std::string reportJson() const override {
    return makeReport({problem_, settings_, table_, *search_, sketch_, model::asWritten(model())});
  }

 private:
  [[nodiscard]] model::Model model() const {
    const std::string sketchText = sketch::writeSketch(sketch_);
    if (search_->best().covers.empty()) {
      return {sketch_.name, {}, sketchText};  // asked before the first step
    }
    return buildModel(problem_, table_, search_->best(), sketch_.name, sketchText);
  }

  //! What each weighted term of the objective adds for the best layout: measured when there is a
  //! new one, since a page asks often.
  [[nodiscard]] const json& termsJson() const {
    if (!terms_ || termsAt_ != search_->improvements()) {
      termsAt_ = search_->improvements();
      terms_ = measureTerms();
    }
    return *terms_;
  }

  [[nodiscard]] json measureTerms() const {
    const objective::Measures measures = measuresOf(problem_, table_, search_->best());
    const objective::Weights& weights = settings_.annealing.weights;
    json terms = json::object();
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] != 0.0) {
        terms[std::string(objective::kTerms[i].name)] =
            weights[i] * objective::kTerms[i].value(measures);
      }
    }
    return terms;
  }

  sketch::Sketch sketch_;
  Settings settings_;
  mechanisms::MechanismTable table_;
  layout::ConnectionSolver solver_;
  layout::LayoutProblem problem_;
  std::unique_ptr<search::LayoutSearch> search_;
  mutable std::optional<json> terms_;  // of the best layout ...
  mutable std::uint32_t termsAt_ = 0;  // ... after so many improvements
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
