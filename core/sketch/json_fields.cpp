#include "sketch/json_fields.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "sketch/json_text.h"

namespace liftarm::sketch {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kAxisNames{"x", "y", "z"};

//! What a value is, with its article: "a string".
std::string kindOf(const json& value) {
  switch (value.type()) {
    case json::value_t::null:
      return "null";
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
      return "an array";
    case json::value_t::string:
      return "the text " + inQuotes(value.get_ref<const std::string&>());
    case json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
    case json::value_t::number_float:
      return "the number " + shortNumber(value.get<double>());
    case json::value_t::binary:
    case json::value_t::discarded:
      break;
  }
  return "something else";
}

//! Vectors whose length is this close to 1 are left as they are, so that writing and reading again
//! changes no bit.
constexpr double kUnitTolerance = 1e-12;

//! In how many letters two words differ at the least, capitals aside; no more than `most` + 1.
std::size_t lettersApart(std::string_view a, std::string_view b, std::size_t most) {
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > most) {
    return most + 1;
  }
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t corner = row[0];
    row[0] = i + 1;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t kept = corner + (small(a[i]) == small(b[k]) ? 0 : 1);
      corner = row[k + 1];
      row[k + 1] = std::min({kept, row[k] + 1, corner + 1});
    }
  }
  return row.back();
}

//! The known key that an unknown one most likely was to be; empty where none is like it.
std::string_view nearestKey(std::string_view key, std::initializer_list<std::string_view> known) {
  constexpr std::size_t kMostApart = 2;
  std::string_view nearest;
  std::size_t least = kMostApart + 1;
  for (const std::string_view name : known) {
    const std::size_t apart = lettersApart(key, name, kMostApart);
    nearest = apart < least ? name : nearest;
    least = std::min(least, apart);
  }
  return nearest;
}

constexpr double kMaxDirection = 1e6;  //!< components of a normal or an axis before it is made unit
constexpr double kMinDirection = 1e-6;

}  // namespace

bool FieldReader::fail(std::string_view place, std::string_view message) {
  if (message_.empty()) {
    message_ = std::string(place) + (place.empty() ? "" : ": ") + std::string(message);
  }
  return false;
}

bool FieldReader::object(const json& value,
                         std::string_view place,
                         std::initializer_list<std::string_view> knownKeys) {
  if (!value.is_object()) {
    return fail(place, "expected an object in braces, found " + kindOf(value));
  }
  for (const auto& [key, ignored] : value.items()) {
    if (std::find(knownKeys.begin(), knownKeys.end(), key) == knownKeys.end()) {
      std::string known;
      for (const std::string_view name : knownKeys) {
        known += (known.empty() ? "" : ", ") + std::string(name);
      }
      const std::string_view nearest = nearestKey(key, knownKeys);
      return fail(place,
                  "unknown key " + inQuotes(key) +
                      (nearest.empty() ? "" : ", most likely " + std::string(nearest)) +
                      "; known keys here: " + known);
    }
  }
  return !failed();
}

bool FieldReader::array(const json& value, std::string_view place, std::string_view whatItHolds) {
  if (!value.is_array()) {
    return fail(place,
                "expected an array of " + std::string(whatItHolds) + ", found " + kindOf(value));
  }
  return !failed();
}

const json* FieldReader::required(const json& object,
                                  std::string_view key,
                                  std::string_view place,
                                  std::string_view wanted) {
  const auto found = object.find(std::string(key));
  if (found == object.end()) {
    fail(memberPlace(place, key), "missing; expected " + std::string(wanted));
    return nullptr;
  }
  return &*found;
}

bool FieldReader::number(const json& value, std::string_view place, double limit, double& out) {
  if (!value.is_number()) {
    return fail(place, "expected a number, found " + kindOf(value));
  }
  out = value.get<double>();
  if (!std::isfinite(out)) {
    return fail(place, "expected a finite number");
  }
  if (std::abs(out) > limit) {
    return fail(place,
                shortNumber(out) + " is outside the limit of " + shortNumber(-limit) + " to " +
                    shortNumber(limit));
  }
  out += 0.0;  // -0 becomes 0
  return !failed();
}

