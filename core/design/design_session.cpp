#include "design/design_session.h"

#include <algorithm>
#include <iterator>
#include <numeric>
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
#include "design/shaft_parts.h"
#include "gears/shaft_plan.h"
#include "layout/axle.h"
#include "layout/stack.h"
#include "model/model_json.h"
#include "sketch/keep_json.h"
#include "sketch/shaft_json.h"
#include "sketch/sketch_json.h"
#include "sketch/sketch_notes.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

//! What a search is made from.
struct Order {
  sketch::Reading reading;
  sketch::SketchColours colours;
  sketch::Shafts shafts;
  gears::ShaftPlan plan;  //!< of the shafts: its sketch is what is searched
  Settings settings;
};

class Session final : public DesignSession {
 public:
  explicit Session(Order order)
      : notes_(sketch::notesOn(order.reading)),
        order_(std::move(order)),
        attempts_(order_.plan.sketch, order_.settings),
        table_(attempts_.table()) {}

  bool advance(std::uint32_t iterations) override { return attempts_.advance(iterations); }

  [[nodiscard]] std::string progressJson() const override {
    const layout::Tallies& t = attempts_.search().best().tallies;
    // Searches with other prices are judged by the prices of the person, as the others are.
    const json& terms = termsJson();
    const double objective =
        std::accumulate(terms.begin(), terms.end(), 0.0, [](double sum, const json& term) {
          return sum + term.get<double>();
        });
    return json{{"done", attempts_.done()},
                {"phase", attempts_.search().phase()},
                {"iterations", attempts_.iterations()},
                {"fraction", attempts_.fraction()},
                {"objective", objective},
                {"temperature", attempts_.search().temperature()},
                {"beams", t.beams},
                {"gaps", t.gaps},
                {"collisions", t.collisions},
                {"failedConnections", t.failedConnections},
                {"improvements", attempts_.improvements()},
                {"terms", terms}}
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
                       order_.settings,
                       table_,
                       attempts_.search(),
                       sketch(),
                       notes_,
                       attempts_.crowded(),
                       attempts_.blamed(),
                       model::asWritten(model())});
  }

  //! \return Why no search is worth its time; nothing where one is.
  [[nodiscard]] std::optional<std::string> refusal() const {
    int longest = 0;
    for (const int axle : order_.settings.annealing.axles) {
      longest = std::max(longest, layout::axleParts()[static_cast<std::size_t>(axle)].length);
    }
    const bool laysAxles =
        order_.settings.method != kPaperMethod && order_.settings.annealing.parts.axles;
    return findJointRefusal(sketch(), attempts_.problem().graph, laysAxles ? longest : 0);
  }

 private:
  //! As it was drawn.
  [[nodiscard]] const sketch::Sketch& sketch() const { return order_.reading.sketch; }

  [[nodiscard]] model::Model model() const {
    const std::string sketchText =
        sketch::writeSketch(sketch(), order_.colours, order_.settings.keeps, order_.shafts);
    if (attempts_.search().best().covers.empty()) {
      return {sketch().name, {}, sketchText};  // asked before the first step
    }
    model::Model built = buildModel(
        attempts_.problem(), table_, attempts_.search().best(), sketch().name, sketchText);
    for (model::PlacedPart& part : shaftParts(order_.plan)) {
      built.parts.push_back(std::move(part));
    }
    paint(order_.colours, built);
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
    const objective::Weights& weights = order_.settings.annealing.weights;
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
  Order order_;
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
  sketch::Shafts shafts = sketch::shaftsOf(sketchJson);
  if (isPaperFamily(wanted.method) && !shafts.empty()) {
    return base::Error{
        base::Status::kInvalidInput,
        "shafts: method " + wanted.method + " knows no shafts; use the default method"};
  }
  base::Result<gears::ShaftPlan> plan = gears::planShafts(sketch.value().sketch, shafts);
  if (!plan.ok()) {
    return plan.error();
  }
  auto session = std::make_unique<Session>(Order{std::move(sketch).value(),
                                                 sketch::coloursOf(sketchJson),
                                                 std::move(shafts),
                                                 std::move(plan).value(),
                                                 std::move(wanted)});
  if (std::optional<std::string> refusal = session->refusal()) {
    return base::Error{base::Status::kInvalidInput, *std::move(refusal)};
  }
  return std::unique_ptr<DesignSession>(std::move(session));
}

}  // namespace liftarm::design
