#include "design/owned_parts.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "design/model_builder.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "parts/catalogue.h"

namespace liftarm::design {

namespace {

using base::at;
using base::Error;
using base::Status;

constexpr double kMostOwned = 1e6;
constexpr const char* kInlinePin = "2780";

//! Those of which any are owned; limits on them go to `limits`.
template <typename Item, typename PartOf>
std::vector<Item> limited(const std::vector<Item>& items,
                          const std::map<std::string, int>& owned,
                          PartOf partOf,
                          std::vector<std::pair<Item, int>>* limits) {
  std::vector<Item> left;
  for (const Item& item : items) {
    const auto limit = owned.find(partOf(item));
    if (limit != owned.end() && limit->second == 0) {
      continue;
    }
    left.push_back(item);
    if (limit != owned.end()) {
      limits->emplace_back(item, limit->second);
    }
  }
  return left;
}

//! Axles that cover lines, by the same list as other connecting parts.
void limitAxles(Settings* settings) {
  auto& limits = settings->annealing.supply.connectors;
  std::vector<int> axles;
  for (const int axle : settings->annealing.axles) {
    const std::string& id = layout::axleParts()[at(axle)].part;
    const auto limit = settings->owned.find(id);
    if (limit != settings->owned.end() && limit->second == 0) {
      continue;
    }
    axles.push_back(axle);
    const bool known = std::any_of(
        limits.begin(), limits.end(), [&](const auto& entry) { return entry.first == id; });
    if (limit != settings->owned.end() && !known) {
      limits.emplace_back(id, limit->second);
    }
  }
  settings->annealing.axles = axles;
}

}  // namespace

base::Result<bool> applyOwned(Settings* settings, const std::string& partId, double count) {
  const std::string key = "set." + std::string(kOwnedPrefix) + partId;
  if (parts::Catalogue::builtIn().find(partId) == nullptr) {
    return base::invalidInput(key + ": no part " + partId + " in the catalogue");
  }
  if (!(count >= 0.0 && count <= kMostOwned) || count != std::floor(count)) {
    return base::invalidInput(key + ": a whole number from 0 to 1000000 is needed");
  }
  settings->owned[partId] = static_cast<int>(count);
  return true;
}

base::Result<bool> limitSearch(Settings* settings) {
  const std::map<std::string, int>& owned = settings->owned;
  if (owned.empty()) {
    return true;
  }
  search::AnnealingOptions& annealing = settings->annealing;
  std::vector<int> lengths;
  for (const int holes : annealing.lengths) {
    const auto limit = owned.find(straightBeamPart(holes).id);
    if (limit == owned.end() || limit->second >= layout::partsOfBeam(holes)) {
      lengths.push_back(holes);
      if (limit != owned.end()) {
        annealing.supply.beams.push_back({holes, limit->second});
      }
    }
  }
  if (lengths.empty()) {
    return base::invalidInput("set.owned: no straight beam is left; own at least one kind");
  }
  annealing.lengths = lengths;
  annealing.bends = limited(
      annealing.bends,
      owned,
      [](int form) { return layout::bentBeams()[at(form)].part; },
      &annealing.supply.bent);
  annealing.frames = limited(
      annealing.frames,
      owned,
      [](int form) { return layout::frameBeams()[at(form)].part; },
      &annealing.supply.frames);
  const auto pins = owned.find(kInlinePin);
  if (pins != owned.end() && pins->second == 0) {
    return base::invalidInput(
        "set.owned.2780: at least 1 is needed, since joints in line are pinned with it");
  }
  settings->connectors = limited(
      settings->connectors,
      owned,
      [](const std::string& id) { return id; },
      &annealing.supply.connectors);
  limitAxles(settings);
  return true;
}

std::string MissingPart::message() const {
  const parts::Part* known = parts::Catalogue::builtIn().find(part);
  return "the model needs " + std::to_string(needed) + " of part " + part +
         (known == nullptr ? "" : " (" + known->name + ")") + ", of which you own " +
         std::to_string(owned) + ": " + std::to_string(needed - owned) + " missing";
}

std::vector<MissingPart> missingParts(const model::Model& model, const Settings& settings) {
  std::vector<MissingPart> missing;
  for (const auto& [id, owned] : settings.owned) {
    const auto needed = static_cast<int>(
        std::count_if(model.parts.begin(), model.parts.end(), [&id = id](const auto& part) {
          return part.part == id;
        }));
    if (needed > owned) {
      missing.push_back({id, needed, owned});
    }
  }
  return missing;
}

}  // namespace liftarm::design
