#include "cli/stress_text.h"

#include <array>
#include <cstdio>

#include "base/plain_text.h"
#include "design/design_session.h"

namespace liftarm::cli {

namespace {

using nlohmann::ordered_json;

ordered_json analysed(const std::string& modelJson, const std::string& friction) {
  const base::Result<std::string> answer =
      design::analyseStressJson(modelJson, R"({"friction":")" + friction + R"("})");
  if (!answer.ok()) {
    return {{"ok", false}, {"message", answer.error().message}};
  }
  ordered_json summary = ordered_json::parse(answer.value(), nullptr, false);
  for (const char* key : {"parts", "samples", "pins", "reactions"}) {
    summary.erase(key);
  }
  summary["friction"] = friction;
  return summary;
}

std::string number(const ordered_json& summary, const char* key) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", summary.value(key, 0.0));
  return text.data();
}

}  // namespace

ordered_json stressSummary(const std::string& modelJson) {
  const ordered_json held = analysed(modelJson, "held");
  if (held.value("ok", false) || !held.contains("moving")) {
    return held;
  }
  ordered_json locked = analysed(modelJson, "locked");
  if (locked.value("ok", false)) {
    locked["message"] =
        "with all fits locked, since with friction alone: " + held.value("message", "");
  }
  return locked;
}

std::string stressText(const ordered_json& summary) {
  const std::string message = base::plainText(summary.value("message", ""));
  if (!summary.value("ok", false)) {
    return "  stress: not known; " + message + "\n";
  }
  return "  stress: at most " + number(summary, "maxStress") + " MPa, safety factor " +
         number(summary, "safety") + ", moves " + number(summary, "maxDisplacement") +
         " mm under its weight of " + number(summary, "weight") + " N" +
         (message.empty() ? "" : "; " + message) + "\n";
}

}  // namespace liftarm::cli
