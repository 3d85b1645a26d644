//! libFuzzer target: any bytes either give a model that is judged, exported and read back with as
//! many parts, or a refusal with a message. Each find becomes a test of tests/core/model.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "design/design_session.h"
#include "model/model_json.h"

namespace {

constexpr std::size_t kFewParts = 40;  // more take long to judge, and add no new paths

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace liftarm;  // NOLINT(google-build-using-namespace): a program of one page
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const base::Result<model::Model> read = model::readModel(text);
  if (!read.ok()) {
    LIFTARM_CHECK(!read.error().message.empty(), "a refusal says why");
    return 0;
  }
  if (read.value().parts.size() > kFewParts) {
    return 0;
  }
  const base::Result<model::Model> again = model::readModel(model::writeModel(read.value()));
  LIFTARM_CHECK(again.ok(), "what we write can be read");
  LIFTARM_CHECK(again.value().parts.size() == read.value().parts.size(), "no part is lost");
  (void)design::checkModelJson(text);
  (void)design::exportModel(text, "mpd");
  return 0;
}
