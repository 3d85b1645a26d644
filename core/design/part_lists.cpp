#include "design/part_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "layout/axle.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "layout/stack.h"
#include "parts/catalogue.h"

namespace liftarm::design {

namespace {

using base::Error;
using base::Status;
using nlohmann::json;

constexpr std::array<std::string_view, 5> kLists{
    "axles", "bent", "connectors", "frames", "lengths"};

std::vector<std::string> splitList(const std::string& text) {
  std::vector<std::string> items;
  std::string item;
  for (const char c : text + ",") {
    if (c != ',') {
      item += c;
    } else if (!item.empty()) {
      items.push_back(item);
      item.clear();
    }
  }
  return items;
}

//! NaN where the text is no number.
double numberOf(const std::string& text) {
  const json parsed = json::parse(text, nullptr, false);
  return parsed.is_number() ? parsed.get<double>() : std::nan("");
}

//! Parts of one kind by their index. \param kind What they are called.
base::Result<std::vector<int>> readForms(const std::string& key,
                                         const std::string& kind,
                                         const std::vector<std::string>& parts,
                                         const std::vector<std::string>& items) {
  std::vector<int> forms;
  for (const std::string& id : items) {
    const auto found = std::find(parts.begin(), parts.end(), id);
    if (found == parts.end()) {
      std::string known;
      for (const std::string& part : parts) {
        known += (known.empty() ? "" : ", ") + part;
      }
      return base::invalidInput("set." + key + ": " + id + " is no " + kind + "; use some of " +
                                known);
    }
    forms.push_back(static_cast<int>(found - parts.begin()));
  }
  std::sort(forms.begin(), forms.end());
  forms.erase(std::unique(forms.begin(), forms.end()), forms.end());
  return forms;
}

template <typename Kind>
std::vector<std::string> numbersOf(const std::vector<Kind>& kinds) {
  std::vector<std::string> parts;
  for (const Kind& kind : kinds) {
    parts.push_back(kind.part);
  }
  return parts;
}

base::Result<std::vector<int>> formsOf(const std::string& key,
                                       const std::vector<std::string>& items) {
  if (key == "bent") {
    return readForms(key, "bent beam", numbersOf(layout::bentBeams()), items);
  }
  return key == "frames" ? readForms(key, "frame", numbersOf(layout::frameBeams()), items)
                         : readForms(key, "plain axle", numbersOf(layout::axleParts()), items);
}

base::Result<bool> applyForms(Settings* settings,
                              const std::string& key,
                              const std::vector<std::string>& items) {
  base::Result<std::vector<int>> forms = formsOf(key, items);
  if (!forms.ok()) {
    return forms.error();
  }
  search::AnnealingOptions& options = settings->annealing;
  std::vector<int>& target =
      key == "bent" ? options.bends : (key == "frames" ? options.frames : options.axles);
  target = std::move(forms).value();
  return true;
}

}  // namespace

bool isPartList(const std::string& key) {
  return std::find(kLists.begin(), kLists.end(), key) != kLists.end();
}

base::Result<bool> applyPartList(Settings* settings,
                                 const std::string& key,
                                 const std::string& text) {
  const std::vector<std::string> items = splitList(text);
  if (key == "connectors") {
    for (const std::string& id : items) {
      const parts::Part* part = parts::Catalogue::builtIn().find(id);
      if (part == nullptr) {
        return base::invalidInput("set.connectors: no part " + id + " in the catalogue");
      }
      if (part->partClass == parts::PartClass::kGear ||
          (part->partClass == parts::PartClass::kBeam && id != layout::kSpacerPart)) {
        return base::invalidInput("set.connectors: " + id + " is no pin, axle or connector");
      }
    }
    if (std::find(items.begin(), items.end(), "2780") == items.end()) {
      return base::invalidInput(
          "set.connectors: 2780 is needed, since joints in line are pinned with it");
    }
    settings->connectors = items;
    return true;
  }
  if (key == "bent" || key == "frames" || key == "axles") {
    return applyForms(settings, key, items);
  }
  const std::vector<int> known{2, 3, 5, 6, 7, 9, 11, 13, 15};
  std::vector<int> lengths;
  for (const std::string& item : items) {
    const double number = numberOf(item);
    const auto found = std::find_if(known.begin(), known.end(), [&](int n) { return n == number; });
    if (found == known.end()) {
      return base::invalidInput("set.lengths: " + item +
                                " is no beam length; use 2, 3, 5, 6, 7, 9, 11, 13, 15");
    }
    lengths.push_back(*found);
  }
  if (lengths.empty()) {
    return base::invalidInput(
        "set.lengths: at least one beam length is needed, such as \"3,5,9,15\"");
  }
  std::sort(lengths.begin(), lengths.end());
  lengths.erase(std::unique(lengths.begin(), lengths.end()), lengths.end());
  settings->annealing.lengths = lengths;
  return true;
}

}  // namespace liftarm::design
