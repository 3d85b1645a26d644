#include "linkages/linkage_json.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "sketch/json_fields.h"
#include "sketch/json_text.h"
#include "sketch/sketch_json.h"

namespace liftarm::linkages {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr double kFlat = 1e-6;
constexpr double kShortest = 1.0;  // modules
constexpr int kPoses = 48;
constexpr int kDrawnPoints = 96;

class PathReader {
 public:
  explicit PathReader(const json& document) : document_(document) {}

  base::Result<PathDrawing> read() {
    if (!readHead() || !readPoints() || !readPlane() || !readChoices()) {
      return fields_.error();
    }
    PathQuestion& question = drawing_.question;
    for (const lattice::Vec3& p : points_) {
      question.path.points.push_back(drawing_.plane.toPlane(p));
    }
    if (lengthOf(question.path.points, question.path.closed) < kShortest) {
      fields_.fail("points", "the path is shorter than 1 module");
      return fields_.error();
    }
    return std::move(drawing_);
  }

 private:
  bool readHead() {
    std::string format;
    double version = 0.0;
    if (!fields_.object(
            document_,
            "",
            {"format", "version", "name", "points", "closed", "kind", "turns", "plane", "most"})) {
      return false;
    }
    const json* const name = fields_.required(document_, "format", "", "\"technic-path\"");
    const json* const number = fields_.required(document_, "version", "", "1");
    if (name == nullptr || number == nullptr || !fields_.text(*name, "format", format) ||
        !fields_.number(*number, "version", 1e9, version)) {
      return false;
    }
    if (format != "technic-path") {
      return fields_.fail("format", "not a path; expected \"technic-path\"");
    }
    return version == 1.0 || fields_.fail("version", "not known; expected 1");
  }

