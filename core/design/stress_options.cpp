#include "design/stress_options.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "model/model_json.h"

namespace liftarm::design {

namespace {

using analysis::FitHold;
using nlohmann::json;

constexpr std::size_t kMaxLoads = 1000;
constexpr double kMaxForce = 1e5;      // N
constexpr double kMaxStiffness = 1e6;  // N mm / rad

base::Result<lattice::Vec3> readVector(const json& object,
                                       const std::string& place,
                                       const char* key,
                                       double limit) {
  const std::string at = place + "." + key;
  if (!object.is_object() || !object.contains(key)) {
    return base::invalidInput(at + ": missing; expected three numbers");
  }
  const json& value = object.at(key);
  if (!value.is_array() || value.size() != 3) {
    return base::invalidInput(at + ": expected three numbers");
  }
  lattice::Vec3 result;
  for (int i = 0; i < 3; ++i) {
    const json& element = value[static_cast<std::size_t>(i)];
    if (!element.is_number() || !(std::abs(element.get<double>()) <= limit)) {
      return base::invalidInput(at + ": expected three numbers of at most " +
                                std::to_string(static_cast<int>(limit)) + " in magnitude");
    }
    result[i] = element.get<double>();
  }
  return result;
}

base::Result<FitHold> readFriction(const json& value) {
  const std::string name = value.is_string() ? value.get<std::string>() : "";
  if (name == "held") {
    return FitHold::kHeld;
  }
  if (name == "free") {
    return FitHold::kFree;
  }
  if (name == "locked") {
    return FitHold::kLocked;
  }
  return base::invalidInput("friction: expected \"held\", \"free\" or \"locked\"");
}

base::Result<std::vector<analysis::PointLoad>> readLoads(const json& value) {
  if (!value.is_array() || value.size() > kMaxLoads) {
    return base::invalidInput("loads: expected an array of at most " + std::to_string(kMaxLoads) +
                              " loads");
  }
  std::vector<analysis::PointLoad> loads;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string place = "loads[" + std::to_string(i) + "]";
    const base::Result<lattice::Vec3> at = readVector(value[i], place, "at", model::kMaxPosition);
    if (!at.ok()) {
      return at.error();
    }
    const base::Result<lattice::Vec3> force = readVector(value[i], place, "force", kMaxForce);
    if (!force.ok()) {
      return force.error();
    }
    loads.push_back({at.value(), force.value()});
  }
  return loads;
}

}  // namespace

base::Result<analysis::StressOptions> readStressOptions(std::string_view text) {
  analysis::StressOptions options;
  if (text.empty()) {
    return options;
  }
  const json document = json::parse(text, nullptr, false);
  if (!document.is_object()) {
    return base::invalidInput("options: expected an object in braces");
  }
  if (document.contains("friction")) {
    const base::Result<FitHold> friction = readFriction(document.at("friction"));
    if (!friction.ok()) {
      return friction.error();
    }
    options.friction = friction.value();
  }
  if (document.contains("heldStiffness")) {
    const json& value = document.at("heldStiffness");
    if (!value.is_number() || !(value.get<double>() > 0.0) || value.get<double>() > kMaxStiffness) {
      return base::invalidInput("heldStiffness: expected a number above 0, at most 1000000");
    }
    options.heldStiffness = value.get<double>();
  }
  if (document.contains("loads")) {
    base::Result<std::vector<analysis::PointLoad>> loads = readLoads(document.at("loads"));
    if (!loads.ok()) {
      return loads.error();
    }
    options.loads = std::move(loads).value();
  }
  return options;
}

}  // namespace liftarm::design
