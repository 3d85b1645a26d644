#include "design/settings.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "design/earlier_json.h"
#include "design/owned_parts.h"
#include "design/part_lists.h"
#include "layout/stack.h"
#include "parts/catalogue.h"
#include "rivals/rivals.h"
#include "sketch/json_text.h"

namespace liftarm::design {

namespace {

using base::Error;
using base::Status;
using nlohmann::json;

constexpr double kMaxWeight = 1e6;

//! One number that a person may set, its limits and where it goes.
struct NumberKey {
  std::string_view name;
  double low;
  double high;
  bool whole;
  void (*apply)(Settings*, double);
};

constexpr std::array<NumberKey, 13> kNumberKeys{{
    {"corners", 0.0, 1.0, true, [](Settings* s, double v) { s->corners = v != 0.0; }},
    {"effort",
     0.01,
     100.0,
     false,
     [](Settings* s, double v) {
       const double perRun = v * static_cast<double>(s->annealing.iterationsPerRun);
       const double least = v * static_cast<double>(s->annealing.minIterations);
       s->annealing.iterationsPerRun = static_cast<std::uint32_t>(perRun + 1.0);
       s->annealing.minIterations = static_cast<std::uint32_t>(least + 1.0);
       s->effort = v;
       s->annealing.mostWork *= std::max(1.0, v);
     }},
    {"starts",
     1.0,
     10000.0,
     true,
     [](Settings* s, double v) { s->annealing.starts = static_cast<int>(v); }},
    {"rounds",
     0.0,
     1000.0,
     true,
     [](Settings* s, double v) { s->annealing.maxRounds = static_cast<std::uint32_t>(v); }},
    {"startTemperature",
     1e-3,
     1e6,
     false,
     [](Settings* s, double v) { s->annealing.startTemperature = v; }},
    {"endTemperature",
     1e-4,
     1e6,
     false,
     [](Settings* s, double v) { s->annealing.endTemperature = v; }},
    {"mechanismParts",
     1.0,
     3.0,
     true,
     [](Settings* s, double v) { s->mechanismParts = static_cast<int>(v); }},
    {"connections.dangling",
     0.0,
     100.0,
     false,
     [](Settings* s, double v) { s->connection.dangling = v; }},
    {"connections.secondHead",
     0.0,
     100.0,
     false,
     [](Settings* s, double v) { s->connection.secondHead = v; }},
    {"standing", 0.0, 1.0, true, [](Settings* s, double v) { s->standing = v != 0.0; }},
    {"symmetric", 0.0, 1.0, true, [](Settings* s, double v) { s->symmetric = v != 0.0; }},
    {"paper.coolingRate",
     0.5,
     0.999999,
     false,
     [](Settings* s, double v) { s->paper.coolingRate = v; }},
    {"paper.closeGroups", 0.0, 1.0, true, [](Settings* s, double v) { s->closeGroups = v != 0.0; }},
}};

//! The key that switches a part of the search off with 0 (docs/ablations.md).
std::string keyOf(const search::SearchSwitch& part) {
  return "search." + std::string(part.name);
}

std::string numberText(double v) {
  return json(v).dump();
}

//! A number, also when it came as text from the command line; NaN when it is neither.
double numberOf(const json& value) {
  if (value.is_number()) {
    return value.get<double>();
  }
  if (value.is_string()) {
    const json parsed = json::parse(value.get<std::string>(), nullptr, false);
    if (parsed.is_number()) {
      return parsed.get<double>();
    }
  }
  return std::nan("");
}

std::string textOf(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string knownKeys() {
  std::string keys = "axles, bent, connectors, frames, lengths, owned.PARTID, paper.schedule";
  for (const NumberKey& key : kNumberKeys) {
    keys += ", " + std::string(key.name);
  }
  for (const search::SearchSwitch& part : search::kSearchSwitches) {
    keys += ", " + keyOf(part);
  }
  for (const objective::Term& term : objective::kTerms) {
    keys += ", weights." + std::string(term.name);
  }
  return keys;
}

std::vector<std::string_view> methodNames() {
  std::vector<std::string_view> names{kDefaultMethod, kPaperMethod};
  const std::vector<std::string_view> rivals = rivals::rivalNames();
  names.insert(names.end(), rivals.begin(), rivals.end());
  return names;
}

//! "a, b or c".
std::string choiceOf(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += i == 0 ? "" : (i + 1 == names.size() ? " or " : ", ");
    text += names[i];
  }
  return text;
}

base::Result<bool> applySchedule(Settings* settings, const std::string& name) {
  std::vector<std::string_view> known = rivals::scheduleNames();
  known.insert(known.begin(), "exponential");
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    return base::invalidInput("set.paper.schedule: " + name + " is unknown; use " +
                              choiceOf(known));
  }
  settings->paper.cooling = rivals::coolingOf(name);
  return true;
}

base::Result<bool> applyKey(Settings* settings, const std::string& key, const json& value) {
  if (isPartList(key)) {
    return applyPartList(settings, key, textOf(value));
  }
  if (key == "paper.schedule") {
    return applySchedule(settings, textOf(value));
  }
  const double number = numberOf(value);
  const std::string prefix = "weights.";
  if (key.rfind(prefix, 0) == 0) {
    const auto term = objective::termIndex(key.substr(prefix.size()));
    if (term && number >= 0.0 && number <= kMaxWeight) {
      settings->annealing.weights[*term] = number;
      return true;
    }
    if (term) {
      return base::invalidInput("set." + key + ": a number from 0 to 1000000 is needed, not " +
                                value.dump());
    }
  }
  if (key.rfind(kOwnedPrefix, 0) == 0) {
    return applyOwned(settings, key.substr(kOwnedPrefix.size()), number);
  }
  for (const search::SearchSwitch& known : search::kSearchSwitches) {
    if (keyOf(known) != key) {
      continue;
    }
    if (number != 0.0 && number != 1.0) {
      return base::invalidInput("set." + key + ": 0 or 1 is needed, not " + value.dump());
    }
    settings->annealing.parts.*known.part = number == 1.0;
    return true;
  }
  for (const NumberKey& known : kNumberKeys) {
    if (known.name != key) {
      continue;
    }
    if (known.whole && number != std::floor(number)) {
      return base::invalidInput("set." + key + ": a whole number is needed, not " + value.dump());
    }
    if (!(number >= known.low && number <= known.high)) {
      return base::invalidInput("set." + key + ": a number from " + numberText(known.low) + " to " +
                                numberText(known.high) + " is needed, not " + value.dump());
    }
    known.apply(settings, number);
    return true;
  }
  return base::invalidInput("set." + key + ": no such key; known are " + knownKeys());
}

//! What a preset changes beside the weights of the objective.
void applyPreset(Settings* settings) {
  settings->annealing.weights = isPaperFamily(settings->method)
                                    ? objective::paperWeights(settings->preset)
                                    : objective::searchWeights(settings->preset);
  if (settings->preset != objective::Preset::kBalanced || isPaperFamily(settings->method)) {
    return;
  }
  settings->connectors.emplace_back("15100");
  settings->connectors.emplace_back("44809");
  settings->mechanismParts = 3;
  settings->connection = {4.0, 1.2};
  settings->annealing.stiffening = {.rounds = 14,
                                    .roundsPerStart = 14,
                                    .work = 2.5e6,
                                    .share = 0.5,
                                    .weight = 2.0,
                                    .otherStarts = false,
                                    .polish = true,
                                    .frees = true};
  settings->corners = true;
  settings->standing = true;
  settings->symmetric = true;
  settings->otherPrices = true;
}

base::Result<bool> applyTop(Settings* settings, const json& root) {
  for (const auto& [key, value] : root.items()) {
    if (key == "seed") {
      const double seed = numberOf(value);
      if (!(seed >= 0.0 && seed <= 9007199254740991.0) || seed != std::floor(seed)) {
        return base::invalidInput(
            "seed: a whole number from 0 to 9007199254740991 is needed, not " + value.dump());
      }
      settings->annealing.seed = static_cast<std::uint64_t>(seed);
    } else if (key == "preset") {
      const auto preset = objective::presetFromName(textOf(value));
      if (!preset) {
        return base::invalidInput(
            "preset: " + textOf(value) +
            " is none of faithful, simple, faithful-rigid, simple-rigid, balanced");
      }
      settings->preset = *preset;
    } else if (key == "method") {
      const std::vector<std::string_view> known = methodNames();
      if (std::find(known.begin(), known.end(), textOf(value)) == known.end()) {
        return base::invalidInput("method: " + textOf(value) + " is unknown; use " +
                                  choiceOf(known));
      }
      settings->method = textOf(value);
    } else if (key == "earlier") {
      base::Result<search::EarlierLayout> earlier = readEarlier(value);
      if (!earlier.ok()) {
        return earlier.error();
      }
      settings->annealing.earlier = std::move(earlier).value();
    } else if (key != "set") {
      return base::invalidInput("settings: no such key " + key +
                                "; known are seed, preset, method, set, earlier");
    }
  }
  applyPreset(settings);
  return true;
}

}  // namespace

