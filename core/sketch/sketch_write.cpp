#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

#include "sketch/json_fields.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

using lattice::Vec3;
using nlohmann::json;

//! The shortest text that reads back as the same number.
std::string numberText(double value) {
  std::string text = json(value).dump();
  if (text.size() > 2 && text.compare(text.size() - 2, 2, ".0") == 0) {
    text.resize(text.size() - 2);
  }
  return text == "-0" ? "0" : text;
}

std::string vectorText(const Vec3& v) {
  return "[" + numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z) + "]";
}

std::string indicesText(const std::vector<int>& indices) {
  std::string text;
  for (const int index : indices) {
    text += (text.empty() ? "" : ", ") + std::to_string(index);
  }
  return "[" + text + "]";
}

std::string lineText(const Line& line) {
  std::string text = R"({"from": )" + vectorText(line.from) + R"(, "to": )" + vectorText(line.to);
  if (line.exact) {
    text += R"(, "exact": true)";
  }
  if (line.holeAxis.has_value()) {
    text += R"(, "holeAxis": ")" + std::string(axisName(*line.holeAxis)) + "\"";
  }
  return text + "}";
}

std::string jointText(const Joint& joint) {
  std::string text = R"({"at": )" + vectorText(joint.at) + R"(, "axis": )" + vectorText(joint.axis);
  if (!joint.between.empty()) {
    std::string groups;
    for (const std::vector<int>& group : joint.between) {
      groups += (groups.empty() ? "" : ", ") + indicesText(group);
    }
    text += R"(, "between": [)" + groups + "]";
  }
  if (joint.range.has_value()) {
    text += R"(, "range": [)" + numberText((*joint.range)[0]) + ", " +
            numberText((*joint.range)[1]) + "]";
  }
  return text + "}";
}

std::string symmetryText(const Symmetry& symmetry) {
  if (symmetry.kind == Symmetry::Kind::kReflection) {
    std::string text = R"({"kind": "reflection", "normal": )" + vectorText(symmetry.normal) +
                       R"(, "offset": )" + numberText(symmetry.offset);
    if (!symmetry.lines.empty()) {
      text += R"(, "lines": )" + indicesText(symmetry.lines);
    }
    return text + "}";
  }
  std::string pairs;
  for (const auto& [line, image] : symmetry.pairs) {
    pairs += (pairs.empty() ? "" : ", ") + indicesText({line, image});
  }
  return R"({"kind": "translation", "vector": )" + vectorText(symmetry.vector) + R"(, "pairs": [)" +
         pairs + "]}";
}

std::string boxText(const KeepOut& box) {
  return R"({"min": )" + vectorText(box.min) + R"(, "max": )" + vectorText(box.max) + "}";
}

//! `,\n  "key": [` with one element a line; nothing at all for an empty list.
template <typename T, typename ToText>
std::string listText(const std::string& key, const std::vector<T>& list, ToText toText) {
  std::string text;
  for (const T& element : list) {
    text += (text.empty() ? "\n    " : ",\n    ") + toText(element);
  }
  return list.empty() ? "" : ",\n  \"" + key + "\": [" + text + "\n  ]";
}

}  // namespace

std::string writeSketch(const Sketch& sketch) {
  const bool latest = std::any_of(sketch.joints.begin(), sketch.joints.end(), [](const Joint& j) {
    return j.range.has_value();
  });
  std::string text = "{\n  \"format\": \"technic-sketch\",\n  \"version\": ";
  text += latest ? "2" : "1";
  if (!sketch.name.empty()) {
    text +=
        ",\n  \"name\": " + json(sketch.name).dump(-1, ' ', false, json::error_handler_t::replace);
  }
  text += listText("lines", sketch.lines, lineText);
  text += listText("joints", sketch.joints, jointText);
  text += listText("symmetries", sketch.symmetries, symmetryText);
  text += listText("keepOut", sketch.keepOut, boxText);
  if (sketch.ground.has_value()) {
    text += ",\n  \"ground\": " + numberText(*sketch.ground);
  }
  return text + "\n}\n";
}

}  // namespace liftarm::sketch
