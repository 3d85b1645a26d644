#include "parts/catalogue_json.h"

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace liftarm::parts {

namespace {

using lattice::Vec3;
using nlohmann::json;

//! Reads members with a default and remembers whether all had their type: the data is our own, so
//! one flag for a whole part is enough.
class Fields {
 public:
  explicit Fields(const json& object) : object_(object) { good_ = object.is_object(); }

  double number(const char* key) { return numberIn(find(key)); }

  int whole(const char* key) {
    const json& value = find(key);
    good_ = good_ && value.is_number_integer();
    return value.is_number_integer() ? value.get<int>() : 0;
  }

  bool boolean(const char* key) {
    const json& value = find(key);
    good_ = good_ && value.is_boolean();
    return value.is_boolean() && value.get<bool>();
  }

  std::string text(const char* key) {
    const json& value = find(key);
    good_ = good_ && value.is_string();
    return value.is_string() ? value.get<std::string>() : std::string();
  }

  Vec3 vector(const char* key) { return vectorIn(find(key)); }

  Vec3 direction(const char* key) {
    const Vec3 v = vector(key);
    // The text has six decimals: directions off the axes need their last digits back.
    const double norm = lattice::length(v);
    good_ = good_ && norm > 0.5;
    return norm > 0.5 ? lattice::normalized(v) : v;
  }

  bool has(const char* key) const { return object_.is_object() && object_.contains(key); }

  const json& list(const char* key) {
    const json& value = find(key);
    good_ = good_ && value.is_array();
    return value;
  }

  const json& object(const char* key) { return find(key); }

  Vec3 vectorIn(const json& value) {
    if (!value.is_array() || value.size() != 3) {
      good_ = false;
      return {};
    }
    return {numberIn(value[0]), numberIn(value[1]), numberIn(value[2])};
  }

  void need(bool condition) { good_ = good_ && condition; }

  [[nodiscard]] bool good() const { return good_; }

 private:
  const json& find(const char* key) {
    static const json kNothing;
    return has(key) ? object_.at(key) : kNothing;
  }

  double numberIn(const json& value) {
    good_ = good_ && value.is_number();
    return value.is_number() ? value.get<double>() : 0.0;
  }

  const json& object_;
  bool good_ = true;
};

std::optional<PartClass> classFromName(std::string_view name) {
  if (name == "beam") {
    return PartClass::kBeam;
  }
  if (name == "pin") {
    return PartClass::kPin;
  }
  if (name == "axle") {
    return PartClass::kAxle;
  }
  if (name == "connector") {
    return PartClass::kConnector;
  }
  if (name == "bush") {
    return PartClass::kBush;
  }
  if (name == "gear") {
    return PartClass::kGear;
  }
  return std::nullopt;
}

std::optional<FeatureKind> kindFromName(std::string_view name) {
  if (name == "pin") {
    return FeatureKind::kPin;
  }
  if (name == "axle") {
    return FeatureKind::kAxle;
  }
  if (name == "pinHole") {
    return FeatureKind::kPinHole;
  }
  if (name == "axleHole") {
    return FeatureKind::kAxleHole;
  }
  return std::nullopt;
}

bool readFeature(const json& value, Feature& feature) {
  Fields fields(value);
  const std::optional<FeatureKind> kind = kindFromName(fields.text("kind"));
  fields.need(kind.has_value());
  feature.kind = kind.value_or(FeatureKind::kPin);
  feature.center = fields.vector("center");
  feature.axis = fields.direction("axis");
  feature.length = fields.number("length");
  if (fields.has("wing")) {
    feature.wing = fields.direction("wing");
  }
  for (const json& slot : fields.list("slots")) {
    feature.slots.push_back(fields.vectorIn(slot));
  }
  fields.need(!feature.slots.empty());
  return fields.good();
}

bool readPrisms(const json& list, std::vector<Prism>& prisms) {
  for (const json& value : list) {
    Fields fields(value);
    prisms.push_back({fields.vector("from"),
                      fields.vector("to"),
                      fields.direction("axis"),
                      fields.number("radius"),
                      fields.number("halfThickness")});
    if (!fields.good()) {
      return false;
    }
  }
  return true;
}

bool readGeometry(Fields& fields, Part& part) {
  for (const json& value : fields.list("features")) {
    part.features.emplace_back();
    fields.need(readFeature(value, part.features.back()));
  }
  for (const json& value : fields.list("stretches")) {
    Fields stretch(value);
    part.stretches.push_back({stretch.vector("from"), stretch.vector("to")});
    fields.need(stretch.good());
  }
  fields.need(readPrisms(fields.list("solid"), part.solid));
  fields.need(readPrisms(fields.list("collars"), part.collars));
  Fields bounds(fields.object("bounds"));
  part.boundsMin = bounds.vector("min");
  part.boundsMax = bounds.vector("max");
  fields.need(bounds.good());
  return fields.good();
}

bool readPart(const json& value, Part& part) {
  Fields fields(value);
  part.id = fields.text("id");
  part.name = fields.text("name");
  const std::optional<PartClass> partClass = classFromName(fields.text("class"));
  fields.need(partClass.has_value());
  part.partClass = partClass.value_or(PartClass::kConnector);
  part.mass = fields.number("mass");
  part.massEstimated = fields.boolean("massEstimated");
  part.friction = fields.boolean("friction");
  part.color = fields.whole("color");
  part.holes = fields.whole("holes");
  part.thickness = fields.number("thickness");
  return readGeometry(fields, part);
}

}  // namespace

base::Result<std::vector<Part>> readCatalogue(std::string_view json) {
  const auto document = nlohmann::json::parse(json.begin(), json.end(), nullptr, false);
  if (!document.is_object() || !document.contains("parts") || !document.at("parts").is_array()) {
    return base::Error{base::Status::kInvalidInput,
                       "catalogue: not an object with a list of parts"};
  }
  std::vector<Part> parts;
  for (const auto& value : document.at("parts")) {
    parts.emplace_back();
    if (!readPart(value, parts.back())) {
      return base::Error{base::Status::kInvalidInput,
                         "catalogue: parts[" + std::to_string(parts.size() - 1) + "] (" +
                             parts.back().id + "): a member is missing or has the wrong type"};
    }
  }
  return parts;
}

}  // namespace liftarm::parts
