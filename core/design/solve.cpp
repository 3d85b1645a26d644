#include "design/solve.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "design/design_session.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

constexpr std::uint32_t kSlice = 100'000;

std::string settingsText(const SolveOptions& options) {
  return json{{"seed", options.seed},
              {"preset", options.preset},
              {"method", options.method},
              {"set", options.set}}
      .dump();
}

}  // namespace

base::Result<Design> solve(const sketch::Sketch& sketch, const SolveOptions& options) {
  const std::string text = sketch::writeSketch(sketch);
  base::Result<std::unique_ptr<DesignSession>> created =
      DesignSession::create(text, settingsText(options));
  if (!created.ok()) {
    return created.error();
  }
  const std::unique_ptr<DesignSession> session = std::move(created).value();
  while (!session->advance(kSlice)) {
  }
  base::Result<model::Model> built = model::readModel(session->modelJson());
  if (!built.ok()) {
    return built.error();
  }
  Design design;
  design.model = std::move(built).value();
  design.check = analysis::checkModel(design.model, parts::Catalogue::builtIn());
  design.notes = sketch::notesOn(sketch::readDrawing(text).value());
  design.report = session->reportJson();
  design.buildable = json::parse(design.report).value("buildable", false);
  return design;
}

}  // namespace liftarm::design
