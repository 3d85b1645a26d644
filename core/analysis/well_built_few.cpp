#include <cstddef>
#include <set>
#include <string>

#include "analysis/well_built_items.h"

namespace liftarm::analysis {

namespace {

using parts::PartClass;

//! Per part, the parts that it fits to.
std::vector<std::set<int>> neighboursOf(const Scene& scene) {
  std::vector<std::set<int>> neighbours(scene.parts.size());
  for (const model::Connection& c : scene.connections) {
    if (model::isGood(c.fit)) {
      neighbours[static_cast<std::size_t>(c.male)].insert(c.female);
      neighbours[static_cast<std::size_t>(c.female)].insert(c.male);
    }
  }
  return neighbours;
}

std::set<int> coveringParts(const std::vector<EdgeCover>& coverage) {
  std::set<int> parts;
  for (const EdgeCover& edge : coverage) {
    for (const Cover& cover : edge.covers) {
      parts.insert(cover.part);
    }
  }
  return parts;
}

//! Bushes stop an axle, spacers fill a layer: one neighbour is enough for both.
bool endsSomething(const parts::Part& part) {
  return part.partClass == PartClass::kBush || part.partClass == PartClass::kGear ||
         (part.partClass == PartClass::kBeam && part.features.size() == 1);
}

}  // namespace

WellBuiltItem judgeFewness(const WellBuiltQuery& query) {
  const Scene& scene = query.scene;
  WellBuiltItem item;
  item.id = "few";
  item.title = "Few parts, all of use";
  const std::vector<std::set<int>> neighbours = neighboursOf(scene);
  const std::set<int> covering = coveringParts(query.coverage);
  std::set<std::string> kinds;
  int idle = 0;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    kinds.insert(scene.model->parts[i].part);
    const parts::Part* part = scene.parts[i].part;
    const int index = static_cast<int>(i);
    const std::size_t enough = part != nullptr && endsSomething(*part) ? 1 : 2;
    const bool alone = scene.parts.size() == 1 && !scene.sketch.has_value();
    if (part != nullptr && neighbours[i].size() < enough && covering.count(index) == 0 && !alone) {
      ++idle;
      const lattice::Vec3 at = scene.model->parts[i].pose.position;
      item.places.push_back(
          {"idle", nameOf(scene, index) + " at " + pointText(at) + " joins nothing", at, {index}});
    }
  }
  const int count = static_cast<int>(scene.parts.size());
  item.ok = idle == 0;
  item.detail = std::to_string(count) + " parts of " + std::to_string(kinds.size()) + " kinds, " +
                std::to_string(idle) + " without a use";
  item.figures = {
      {"parts", count}, {"kinds", static_cast<double>(kinds.size())}, {"idleParts", idle}};
  return item;
}

}  // namespace liftarm::analysis
