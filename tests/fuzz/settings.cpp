//! libFuzzer target: any bytes either give settings that can be told again, or a refusal with one
//! line that says why. Each find becomes a row of tests/core/design/settings_test.cpp.
#include "design/settings.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using liftarm::design::Settings;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const liftarm::base::Result<Settings> settings = liftarm::design::readSettings(text);
  if (settings.ok()) {
    LIFTARM_CHECK(!liftarm::design::settingsJson(settings.value()).empty(), "settings can be told");
  } else {
    LIFTARM_CHECK(!settings.error().message.empty(), "a refusal says why");
  }
  return 0;
}
