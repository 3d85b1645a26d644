#include "sketch/annotation_reader.h"

#include <array>
#include <cmath>

#include "sketch/json_text.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

using nlohmann::json;

constexpr double kMaxOffset = 1e10;  // a normal of length 1e6 times a coordinate
constexpr double kMaxRange = 180.0;  // degrees either way

//! Reads what a sketch says about its lines. \pre the lines are read.
class AnnotationReader {
 public:
  AnnotationReader(const json& document, FieldReader& fields, Sketch& sketch)
      : document_(document),
        fields_(fields),
        sketch_(sketch),
        latest_(document.value("version", 1.0) > 1.0) {}

  bool read() { return readJoints() && readSymmetries() && readKeepOut() && readGround(); }

 private:
  //! The member `key` as an array of at most so many, or null when there is none.
  bool annotations(std::string_view key, std::size_t most, const json*& out) {
    const auto found = document_.find(std::string(key));
    out = found == document_.end() ? nullptr : &*found;
    if (out == nullptr) {
      return true;
    }
    if (!fields_.array(*out, key, "objects")) {
      return false;
    }
    if (out->size() > most) {
      return fields_.fail(
          key,
          std::to_string(out->size()) + " elements; at most " + std::to_string(most) + " are read");
    }
    return true;
  }

  bool readJoints() {
    const json* joints = nullptr;
    if (!annotations("joints", kMaxJoints, joints)) {
      return false;
    }
    for (std::size_t i = 0; joints != nullptr && i < joints->size(); ++i) {
      if (!readJoint((*joints)[i], elementPlace("joints", i))) {
        return false;
      }
    }
    return true;
  }

  bool readJoint(const json& value, const std::string& place) {
    Joint joint;
    if (!(latest_ ? fields_.object(value, place, {"at", "axis", "between", "kind", "range"})
                  : fields_.object(value, place, {"at", "axis", "between"}))) {
      return false;
    }
    const json* const at = fields_.required(value, "at", place, "three numbers [x, y, z]");
    const json* const axis = fields_.required(value, "axis", place, "a direction [x, y, z]");
    if (at == nullptr || axis == nullptr ||
        !fields_.vector(*at, memberPlace(place, "at"), kMaxCoordinate, joint.at) ||
        !fields_.direction(*axis, memberPlace(place, "axis"), joint.axis)) {
      return false;
    }
    const auto between = value.find("between");
    if (between != value.end()) {
      const std::string groupsPlace = memberPlace(place, "between");
      if (!fields_.array(*between, groupsPlace, "groups of line numbers")) {
        return false;
      }
      if (between->size() < 2 || between->size() > kMaxJointBodies) {
        return fields_.fail(groupsPlace,
                            "expected 2 to " + std::to_string(kMaxJointBodies) +
                                " groups of line numbers, such as [[0], [1, 2]], found an array "
                                "of " +
                                std::to_string(between->size()));
      }
      for (std::size_t g = 0; g < between->size(); ++g) {
        if (!fields_.lineIndices((*between)[g],
                                 elementPlace(groupsPlace, g),
                                 lineCount(),
                                 joint.between.emplace_back())) {
          return false;
        }
        jointLines_ += joint.between.back().size();
      }
    }
    if (jointLines_ > kMaxJointLines) {
      return fields_.fail(
          place, "the joints name more than " + std::to_string(kMaxJointLines) + " lines together");
    }
    if (!readKind(value, place) || !readRange(value, place, joint)) {
      return false;
    }
    sketch_.joints.push_back(std::move(joint));
    return true;
  }

  //! Hinges alone can be had so far.
  bool readKind(const json& value, const std::string& place) {
    const auto kind = value.find("kind");
    std::string name;
    if (kind == value.end()) {
      return true;
    }
    if (!fields_.text(*kind, memberPlace(place, "kind"), name)) {
      return false;
    }
    return name == "hinge" || fields_.fail(memberPlace(place, "kind"),
                                           inQuotes(name) + " is not known; expected \"hinge\"");
  }

  bool readRange(const json& value, const std::string& place, Joint& joint) {
    const auto range = value.find("range");
    if (range == value.end()) {
      return true;
    }
    const std::string rangePlace = memberPlace(place, "range");
    if (!fields_.array(*range, rangePlace, "two angles in degrees")) {
      return false;
    }
    std::array<double, 2> ends{};
    if (range->size() != ends.size()) {
      return fields_.fail(rangePlace, "expected two angles in degrees, such as [-180, 180]");
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (!fields_.number((*range)[i], elementPlace(rangePlace, i), kMaxRange, ends[i])) {
        return false;
      }
    }
    if (ends[0] > 0.0 || ends[1] < 0.0 || ends[0] == ends[1]) {
      return fields_.fail(rangePlace, "expected an angle of at most 0 and one of at least 0");
    }
    joint.range = ends;
    return true;
  }

  bool readSymmetries() {
    const json* symmetries = nullptr;
    if (!annotations("symmetries", kMaxSymmetries, symmetries)) {
      return false;
    }
    for (std::size_t i = 0; symmetries != nullptr && i < symmetries->size(); ++i) {
      if (!readSymmetry((*symmetries)[i], elementPlace("symmetries", i))) {
        return false;
      }
    }
    return true;
  }

