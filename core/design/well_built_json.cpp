#include "design/well_built_json.h"

#include "design/json_values.h"

namespace liftarm::design {

namespace {

using nlohmann::ordered_json;

ordered_json placesJson(const std::vector<analysis::Problem>& places) {
  ordered_json result = ordered_json::array();
  for (const analysis::Problem& place : places) {
    ordered_json entry{{"kind", place.kind}, {"message", place.message}};
    if (place.at.has_value()) {
      entry["at"] = pointJson(*place.at);
    }
    entry["parts"] = place.parts;
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace

ordered_json wellBuiltJson(const std::vector<analysis::WellBuiltItem>& items) {
  int passed = 0;
  ordered_json rows = ordered_json::array();
  for (const analysis::WellBuiltItem& item : items) {
    passed += item.ok ? 1 : 0;
    ordered_json figures = ordered_json::object();
    for (const analysis::Figure& figure : item.figures) {
      figures[figure.name] = rounded(figure.value);
    }
    rows.push_back({{"id", item.id},
                    {"title", item.title},
                    {"ok", item.ok},
                    {"applies", item.applies},
                    {"detail", item.detail},
                    {"figures", figures},
                    {"places", placesJson(item.places)}});
  }
  return {{"passed", passed}, {"of", items.size()}, {"items", rows}};
}

}  // namespace liftarm::design
