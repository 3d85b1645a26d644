// The table of what JavaScript may call (hand-written twin: web/src/solver/solver-module.ts). Text
// in, text out, no logic; strings cross as copies, so memory growth cannot invalidate them.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <emscripten/bind.h>

#include "base/status.h"
#include "design/design_session.h"
#include "design/part_places.h"
#include "design/placements.h"
#include "design/symmetries.h"
#include "wasm/contract.h"

namespace {

using liftarm::base::Result;
using liftarm::base::Status;
using liftarm::design::DesignSession;

//! \brief A text with status "ok", or the message that says why there is none.
struct SolverReply {
  std::string status;
  std::string text;
};

//! \brief A session or the message that says why there is none: a value, because a C++ exception
//! would reach JavaScript without its text.
class SolverSession {
 public:
  SolverSession(const std::string& sketchJson, const std::string& settingsJson) {
    auto created = DesignSession::create(sketchJson, settingsJson);
    if (created.ok()) {
      session_ = std::move(created).value();
    } else {
      reply_ = {liftarm::wasm::statusName(created.error().status), created.error().message};
    }
  }

  //! \return Status "ok" and no text, or why the input is refused; then nothing else may be called.
  [[nodiscard]] SolverReply opened() const { return reply_; }

  bool advance(std::uint32_t iterations) { return session_->advance(iterations); }

  [[nodiscard]] std::string progressJson() const { return session_->progressJson(); }

  [[nodiscard]] std::string modelJson() const { return session_->modelJson(); }

  [[nodiscard]] std::string layoutJson() const { return session_->layoutJson(); }

  [[nodiscard]] std::string reportJson() const { return session_->reportJson(); }

 private:
  std::unique_ptr<DesignSession> session_;
  SolverReply reply_{liftarm::wasm::statusName(Status::kOk), ""};
};

SolverReply toReply(const Result<std::string>& result) {
  if (result.ok()) {
    return {liftarm::wasm::statusName(Status::kOk), result.value()};
  }
  return {liftarm::wasm::statusName(result.error().status), result.error().message};
}

SolverReply checkModelJson(const std::string& modelJson) {
  return toReply(liftarm::design::checkModelJson(modelJson));
}

SolverReply planAssemblyJson(const std::string& modelJson) {
  return toReply(liftarm::design::planAssemblyJson(modelJson));
}

SolverReply analyseStressJson(const std::string& modelJson, const std::string& optionsJson) {
  return toReply(liftarm::design::analyseStressJson(modelJson, optionsJson));
}

SolverReply analyseMotionJson(const std::string& modelJson) {
  return toReply(liftarm::design::analyseMotionJson(modelJson));
}

SolverReply jointMotionJson(const std::string& modelJson, int joint) {
  return toReply(liftarm::design::jointMotionJson(modelJson, joint));
}

SolverReply freeMotionJson(const std::string& modelJson, int motion) {
  return toReply(liftarm::design::freeMotionJson(modelJson, motion));
}

SolverReply findSymmetriesJson(const std::string& sketchJson) {
  return toReply(liftarm::design::findSymmetriesJson(sketchJson));
}

SolverReply placementsJson(const std::string& sketchJson, const std::string& settingsJson) {
  return toReply(liftarm::design::placementsJson(sketchJson, settingsJson));
}

SolverReply partPlacesJson(const std::string& modelJson,
                           const std::string& layoutJson,
                           const std::string& settingsJson) {
  return toReply(liftarm::design::partPlacesJson(modelJson, layoutJson, settingsJson));
}

SolverReply fittingPartsJson(const std::string& modelJson,
                             const std::string& layoutJson,
                             const std::string& settingsJson,
                             int part) {
  return toReply(liftarm::design::fittingPartsJson(modelJson, layoutJson, settingsJson, part));
}

SolverReply exportModel(const std::string& modelJson, const std::string& format) {
  return toReply(liftarm::design::exportModel(modelJson, format));
}

}  // namespace

EMSCRIPTEN_BINDINGS(liftarm) {
  emscripten::value_object<SolverReply>("SolverReply")
      .field("status", &SolverReply::status)
      .field("text", &SolverReply::text);
  emscripten::class_<SolverSession>("SolverSession")
      .constructor<const std::string&, const std::string&>()
      .function("opened", &SolverSession::opened)
      .function("advance", &SolverSession::advance)
      .function("progressJson", &SolverSession::progressJson)
      .function("modelJson", &SolverSession::modelJson)
      .function("layoutJson", &SolverSession::layoutJson)
      .function("reportJson", &SolverSession::reportJson);
  emscripten::function("checkModelJson", &checkModelJson);
  emscripten::function("planAssemblyJson", &planAssemblyJson);
  emscripten::function("analyseStressJson", &analyseStressJson);
  emscripten::function("analyseMotionJson", &analyseMotionJson);
  emscripten::function("jointMotionJson", &jointMotionJson);
  emscripten::function("freeMotionJson", &freeMotionJson);
  emscripten::function("findSymmetriesJson", &findSymmetriesJson);
  emscripten::function("placementsJson", &placementsJson);
  emscripten::function("partPlacesJson", &partPlacesJson);
  emscripten::function("fittingPartsJson", &fittingPartsJson);
  emscripten::function("exportModel", &exportModel);
  emscripten::function("contractJson", &liftarm::wasm::contractJson);
}