  bool readPoints() {
    const json* const points = fields_.required(document_, "points", "", "an array of points");
    if (points == nullptr || !fields_.array(*points, "points", "points")) {
      return false;
    }
    if (points->size() < 2 || points->size() > kMaxPathPoints) {
      return fields_.fail("points",
                          std::to_string(points->size()) + " points; expected 2 to " +
                              std::to_string(kMaxPathPoints));
    }
    for (std::size_t i = 0; i < points->size(); ++i) {
      if (!fields_.vector((*points)[i],
                          sketch::elementPlace("points", i),
                          kMaxPathCoordinate,
                          points_.emplace_back())) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool isFlat(lattice::Axis axis) const {
    const int k = lattice::index(axis);
    return std::all_of(points_.begin(), points_.end(), [&](const lattice::Vec3& p) {
      return std::abs(p[k] - points_.front()[k]) < kFlat;
    });
  }

  //! As told, else y, x or z, the first that the points allow: a machine stands upright.
  bool readPlane() {
    std::optional<lattice::Axis> normal;
    const auto told = document_.find("plane");
    if (told != document_.end() && !fields_.axis(*told, "plane", normal.emplace())) {
      return false;
    }
    for (const lattice::Axis axis : {lattice::Axis::kY, lattice::Axis::kX, lattice::Axis::kZ}) {
      if (!normal.has_value() && isFlat(axis)) {
        normal = axis;
      }
    }
    if (!normal.has_value() || !isFlat(*normal)) {
      return fields_.fail("points",
                          "the path lies in no plane parallel to XY, YZ or ZX; make all points "
                          "equal in x, y or z");
    }
    drawing_.plane = {*normal, points_.front()[lattice::index(*normal)]};
    return true;
  }

  //! The text of a member, or the first of those known.
  bool choice(const char* key, std::initializer_list<const char*> known, std::size_t* chosen) {
    const auto found = document_.find(key);
    std::string name;
    *chosen = 0;
    if (found == document_.end()) {
      return true;
    }
    if (!fields_.text(*found, key, name)) {
      return false;
    }
    std::string all;
    for (const char* one : known) {
      if (name == one) {
        return true;
      }
      all += (all.empty() ? "" : ", ") + sketch::inQuotes(one);
      ++*chosen;
    }
    return fields_.fail(key, sketch::inQuotes(name) + " is not known; expected one of " + all);
  }

  bool readChoices() {
    std::size_t kind = 0;
    std::size_t turns = 0;
    if (!choice("kind", {"any", "foot", "line"}, &kind) ||
        !choice("turns", {"any", "quarter"}, &turns)) {
      return false;
    }
    PathQuestion& question = drawing_.question;
    question.kind = static_cast<PathKind>(kind);
    question.turns = static_cast<Turns>(turns);
    question.path.closed = question.kind != PathKind::kLine;
    const auto closed = document_.find("closed");
    if (closed != document_.end() && question.kind == PathKind::kAny &&
        !fields_.boolean(*closed, "closed", question.path.closed)) {
      return false;
    }
    const auto most = document_.find("most");
    double number = question.most;
    if (most != document_.end() && !fields_.number(*most, "most", kMaxAnswers, number)) {
      return false;
    }
    question.most = std::max(1, static_cast<int>(number));
    return true;
  }

  const json& document_;
  sketch::FieldReader fields_;
  std::vector<lattice::Vec3> points_;
  PathDrawing drawing_;
};

double shortened(double value) {
  return std::round(value * 1e4) / 1e4 + 0.0;
}

ordered_json pointJson(Point p) {
  return {shortened(p.u), shortened(p.v)};
}

ordered_json answerJson(const LinkageAnswer& answer, const PathPlane& plane) {
  const FourBar& bar = answer.bar;
  ordered_json found;
  found["error"] = shortened(lattice::kMillimetresPerModule * answer.match.error);
  found["largest"] = shortened(lattice::kMillimetresPerModule * answer.match.largest);
  found["transmission"] = shortened(answer.transmission);
  found["links"] = {bar.crank, shortened(bar.coupler.length), bar.rocker, bar.frame};
  for (const Point pivot : pivotsOf(answer)) {
    found["pivots"].push_back(pointJson(pivot));
  }
  for (const FourBarPose& pose : posesOf(answer, kPoses)) {
    ordered_json row = ordered_json::array();
    for (const Point p : {pose.crankPin, pose.rockerPin, pose.point}) {
      row.push_back(shortened(p.u));
      row.push_back(shortened(p.v));
    }
    found["poses"].push_back(row);
  }
  found["sketch"] = ordered_json::parse(sketch::writeSketch(sketchOf(answer, plane)));
  return found;
}

}  // namespace

base::Result<PathDrawing> readPath(std::string_view text) {
  if (text.size() > kMaxPathBytes) {
    return base::Error{base::Status::kInvalidInput,
                       "the file has " + std::to_string(text.size()) + " bytes; at most " +
                           std::to_string(kMaxPathBytes) + " are read"};
  }
  sketch::JsonLimits limits;
  limits.countedKey = "points";
  limits.maxCounted = kMaxPathPoints;
  const base::Result<json> document = sketch::parseJsonText(text, limits);
  if (!document.ok()) {
    return document.error();
  }
  return PathReader(document.value()).read();
}

base::Result<std::string> linkagesJson(const LinkageTable& table, std::string_view pathText) {
  const base::Result<PathDrawing> drawing = readPath(pathText);
  if (!drawing.ok()) {
    return drawing.error();
  }
  const PathQuestion& question = drawing.value().question;
  const PathPlane& plane = drawing.value().plane;
  ordered_json reply;
  reply["closed"] = question.path.closed;
  reply["plane"] = sketch::axisName(plane.normal);
  reply["offset"] = plane.offset;
  for (const Point p : resample(question.path.points, question.path.closed, kDrawnPoints)) {
    reply["drawn"].push_back(pointJson(p));
  }
  reply["answers"] = ordered_json::array();
  for (const LinkageAnswer& answer : table.find(question)) {
    reply["answers"].push_back(answerJson(answer, plane));
  }
  return reply.dump();
}

}  // namespace liftarm::linkages
