#include "sketch/sketch_json.h"

#include <algorithm>
#include <cmath>

#include "base/plain_text.h"
#include "sketch/annotation_reader.h"
#include "sketch/closings.h"
#include "sketch/json_fields.h"
#include "sketch/json_text.h"
#include "sketch/keep_json.h"
#include "sketch/shaft_json.h"
#include "sketch/sketch_checks.h"
#include "sketch/sketch_colours.h"
#include "sketch/snap.h"

namespace liftarm::sketch {

namespace {

using nlohmann::json;

constexpr std::string_view kFormat = "technic-sketch";
constexpr double kVersion = 1;
// Adds colours, what joints must do, what turns and what is to stay.
constexpr double kLatestVersion = 2;

//! Reads the members of a document into a sketch, in the order in which a person would.
class SketchReader {
 public:
  explicit SketchReader(const json& document) : document_(document) {}

  base::Result<Reading> read() {
    if (!readHead() || !readLines() || !readAnnotations(document_, fields_, sketch_) ||
        !checkKeeps() || !checkShafts() || !checkColours()) {
      return fields_.error();
    }
    std::vector<Line> drawn = sketch_.lines;
    if (!settle()) {
      return fields_.error();
    }
    return Reading{std::move(sketch_), std::move(drawn)};
  }

 private:
  bool readHead() {
    if (!document_.is_object()) {
      return fields_.fail("", "not a sketch: expected an object with format, version and lines");
    }
    const json* const format =
        fields_.required(document_, "format", "", "\"" + std::string(kFormat) + "\"");
    if (format == nullptr) {
      return false;
    }
    std::string name;
    if (!fields_.text(*format, "format", name)) {
      return false;
    }
    if (name != kFormat) {
      return fields_.fail("format",
                          inQuotes(name) + " is not known; expected " + inQuotes(kFormat));
    }
    const json* const version = fields_.required(document_, "version", "", "1");
    double number = 0.0;
    if (version == nullptr || !fields_.number(*version, "version", 1e9, number)) {
      return false;
    }
    if (number != kVersion && number != kLatestVersion) {
      return fields_.fail("version", shortNumber(number) + " is not known; expected 1 or 2");
    }
    return checkKeys(number == kLatestVersion) && readName();
  }

  bool checkKeys(bool latest) {
    return latest ? fields_.object(document_,
                                   "",
                                   {"format",
                                    "version",
                                    "name",
                                    "lines",
                                    "joints",
                                    "symmetries",
                                    "keepOut",
                                    "ground",
                                    "shafts",
                                    "drives",
                                    "keep",
                                    "colours"})
                  : fields_.object(document_,
                                   "",
                                   {"format",
                                    "version",
                                    "name",
                                    "lines",
                                    "joints",
                                    "symmetries",
                                    "keepOut",
                                    "ground"});
  }

  //! The search knows nothing of colours; whoever paints reads them again (sketch_colours.h).
  bool checkColours() {
    SketchColours colours;
    return readColours(document_, fields_, static_cast<int>(sketch_.lines.size()), colours);
  }

  //! Whoever searches reads again what is to stay (keep_json.h).
  bool checkKeeps() {
    Keeps keeps;
    return readKeeps(document_, fields_, sketch_, keeps);
  }

  //! Whoever lays gears reads again what turns (shaft_json.h).
  bool checkShafts() {
    Shafts shafts;
    return readShafts(document_, fields_, shafts);
  }

  bool readName() {
    const auto name = document_.find("name");
    if (name == document_.end()) {
      return true;
    }
    if (!fields_.text(*name, "name", sketch_.name)) {
      return false;
    }
    if (sketch_.name.size() > kMaxNameBytes) {
      return fields_.fail("name", "longer than " + std::to_string(kMaxNameBytes) + " bytes");
    }
    return base::plainText(sketch_.name) == sketch_.name ||
           fields_.fail("name", "holds a line break or another control character");
  }

  bool readLines() {
    const json* const lines = fields_.required(document_, "lines", "", "an array of lines");
    if (lines == nullptr || !fields_.array(*lines, "lines", "lines")) {
      return false;
    }
    if (lines->empty()) {
      return fields_.fail("lines", "empty; a sketch has at least one line");
    }
    double total = 0.0;
    sketch_.lines.reserve(lines->size());
    for (std::size_t i = 0; i < lines->size(); ++i) {
      if (!readLine((*lines)[i], elementPlace("lines", i))) {
        return false;
      }
      total += sketch_.lines.back().length;
    }
    if (total > kMaxTotalLength) {
      return fields_.fail("lines",
                          "together " + shortNumber(total) + " modules long; at most " +
                              std::to_string(kMaxTotalLength) + " are read");
    }
    return true;
  }

