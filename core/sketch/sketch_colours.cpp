#include "sketch/sketch_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>

#include "sketch/json_text.h"
#include "sketch/keep_json.h"
#include "sketch/shaft_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

using nlohmann::json;

// They stand for "as the whole" and for the edges of a part.
constexpr int kMainColour = 16;
constexpr int kEdgeColour = 24;

bool readCode(const json& value, FieldReader& fields, const std::string& place, int& out) {
  double number = 0.0;
  if (!fields.number(value, place, 1e9, number)) {
    return false;
  }
  const bool whole = number == std::floor(number);
  if (!whole || number < 0 || number > kMaxColour || number == kMainColour ||
      number == kEdgeColour) {
    return fields.fail(place,
                       shortNumber(number) + " is no colour; expected an LDraw code from 0 to " +
                           std::to_string(kMaxColour));
  }
  out = static_cast<int>(number);
  return true;
}

template <std::size_t kCount>
std::string listOf(const std::string_view (&names)[kCount]) {
  std::string text;
  for (const std::string_view name : names) {
    text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return text;
}

template <std::size_t kCount>
bool isOneOf(const std::string& name, const std::string_view (&names)[kCount]) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool readScheme(const json& value, FieldReader& fields, SketchColours& colours) {
  std::string scheme;
  if (!fields.text(value, "colours.scheme", scheme)) {
    return false;
  }
  if (!isOneOf(scheme, kColourSchemes)) {
    return fields.fail(
        "colours.scheme",
        inQuotes(scheme) + " is not known; expected one of " + listOf(kColourSchemes));
  }
  colours.scheme = scheme;
  return true;
}

bool readKinds(const json& value, FieldReader& fields, SketchColours& colours) {
  if (!value.is_object()) {
    return fields.object(value, "colours.kinds", {});
  }
  for (const auto& [kind, code] : value.items()) {
    if (!isOneOf(kind, kColourKinds)) {
      return fields.fail("colours.kinds",
                         inQuotes(kind) + " is not known; expected one of " + listOf(kColourKinds));
    }
    if (!readCode(code, fields, memberPlace("colours.kinds", kind), colours.kinds[kind])) {
      return false;
    }
  }
  return true;
}

//! The number of a line as a key; -1 where it is none.
int lineOfKey(const std::string& key, int lineCount) {
  const bool digits =
      !key.empty() && key.size() < 9 &&
      std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int line = digits ? std::stoi(key) : -1;
  return digits && line < lineCount && std::to_string(line) == key ? line : -1;
}

bool readLines(const json& value, FieldReader& fields, int lineCount, SketchColours& colours) {
  if (!value.is_object()) {
    return fields.object(value, "colours.lines", {});
  }
  for (const auto& [key, code] : value.items()) {
    const int line = lineOfKey(key, lineCount);
    if (line < 0) {
      return fields.fail("colours.lines",
                         inQuotes(key) + " is no line; expected numbers from 0 to " +
                             std::to_string(lineCount - 1));
    }
    if (!readCode(code, fields, memberPlace("colours.lines", key), colours.lines[line])) {
      return false;
    }
  }
  return true;
}

bool readParts(const json& value, FieldReader& fields, SketchColours& colours) {
  const std::string list = "colours.parts";
  if (!fields.array(value, list, "objects")) {
    return false;
  }
  if (value.size() > kMaxPaintedParts) {
    return fields.fail(list,
                       std::to_string(value.size()) + " elements; at most " +
                           std::to_string(kMaxPaintedParts) + " are read");
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string place = elementPlace(list, i);
    PaintedPart painted;
    if (!fields.object(value[i], place, {"part", "at", "colour"})) {
      return false;
    }
    const json* const part = fields.required(value[i], "part", place, "an LDraw part number");
    const json* const at = fields.required(value[i], "at", place, "three numbers [x, y, z]");
    const json* const colour = fields.required(value[i], "colour", place, "an LDraw code");
    if (part == nullptr || at == nullptr || colour == nullptr ||
        !readPartNumber(*part, fields, memberPlace(place, "part"), painted.part) ||
        !fields.vector(*at, memberPlace(place, "at"), kMaxCoordinate, painted.at) ||
        !readCode(*colour, fields, memberPlace(place, "colour"), painted.colour)) {
      return false;
    }
    colours.parts.push_back(std::move(painted));
  }
  return true;
}

std::string decimalText(double value) {
  const std::string text = json(value).dump();
  return text == "-0.0" ? "0.0" : text;
}

std::string paintedText(const PaintedPart& painted) {
  return R"({"part": ")" + painted.part + R"(", "at": [)" + decimalText(painted.at.x) + ", " +
         decimalText(painted.at.y) + ", " + decimalText(painted.at.z) + R"(], "colour": )" +
         std::to_string(painted.colour) + "}";
}

template <typename Key>
std::string codesText(const std::map<Key, int>& codes) {
  std::string text;
  for (const auto& [key, code] : codes) {
    std::string name;
    if constexpr (std::is_same_v<Key, int>) {
      name = std::to_string(key);
    } else {
      name = key;
    }
    text += (text.empty() ? "\"" : ", \"") + name + "\": " + std::to_string(code);
  }
  return "{" + text + "}";
}

std::string coloursText(const SketchColours& colours) {
  std::string text;
  const auto add = [&](const char* key, const std::string& value) {
    text += (text.empty() ? "\"" : ", \"") + std::string(key) + "\": " + value;
  };
  if (colours.scheme.has_value()) {
    add("scheme", "\"" + *colours.scheme + "\"");
  }
  if (colours.standard.has_value()) {
    add("default", std::to_string(*colours.standard));
  }
  if (!colours.kinds.empty()) {
    add("kinds", codesText(colours.kinds));
  }
  if (!colours.lines.empty()) {
    add("lines", codesText(colours.lines));
  }
  if (!colours.parts.empty()) {
    std::string parts;
    for (const PaintedPart& painted : colours.parts) {
      parts += (parts.empty() ? "" : ", ") + paintedText(painted);
    }
    add("parts", "[" + parts + "]");
  }
  return "{" + text + "}";
}

}  // namespace

