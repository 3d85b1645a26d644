#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/well_built.h"

// The figures of DESIGN 5b of a model, for tests. Header only, as the other helpers.

namespace liftarm::testing {

inline std::vector<analysis::WellBuiltItem> judge(const model::Model& model) {
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  const std::vector<analysis::EdgeCover> coverage = analysis::findCoverage(scene);
  const analysis::MotionReport motion = analysis::analyseMotion(scene, coverage);
  return analysis::judgeWellBuilt({scene, coverage, motion});
}

inline analysis::WellBuiltItem itemOf(const model::Model& model, const std::string& id) {
  for (const analysis::WellBuiltItem& item : judge(model)) {
    if (item.id == id) {
      return item;
    }
  }
  ADD_FAILURE() << "no item " << id;
  return {};
}

inline double figureOf(const analysis::WellBuiltItem& item, const std::string& name) {
  for (const analysis::Figure& figure : item.figures) {
    if (figure.name == name) {
      return figure.value;
    }
  }
  ADD_FAILURE() << item.id << " has no figure " << name;
  return -1;
}

inline double figure(const model::Model& model, const std::string& id, const std::string& name) {
  return figureOf(itemOf(model, id), name);
}

inline bool lights(const analysis::WellBuiltItem& item, const std::string& kind, int part) {
  return std::any_of(item.places.begin(), item.places.end(), [&](const analysis::Problem& place) {
    return place.kind == kind && std::count(place.parts.begin(), place.parts.end(), part) > 0;
  });
}

}  // namespace liftarm::testing
