#pragma once

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "design/design_session.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

// Header only: tests from design on use it, and only those link the search.

namespace liftarm::testing {

//! \brief What a search ended with.
struct Solved {
  nlohmann::json report;
  model::Model model;
  std::string text;  //!< the model's file

  [[nodiscard]] int count(const std::string& part) const {
    return static_cast<int>(std::count_if(
        model.parts.begin(), model.parts.end(), [&](const auto& p) { return p.part == part; }));
  }
};

//! \brief With the preset that lays the fewest parts. \param set As in design::readSettings.
inline Solved solve(const sketch::Sketch& sketch,
                    const nlohmann::json& set = nlohmann::json::object(),
                    int seed = 1) {
  const nlohmann::json settings{{"seed", seed}, {"preset", "simple"}, {"set", set}};
  auto session = design::DesignSession::create(sketch::writeSketch(sketch), settings.dump());
  if (!session.ok()) {
    ADD_FAILURE() << session.error().message;
    return {};
  }
  while (!session.value()->advance(1000)) {
  }
  std::string text = session.value()->modelJson();
  return {nlohmann::json::parse(session.value()->reportJson()),
          model::readModel(text).value(),
          std::move(text)};
}

//! \brief The model text that the search makes of one of our own examples.
inline std::string solvedExampleText(const std::string& name) {
  std::ifstream file(std::string(LIFTARM_SOURCE_DIR) + "/public/examples/" + name + ".sketch.json");
  const std::string sketch{std::istreambuf_iterator<char>(file), {}};
  auto session = design::DesignSession::create(sketch, "{}");
  if (!session.ok()) {
    ADD_FAILURE() << name << ": " << session.error().message;
    return "";
  }
  while (!session.value()->advance(20000)) {
  }
  return session.value()->modelJson();
}

inline model::Model solvedExample(const std::string& name) {
  const base::Result<model::Model> model = model::readModel(solvedExampleText(name));
  if (!model.ok()) {
    ADD_FAILURE() << name << ": " << model.error().message;
    return {};
  }
  return model.value();
}

//! \brief Where the part stands that is nearest to the middle of all, seen from above: a load there
//! hardly tips anything.
inline lattice::Vec3 middlePart(const model::Model& model) {
  lattice::Vec3 sum;
  for (const model::PlacedPart& part : model.parts) {
    sum = sum + part.pose.position;
  }
  const lattice::Vec3 mean = (1.0 / static_cast<double>(model.parts.size())) * sum;
  const auto distance = [&](const model::PlacedPart& part) {
    lattice::Vec3 apart = part.pose.position - mean;
    apart.z = 0.0;
    return lattice::length(apart);
  };
  return std::min_element(model.parts.begin(),
                          model.parts.end(),
                          [&](const auto& a, const auto& b) { return distance(a) < distance(b); })
      ->pose.position;
}

}  // namespace liftarm::testing
