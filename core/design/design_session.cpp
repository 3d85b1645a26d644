#include "design/design_session.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include <nlohmann/json.hpp>

#include "design/attempt.h"
#include "design/earlier_json.h"
#include "design/joint_refusal.h"
#include "design/measures.h"
#include "design/model_builder.h"
#include "design/paint.h"
#include "design/report.h"
#include "design/settings.h"
#include "layout/axle.h"
#include "layout/stack.h"
#include "model/model_json.h"
#include "sketch/keep_json.h"
#include "sketch/sketch_json.h"
#include "sketch/sketch_notes.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

class Session final : public DesignSession {
 public:
  Session(sketch::Reading reading, sketch::SketchColours colours, Settings settings)
      : notes_(sketch::notesOn(reading)),
        sketch_(std::move(reading.sketch)),
        colours_(std::move(colours)),
        settings_(std::move(settings)),
        attempts_(sketch_, settings_),
        table_(attempts_.table()) {}

  bool advance(std::uint32_t iterations) override { return attempts_.advance(iterations); }

  [[nodiscard]] std::string progressJson() const override {
    const layout::Tallies& t = attempts_.search().best().tallies;
    return json{{"done", attempts_.done()},
                {"phase", attempts_.search().phase()},
                {"iterations", attempts_.iterations()},
                {"fraction", attempts_.fraction()},
                {"objective", attempts_.search().best().energy},
                {"temperature", attempts_.search().temperature()},
                {"beams", t.beams},
                {"gaps", t.gaps},
                {"collisions", t.collisions},
                {"failedConnections", t.failedConnections},
                {"improvements", attempts_.improvements()},
                {"terms", termsJson()}}
        .dump();
  }

  [[nodiscard]] std::string modelJson() const override { return model::writeModel(model()); }

  [[nodiscard]] std::string layoutJson() const override {
    return earlierJson(search::earlierLayout(attempts_.problem().graph,
                                             attempts_.problem().sites,
                                             attempts_.search().best().covers))
        .dump();
  }

  [[nodiscard]] std::string reportJson() const override {
    return makeReport({attempts_.problem(),
                       settings_,
                       table_,
                       attempts_.search(),
                       sketch_,
                       notes_,
                       attempts_.crowded(),
                       attempts_.blamed(),
                       model::asWritten(model())});
  }

  //! \return Why no search is worth its time; nothing where one is.
  [[nodiscard]] std::optional<std::string> refusal() const {
    int longest = 0;
    for (const int axle : settings_.annealing.axles) {
      longest = std::max(longest, layout::axleParts()[static_cast<std::size_t>(axle)].length);
    }
    const bool laysAxles = settings_.method != kPaperMethod && settings_.annealing.parts.axles;
    return findJointRefusal(sketch_, attempts_.problem().graph, laysAxles ? longest : 0);
  }

 private:
  [[nodiscard]] model::Model model() const {
    const std::string sketchText = sketch::writeSketch(sketch_, colours_, settings_.keeps);
    if (attempts_.search().best().covers.empty()) {
      return {sketch_.name, {}, sketchText};  // asked before the first step
    }
    model::Model built = buildModel(
        attempts_.problem(), table_, attempts_.search().best(), sketch_.name, sketchText);
    paint(colours_, built);
    return built;
  }

  //! What each weighted term of the objective adds for the best layout: measured when there is a
  //! new one, since a page asks often.
  [[nodiscard]] const json& termsJson() const {
    if (!terms_ || termsAt_ != attempts_.improvements()) {
      termsAt_ = attempts_.improvements();
      terms_ = measureTerms();
    }
    return *terms_;
  }

  [[nodiscard]] json measureTerms() const {
    const objective::Measures measures =
        measuresOf(attempts_.problem(), table_, attempts_.search().best());
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

  std::vector<sketch::Note> notes_;
  sketch::Sketch sketch_;
  sketch::SketchColours colours_;
  Settings settings_;
  Attempts attempts_;
  const mechanisms::MechanismTable& table_;
  mutable std::optional<json> terms_;  // of the best layout ...
  mutable std::uint32_t termsAt_ = 0;  // ... after so many improvements
};

}  // namespace

base::Result<std::unique_ptr<DesignSession>> DesignSession::create(std::string_view sketchJson,
                                                                   std::string_view settingsJson) {
  base::Result<sketch::Reading> sketch = sketch::readDrawing(sketchJson);
  if (!sketch.ok()) {
    return sketch.error();
  }
  base::Result<Settings> settings = readSettings(settingsJson);
  if (!settings.ok()) {
    return settings.error();
  }
  Settings wanted = std::move(settings).value();
  wanted.keeps = sketch::keepsOf(sketchJson, sketch.value().sketch);
  if (isPaperFamily(wanted.method) && !wanted.keeps.empty()) {
    return base::Error{base::Status::kInvalidInput,
                       "keep: method " + wanted.method +
                           " knows no parts that are to stay; use the default method"};
  }
  auto session = std::make_unique<Session>(
      std::move(sketch).value(), sketch::coloursOf(sketchJson), std::move(wanted));
  if (std::optional<std::string> refusal = session->refusal()) {
    return base::Error{base::Status::kInvalidInput, *std::move(refusal)};
  }
  return std::unique_ptr<DesignSession>(std::move(session));
}

}  // namespace liftarm::design
