#include "model/model_json.h"

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "model/number_text.h"
#include "model/seating.h"

namespace liftarm::model {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxNameBytes = 1000;
constexpr int kPoseDecimals = 12;
constexpr int kMaxDepth = 32;  // arrays and objects inside each other; writing them back recurses

//! Takes values out of the document and keeps the first thing that is wrong.
class Reader {
 public:
  bool fail(const std::string& place, const std::string& message) {
    if (message_.empty()) {
      message_ = place + ": " + message;
    }
    return false;
  }

  bool numbers(const json& object,
               const std::string& place,
               const char* key,
               double* out,
               std::size_t count) {
    const std::string at = place + "." + key;
    if (!object.contains(key)) {
      return fail(at, "missing; expected " + std::to_string(count) + " numbers");
    }
    const json& value = object.at(key);
    if (!value.is_array() || value.size() != count) {
      return fail(at, "expected an array of " + std::to_string(count) + " numbers");
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::string element = at + "[" + std::to_string(i) + "]";
      if (!value[i].is_number()) {
        return fail(element, "expected a number");
      }
      out[i] = value[i].get<double>();
      if (!std::isfinite(out[i]) || std::abs(out[i]) > kMaxPosition) {
        return fail(element,
                    "outside the limit of -" + numberText(kMaxPosition) + " to " +
                        numberText(kMaxPosition));
      }
    }
    return true;
  }

  bool whole(const json& object, const std::string& place, const char* key, int& out) {
    if (!object.contains(key)) {
      return true;
    }
    constexpr std::int64_t kLimit = 1'000'000;
    const json& value = object.at(key);
    if (!value.is_number_integer() || value.get<std::int64_t>() > kLimit ||
        value.get<std::int64_t>() < -kLimit) {
      return fail(place + "." + key, "expected a whole number");
    }
    out = value.get<int>();
    return true;
  }

  bool text(const json& object, const std::string& place, const char* key, std::string& out) {
    const json& value = object.at(key);
    if (!value.is_string() || value.get_ref<const std::string&>().size() > kMaxNameBytes) {
      return fail(place + key,
                  "expected a text of at most " + std::to_string(kMaxNameBytes) + " bytes");
    }
    out = value.get<std::string>();
    return true;
  }

  bool part(const json& value, const std::string& place, PlacedPart& out) {
    if (!value.is_object()) {
      return fail(place, "expected an object in braces");
    }
    if (!value.contains("part")) {
      return fail(place + ".part", "missing; expected an LDraw part number such as \"32316\"");
    }
    double position[3] = {};
    if (!text(value, place + ".", "part", out.part) ||
        !numbers(value, place, "position", position, 3) ||
        !numbers(value, place, "rotation", out.pose.rotation.m.data(), 9)) {
      return false;
    }
    out.pose.position = {position[0], position[1], position[2]};
    const parts::Part* known = parts::Catalogue::builtIn().find(out.part);
    out.color = known != nullptr ? known->color : out.color;
    return whole(value, place, "color", out.color) &&
           whole(value, place, "component", out.component) &&
           whole(value, place, "layer", out.layer) && whole(value, place, "piece", out.piece);
  }

  [[nodiscard]] base::Error error() const { return {base::Status::kInvalidInput, message_}; }

 private:
  std::string message_;
};

base::Error invalid(std::string message) {
  return {base::Status::kInvalidInput, std::move(message)};
}

//! The document, or why there is none.
base::Result<json> parsed(std::string_view text) {
  bool tooDeep = false;
  const auto watch = [&](int depth, json::parse_event_t, const json&) {
    tooDeep = tooDeep || depth > kMaxDepth;
    return !tooDeep;
  };
  json document = json::parse(text.begin(), text.end(), watch, false);
  if (tooDeep) {
    return invalid("arrays and objects lie more than " + std::to_string(kMaxDepth) +
                   " deep inside each other");
  }
  return document;
}

//! The heading of the file: what it claims to be. Nothing when that is right.
std::optional<base::Error> headingError(const json& document) {
  if (document.is_discarded()) {
    return invalid("not valid JSON");
  }
  if (!document.is_object()) {
    return invalid("expected an object with format, version and parts");
  }
  if (!document.contains("format") || document.at("format") != "liftarm-model") {
    return invalid("format: expected \"liftarm-model\"");
  }
  if (!document.contains("version") || document.at("version") != 1) {
    return invalid("version: expected 1");
  }
  if (!document.contains("parts") || !document.at("parts").is_array()) {
    return invalid("parts: expected an array of placed parts");
  }
  if (document.at("parts").size() > kMaxParts) {
    return invalid("parts: " + std::to_string(document.at("parts").size()) + " parts; at most " +
                   std::to_string(kMaxParts) + " are read");
  }
  return std::nullopt;
}

std::string quoted(const std::string& text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string partText(const PlacedPart& part) {
  std::string rotation;
  for (const double value : part.pose.rotation.m) {
    rotation += (rotation.empty() ? "" : ",") + numberText(value, kPoseDecimals);
  }
  const lattice::Vec3 p = part.pose.position;
  return R"({"part":)" + quoted(part.part) + R"(,"color":)" + std::to_string(part.color) +
         R"(,"position":[)" + numberText(p.x, kPoseDecimals) + "," +
         numberText(p.y, kPoseDecimals) + "," + numberText(p.z, kPoseDecimals) +
         R"(],"rotation":[)" + rotation + R"(],"component":)" + std::to_string(part.component) +
         R"(,"layer":)" + std::to_string(part.layer) + R"(,"piece":)" + std::to_string(part.piece) +
         "}";
}

}  // namespace

base::Result<Model> readModel(std::string_view text) {
  if (text.size() > kMaxModelBytes) {
    return invalid("the file has " + std::to_string(text.size()) + " bytes; at most " +
                   std::to_string(kMaxModelBytes) + " are read");
  }
  const base::Result<json> read = parsed(text);
  if (!read.ok()) {
    return read.error();
  }
  const json& document = read.value();
  if (const std::optional<base::Error> error = headingError(document); error.has_value()) {
    return *error;
  }
  Reader reader;
  Model model;
  if (document.contains("name") && !reader.text(document, "", "name", model.name)) {
    return reader.error();
  }
  for (std::size_t i = 0; i < document.at("parts").size(); ++i) {
    model.parts.emplace_back();
    if (!reader.part(
            document.at("parts")[i], "parts[" + std::to_string(i) + "]", model.parts.back())) {
      return reader.error();
    }
  }
  if (document.contains("sketch") && !document.at("sketch").is_null()) {
    model.sketchJson = document.at("sketch").dump(-1, ' ', false, json::error_handler_t::replace);
  }
  seatHeads(model, parts::Catalogue::builtIn());
  return model;
}

std::string writeModel(const Model& model) {
  std::string text =
      "{\"format\":\"liftarm-model\",\"version\":1,\"name\":" + quoted(model.name) + ",\"parts\":[";
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + partText(model.parts[i]);
  }
  text += "\n]";
  const json sketch = json::parse(model.sketchJson, nullptr, false);
  if (sketch.is_object()) {
    text += ",\"sketch\":" + sketch.dump(-1, ' ', false, json::error_handler_t::replace);
  }
  return text + "}\n";
}

Model asWritten(const Model& model) {
  base::Result<Model> read = readModel(writeModel(model));
  return read.ok() ? std::move(read).value() : model;
}

}  // namespace liftarm::model