bool FieldReader::vector(const json& value,
                         std::string_view place,
                         double limit,
                         lattice::Vec3& out) {
  if (!value.is_array() || value.size() != 3) {
    const std::string found =
        value.is_array() ? "an array of " + std::to_string(value.size()) : kindOf(value);
    return fail(place, "expected three numbers [x, y, z], found " + found);
  }
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!number(value[k], elementPlace(place, k), limit, out[i])) {
      return false;
    }
  }
  return !failed();
}

bool FieldReader::direction(const json& value, std::string_view place, lattice::Vec3& out) {
  lattice::Vec3 raw;
  if (!vector(value, place, kMaxDirection, raw)) {
    return false;
  }
  const double length = lattice::length(raw);
  if (length < kMinDirection) {
    return fail(place, "a direction must not be zero; expected for example [0, 0, 1]");
  }
  out = std::abs(length - 1.0) <= kUnitTolerance
            ? raw
            : lattice::Vec3{raw.x / length, raw.y / length, raw.z / length};
  return !failed();
}

bool FieldReader::boolean(const json& value, std::string_view place, bool& out) {
  if (!value.is_boolean()) {
    return fail(place, "expected true or false, found " + kindOf(value));
  }
  out = value.get<bool>();
  return !failed();
}

bool FieldReader::text(const json& value, std::string_view place, std::string& out) {
  if (!value.is_string()) {
    return fail(place, "expected a text in quotes, found " + kindOf(value));
  }
  out = value.get<std::string>();
  return !failed();
}

bool FieldReader::axis(const json& value, std::string_view place, lattice::Axis& out) {
  if (value.is_string()) {
    const auto found =
        std::find(kAxisNames.begin(), kAxisNames.end(), value.get_ref<const std::string&>());
    if (found != kAxisNames.end()) {
      out = lattice::axisFromIndex(static_cast<int>(found - kAxisNames.begin()));
      return !failed();
    }
  }
  return fail(place, "expected \"x\", \"y\" or \"z\", found " + kindOf(value));
}

bool FieldReader::lineIndex(const json& value, std::string_view place, int lineCount, int& out) {
  double index = -1.0;
  if (value.is_number()) {
    index = value.get<double>();
  }
  if (!value.is_number() || index != std::floor(index)) {
    return fail(place, "expected the number of a line, found " + kindOf(value));
  }
  if (index < 0.0 || index >= static_cast<double>(lineCount)) {
    return fail(place,
                "there is no line " + shortNumber(index) + "; lines are numbered 0 to " +
                    std::to_string(lineCount - 1));
  }
  out = static_cast<int>(index);
  return !failed();
}

bool FieldReader::lineIndices(const json& value,
                              std::string_view place,
                              int lineCount,
                              std::vector<int>& out) {
  if (!array(value, place, "line numbers")) {
    return false;
  }
  if (value.empty()) {
    return fail(place, "expected at least one line number");
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    int index = 0;
    if (!lineIndex(value[i], elementPlace(place, i), lineCount, index)) {
      return false;
    }
    out.push_back(index);
  }
  std::vector<int> sorted = out;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    return fail(place, "line " + std::to_string(*twice) + " is named twice");
  }
  return !failed();
}

std::string elementPlace(std::string_view place, std::size_t index) {
  return std::string(place) + "[" + std::to_string(index) + "]";
}

std::string memberPlace(std::string_view place, std::string_view key) {
  return std::string(place) + (place.empty() ? "" : ".") + std::string(key);
}

std::string_view axisName(lattice::Axis axis) {
  return kAxisNames[static_cast<std::size_t>(lattice::index(axis))];
}

}  // namespace liftarm::sketch