bool readColours(const json& document, FieldReader& fields, int lineCount, SketchColours& colours) {
  const auto member = document.find("colours");
  if (member == document.end()) {
    return true;
  }
  if (!fields.object(*member, "colours", {"scheme", "default", "kinds", "lines", "parts"})) {
    return false;
  }
  const auto value = [&](const char* key) -> const json* {
    const auto found = member->find(key);
    return found != member->end() ? &*found : nullptr;
  };
  if (const json* scheme = value("scheme"); scheme && !readScheme(*scheme, fields, colours)) {
    return false;
  }
  if (const json* code = value("default");
      code && !readCode(*code, fields, "colours.default", colours.standard.emplace())) {
    return false;
  }
  if (const json* kinds = value("kinds"); kinds && !readKinds(*kinds, fields, colours)) {
    return false;
  }
  const json* lines = value("lines");
  if (lines != nullptr && !readLines(*lines, fields, lineCount, colours)) {
    return false;
  }
  const json* parts = value("parts");
  return parts == nullptr || readParts(*parts, fields, colours);
}

SketchColours coloursOf(std::string_view text) {
  SketchColours colours;
  const json document = json::parse(text.begin(), text.end(), nullptr, false);
  if (!document.is_object() || !document.contains("lines") || !document.at("lines").is_array()) {
    return colours;
  }
  FieldReader fields;
  if (!readColours(document, fields, static_cast<int>(document.at("lines").size()), colours)) {
    return {};
  }
  return colours;
}

std::string writeSketch(const Sketch& sketch,
                        const SketchColours& colours,
                        const Keeps& keeps,
                        const Shafts& shafts) {
  std::string text = writeSketch(sketch);
  if (colours.empty() && keeps.empty() && shafts.empty()) {
    return text;
  }
  // Both versions differ in their number and in what may follow.
  const std::string number = "\"version\": 1";
  const std::size_t place = text.find(number);
  if (place < text.find("\"lines\"")) {
    text.replace(place, number.size(), "\"version\": 2");
  }
  text.resize(text.rfind("\n}"));
  text += shaftsText(shafts);
  text += keepsText(keeps);
  text += colours.empty() ? "" : ",\n  \"colours\": " + coloursText(colours);
  return text + "\n}\n";
}

}  // namespace liftarm::sketch
