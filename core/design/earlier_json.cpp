#include "design/earlier_json.h"

#include <algorithm>

#include "design/json_values.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

constexpr std::size_t kMostRuns = 100000;
constexpr std::size_t kMostItems = 10000;  // beams or junctions of one run
constexpr int kLargest = 1000000;
constexpr std::size_t kBeamNumbers = 6;

bool isWhole(const json& value) {
  return value.is_number_integer() && value <= kLargest && value >= -kLargest;
}

bool isListOf(const json& value, std::size_t most, bool (*item)(const json&)) {
  return value.is_array() && value.size() <= most && std::all_of(value.begin(), value.end(), item);
}

bool isPoint(const json& value) {
  return value.size() == 3 && isListOf(value, 3, [](const json& x) { return x.is_number(); });
}

bool isBeam(const json& value) {
  return value.size() == kBeamNumbers && isListOf(value, kBeamNumbers, isWhole);
}

bool isRun(const json& value) {
  const auto has = [&](const char* key, bool (*is)(const json&)) {
    const auto found = value.find(key);
    return found != value.end() && is(*found);
  };
  return value.is_object() && has("from", isPoint) && has("to", isPoint) &&
         has("axis", [](const json& axis) { return isWhole(axis) && axis >= 0 && axis <= 2; }) &&
         has("beams", [](const json& list) { return isListOf(list, kMostItems, isBeam); }) &&
         has("meets", [](const json& list) { return isListOf(list, kMostItems, isWhole); });
}

lattice::Vec3 pointOf(const json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

search::EarlierRun runOf(const json& value) {
  search::EarlierRun run;
  run.from = pointOf(value["from"]);
  run.to = pointOf(value["to"]);
  run.cover.axis = lattice::axisFromIndex(value["axis"].get<int>());
  for (const json& beam : value["beams"]) {
    run.cover.beams.push_back({beam[0].get<int>(),
                               beam[1].get<int>(),
                               beam[2].get<int>(),
                               beam[3].get<int>(),
                               beam[4].get<int>(),
                               beam[5].get<int>()});
  }
  run.meets = value["meets"].get<std::vector<int>>();
  return run;
}

}  // namespace

json earlierJson(const search::EarlierLayout& earlier) {
  json runs = json::array();
  for (const search::EarlierRun& run : earlier) {
    json beams = json::array();
    for (const layout::Beam& beam : run.cover.beams) {
      beams.push_back({beam.start, beam.holes, beam.layer, beam.mate, beam.form, beam.tail});
    }
    runs.push_back({{"from", pointJson(run.from)},
                    {"to", pointJson(run.to)},
                    {"axis", lattice::index(run.cover.axis)},
                    {"beams", beams},
                    {"meets", run.meets}});
  }
  return json{{"runs", runs}};
}

base::Result<search::EarlierLayout> readEarlier(const json& value) {
  const auto runs = value.is_object() ? value.find("runs") : value.end();
  if (!value.is_object() || runs == value.end() || !isListOf(*runs, kMostRuns, isRun)) {
    return base::Error{base::Status::kInvalidInput,
                       "earlier: the layout of an earlier search is needed"};
  }
  search::EarlierLayout earlier;
  for (const json& run : *runs) {
    earlier.push_back(runOf(run));
  }
  return earlier;
}

}  // namespace liftarm::design