base::Result<Settings> readSettings(std::string_view text) {
  Settings settings;
  if (text.empty()) {
    applyPreset(&settings);
    return settings;
  }
  // Bounded in depth, since messages show values and showing one is recursive.
  const base::Result<json> parsed = sketch::parseJsonText(text, sketch::JsonLimits{});
  if (!parsed.ok()) {
    return base::invalidInput("settings: " + parsed.error().message);
  }
  const json& root = parsed.value();
  if (!root.is_object()) {
    return base::invalidInput("settings: a JSON object is needed, such as {\"seed\": 1}");
  }
  const base::Result<bool> top = applyTop(&settings, root);
  if (!top.ok()) {
    return top.error();
  }
  if (const auto set = root.find("set"); set != root.end()) {
    if (!set->is_object()) {
      return base::invalidInput("set: an object of keys and values is needed");
    }
    for (const auto& [key, value] : set->items()) {
      const base::Result<bool> applied = applyKey(&settings, key, value);
      if (!applied.ok()) {
        return applied.error();
      }
    }
  }
  if (const base::Result<bool> limited = limitSearch(&settings); !limited.ok()) {
    return limited.error();
  }
  const std::vector<std::string>& connectors = settings.connectors;
  if (std::find(connectors.begin(), connectors.end(), layout::kBush) == connectors.end()) {
    settings.annealing.axles.clear();  // nothing would keep beams on them
  }
  return settings;
}