  bool readLine(const json& value, const std::string& place) {
    Line line;
    if (!fields_.object(value, place, {"from", "to", "exact", "holeAxis"})) {
      return false;
    }
    const json* const from = fields_.required(value, "from", place, "three numbers [x, y, z]");
    const json* const to = fields_.required(value, "to", place, "three numbers [x, y, z]");
    if (from == nullptr || to == nullptr ||
        !fields_.vector(*from, memberPlace(place, "from"), kMaxCoordinate, line.from) ||
        !fields_.vector(*to, memberPlace(place, "to"), kMaxCoordinate, line.to)) {
      return false;
    }
    const auto exact = value.find("exact");
    if (exact != value.end() && !fields_.boolean(*exact, memberPlace(place, "exact"), line.exact)) {
      return false;
    }
    const auto holeAxis = value.find("holeAxis");
    if (holeAxis != value.end() &&
        !fields_.axis(*holeAxis, memberPlace(place, "holeAxis"), line.holeAxis.emplace())) {
      return false;
    }
    if (!checkLine(line, place, fields_) || !checkHoleAxis(line, place, fields_)) {
      return false;
    }
    sketch_.lines.push_back(line);
    return true;
  }

  //! Snaps the lines and takes along what was drawn at their nodes.
  bool settle() {
    JointNodes jointNodes;
    if (!checkJoints(sketch_, fields_, jointNodes)) {
      return false;
    }
    const double lowestDrawn = lowestEnd();
    const bool stands =
        sketch_.ground.has_value() && std::abs(*sketch_.ground - lowestDrawn) <= kStanding;
    const SnapReport snapped = snapToWholeLengths(sketch_.lines);
    sketch_.residual = snapped.residual;
    if (!isSnapped(snapped.residual)) {
      const auto worst = static_cast<std::size_t>(snapped.worstLine);
      return fields_.fail(elementPlace("lines", worst),
                          "cannot have length " + std::to_string(sketch_.lines[worst].length) +
                              " together with the lines that it touches; it stays " +
                              shortNumber(snapped.residual) + " off" +
                              closingsText(sketch_.lines[worst]));
    }
    if (stands) {
      sketch_.ground = lowestEnd();
    }
    for (std::size_t i = 0; i < sketch_.joints.size(); ++i) {
      const Line& line = sketch_.lines[static_cast<std::size_t>(jointNodes.line[i])];
      sketch_.joints[i].at = nodeOfLine(line, jointNodes.index[i]);
    }
    return checkHoleAxesAgree(sketch_, fields_);
  }

  [[nodiscard]] double lowestEnd() const {
    double lowest = kMaxCoordinate;
    for (const Line& line : sketch_.lines) {
      lowest = std::min({lowest, line.from.z, line.to.z});
    }
    return lowest;
  }

  static constexpr double kStanding = 1e-6;  // modules between a ground and what stands on it

  const json& document_;
  FieldReader fields_;
  Sketch sketch_;
};

}  // namespace

base::Result<Sketch> readSketch(std::string_view text) {
  base::Result<Reading> reading = readDrawing(text);
  if (!reading.ok()) {
    return reading.error();
  }
  return std::move(reading).value().sketch;
}

base::Result<Reading> readDrawing(std::string_view text) {
  const auto refuse = [](const std::string& message) {
    return base::Error{base::Status::kInvalidInput, message};
  };
  if (text.size() > kMaxSketchBytes) {
    return refuse("the file has " + std::to_string(text.size()) + " bytes; at most " +
                  std::to_string(kMaxSketchBytes) + " are read");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return refuse("the file is empty; expected a sketch in JSON");
  }
  JsonLimits limits;
  limits.countedKey = "lines";
  limits.maxCounted = kMaxLines;
  const base::Result<json> document = parseJsonText(text, limits);
  if (!document.ok()) {
    return document.error();
  }
  return SketchReader(document.value()).read();
}

}  // namespace liftarm::sketch
