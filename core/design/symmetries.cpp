#include "design/symmetries.h"

#include <nlohmann/json.hpp>

#include "design/notes_json.h"
#include "sketch/sketch_json.h"
#include "sketch/sketch_notes.h"
#include "sketch/symmetry_finder.h"

namespace liftarm::design {

namespace {

using nlohmann::ordered_json;

ordered_json vectorJson(lattice::Vec3 v) {
  return ordered_json::array({v.x, v.y, v.z});
}

ordered_json symmetryJson(const sketch::Symmetry& symmetry) {
  if (symmetry.kind == sketch::Symmetry::Kind::kTranslation) {
    ordered_json pairs = ordered_json::array();
    for (const auto& [line, image] : symmetry.pairs) {
      pairs.push_back({line, image});
    }
    return {{"kind", "translation"}, {"vector", vectorJson(symmetry.vector)}, {"pairs", pairs}};
  }
  ordered_json mirror{
      {"kind", "reflection"}, {"normal", vectorJson(symmetry.normal)}, {"offset", symmetry.offset}};
  if (!symmetry.lines.empty()) {
    mirror["lines"] = symmetry.lines;
  }
  return mirror;
}

}  // namespace

base::Result<std::string> findSymmetriesJson(std::string_view sketchJson) {
  const base::Result<sketch::Reading> reading = sketch::readDrawing(sketchJson);
  if (!reading.ok()) {
    return reading.error();
  }
  const sketch::FoundSymmetries found = sketch::findSymmetries(reading.value().sketch);
  ordered_json symmetries = ordered_json::array();
  for (const sketch::Symmetry& symmetry : found.symmetries) {
    symmetries.push_back(symmetryJson(symmetry));
  }
  for (const sketch::RotationSymmetry& rotation : found.rotations) {
    symmetries.push_back({{"kind", "rotation"},
                          {"axis", vectorJson(rotation.axis)},
                          {"point", vectorJson(rotation.point)},
                          {"order", rotation.order}});
  }
  return ordered_json{{"symmetries", symmetries},
                      {"notes", notesJson(sketch::notesOn(reading.value()))}}
      .dump();
}

}  // namespace liftarm::design