std::string settingsJson(const Settings& settings) {
  json weights = json::object();
  for (std::size_t i = 0; i < objective::kTerms.size(); ++i) {
    weights[std::string(objective::kTerms[i].name)] = settings.annealing.weights[i];
  }
  const search::AnnealingOptions& a = settings.annealing;
  json bent = json::array();
  for (const int form : a.bends) {
    bent.push_back(layout::bentBeams()[static_cast<std::size_t>(form)].part);
  }
  json frames = json::array();
  for (const int form : a.frames) {
    frames.push_back(layout::frameBeams()[static_cast<std::size_t>(form)].part);
  }
  json axles = json::array();
  for (const int axle : a.axles) {
    axles.push_back(layout::axleParts()[static_cast<std::size_t>(axle)].part);
  }
  json parts = json::object();
  for (const search::SearchSwitch& part : search::kSearchSwitches) {
    parts[keyOf(part)] = a.parts.*part.part ? 1 : 0;
  }
  return json{{"seed", a.seed},
              {"preset", std::string(objective::nameOf(settings.preset))},
              {"method", settings.method},
              {"starts", a.starts},
              {"rounds", a.maxRounds},
              {"startTemperature", a.startTemperature},
              {"endTemperature", a.endTemperature},
              {"mechanismParts", settings.mechanismParts},
              {"lengths", a.lengths},
              {"bent", bent},
              {"frames", frames},
              {"axles", axles},
              {"connectors", settings.connectors},
              {"paper.coolingRate", settings.paper.coolingRate},
              {"search", parts},
              {"owned", settings.owned},
              {"weights", weights}}
      .dump();
}

}  // namespace liftarm::design