  bool readSymmetry(const json& value, const std::string& place) {
    if (!value.is_object()) {
      return fields_.object(value, place, {});
    }
    const json* const kind =
        fields_.required(value, "kind", place, "\"reflection\" or \"translation\"");
    std::string name;
    if (kind == nullptr || !fields_.text(*kind, memberPlace(place, "kind"), name)) {
      return false;
    }
    if (name == "reflection") {
      return readReflection(value, place);
    }
    if (name == "translation") {
      return readTranslation(value, place);
    }
    return fields_.fail(
        memberPlace(place, "kind"),
        inQuotes(name) + " is not known; expected \"reflection\" or \"translation\"");
  }

  bool readReflection(const json& value, const std::string& place) {
    Symmetry symmetry;
    symmetry.kind = Symmetry::Kind::kReflection;
    if (!fields_.object(value, place, {"kind", "normal", "offset", "lines"})) {
      return false;
    }
    const json* const normal = fields_.required(value, "normal", place, "a direction [x, y, z]");
    const json* const offset = fields_.required(value, "offset", place, "a number of modules");
    if (normal == nullptr || offset == nullptr ||
        !fields_.direction(*normal, memberPlace(place, "normal"), symmetry.normal) ||
        !fields_.number(*offset, memberPlace(place, "offset"), kMaxOffset, symmetry.offset)) {
      return false;
    }
    symmetry.offset /= lengthBeforeUnit(*normal);
    const auto lines = value.find("lines");
    if (lines != value.end() &&
        !fields_.lineIndices(*lines, memberPlace(place, "lines"), lineCount(), symmetry.lines)) {
      return false;
    }
    sketch_.symmetries.push_back(std::move(symmetry));
    return true;
  }

  //! The plane normal.p = offset stays where it is when the normal is made unit length.
  static double lengthBeforeUnit(const json& normal) {
    const lattice::Vec3 raw{
        normal[0].get<double>(), normal[1].get<double>(), normal[2].get<double>()};
    const double length = lattice::length(raw);
    return std::abs(length - 1.0) <= 1e-12 ? 1.0 : length;
  }

  bool readTranslation(const json& value, const std::string& place) {
    Symmetry symmetry;
    symmetry.kind = Symmetry::Kind::kTranslation;
    if (!fields_.object(value, place, {"kind", "vector", "pairs"})) {
      return false;
    }
    const json* const vector = fields_.required(value, "vector", place, "a shift [x, y, z]");
    const json* const pairs =
        fields_.required(value, "pairs", place, "pairs of line numbers, such as [[0, 1]]");
    if (vector == nullptr || pairs == nullptr ||
        !fields_.vector(
            *vector, memberPlace(place, "vector"), 2.0 * kMaxCoordinate, symmetry.vector)) {
      return false;
    }
    if (symmetry.vector == lattice::Vec3{}) {
      return fields_.fail(memberPlace(place, "vector"), "a shift must not be zero");
    }
    const std::string pairsPlace = memberPlace(place, "pairs");
    if (!fields_.array(*pairs, pairsPlace, "pairs of line numbers")) {
      return false;
    }
    if (pairs->empty()) {
      return fields_.fail(pairsPlace, "expected at least one pair of line numbers");
    }
    for (std::size_t i = 0; i < pairs->size(); ++i) {
      std::vector<int> pair;
      const std::string pairPlace = elementPlace(pairsPlace, i);
      if (!fields_.lineIndices((*pairs)[i], pairPlace, lineCount(), pair)) {
        return false;
      }
      if (pair.size() != 2) {
        return fields_.fail(pairPlace, "expected two line numbers: a line and its image");
      }
      symmetry.pairs.emplace_back(pair[0], pair[1]);
    }
    sketch_.symmetries.push_back(std::move(symmetry));
    return true;
  }

  bool readKeepOut() {
    const json* boxes = nullptr;
    if (!annotations("keepOut", kMaxKeepOuts, boxes)) {
      return false;
    }
    for (std::size_t i = 0; boxes != nullptr && i < boxes->size(); ++i) {
      if (!readBox((*boxes)[i], elementPlace("keepOut", i))) {
        return false;
      }
    }
    return true;
  }

  bool readBox(const json& value, const std::string& place) {
    KeepOut box;
    if (!fields_.object(value, place, {"min", "max"})) {
      return false;
    }
    const json* const min = fields_.required(value, "min", place, "three numbers [x, y, z]");
    const json* const max = fields_.required(value, "max", place, "three numbers [x, y, z]");
    if (min == nullptr || max == nullptr ||
        !fields_.vector(*min, memberPlace(place, "min"), kMaxCoordinate, box.min) ||
        !fields_.vector(*max, memberPlace(place, "max"), kMaxCoordinate, box.max)) {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (box.min[axis] > box.max[axis]) {
        const auto k = static_cast<std::size_t>(axis);
        return fields_.fail(elementPlace(memberPlace(place, "min"), k),
                            shortNumber(box.min[axis]) + " is above " + elementPlace("max", k) +
                                ", which is " + shortNumber(box.max[axis]));
      }
    }
    sketch_.keepOut.push_back(box);
    return true;
  }

  bool readGround() {
    const auto ground = document_.find("ground");
    return ground == document_.end() ||
           fields_.number(*ground, "ground", kMaxCoordinate, sketch_.ground.emplace());
  }

  [[nodiscard]] int lineCount() const { return static_cast<int>(sketch_.lines.size()); }

  const json& document_;
  FieldReader& fields_;
  Sketch& sketch_;
  bool latest_;  // of version 2
  std::size_t jointLines_ = 0;
};

}  // namespace

bool readAnnotations(const json& document, FieldReader& fields, Sketch& sketch) {
  return AnnotationReader(document, fields, sketch).read();
}

}  // namespace liftarm::sketch
