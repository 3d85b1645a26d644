#include "design/paint.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/coverage.h"
#include "analysis/scene.h"
#include "parts/catalogue.h"

namespace liftarm::design {

namespace {

using parts::PartClass;

// LDraw codes.
constexpr int kBlack = 0;
constexpr int kBlue = 1;
constexpr int kRed = 4;
constexpr int kYellow = 14;
constexpr int kWhite = 15;
constexpr int kLightGrey = 71;
constexpr int kDarkGrey = 72;

constexpr std::array<int, 6> kOfComponents{kYellow, kRed, kBlue, kLightGrey, kWhite, kBlack};

constexpr int kLong = 11;   // holes
constexpr int kMiddle = 7;  // holes

//! Whether a beam has the thickness and the holes of a plain one: the others come in few colours.
bool isPlain(const parts::Part& part) {
  return part.partClass == PartClass::kBeam && part.features.size() > 1;
}

int byLength(const parts::Part& part) {
  if (part.holes == 0) {
    return kDarkGrey;
  }
  if (part.holes >= kLong) {
    return kYellow;
  }
  return part.holes >= kMiddle ? kBlue : kRed;
}

std::string kindOf(const parts::Part& part) {
  switch (part.partClass) {
    case PartClass::kBeam:
      return part.holes == 0 && part.features.size() > 1 ? "bent" : "beam";
    case PartClass::kPin:
      return "pin";
    case PartClass::kAxle:
      return "axle";
    case PartClass::kConnector:
      return "connector";
    case PartClass::kBush:
      return "bush";
    case PartClass::kGear:
      return "gear";
  }
  return "";
}

int schemeColour(const std::string& scheme,
                 const parts::Part& part,
                 const model::PlacedPart& placed) {
  if (scheme == "usual" || !isPlain(part)) {
    return part.color;
  }
  if (scheme == "component" && placed.component >= 0) {
    return kOfComponents[static_cast<std::size_t>(placed.component) % kOfComponents.size()];
  }
  return byLength(part);
}

//! The colour of the line that each beam covers most of, among those with one.
std::map<int, int> coloursByLine(const sketch::SketchColours& colours, const model::Model& model) {
  std::map<int, int> result;
  if (colours.lines.empty()) {
    return result;
  }
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  std::map<int, std::map<int, int>> modules;  // part, line
  for (const analysis::EdgeCover& edge : analysis::findCoverage(scene)) {
    for (const analysis::Cover& cover : edge.covers) {
      ++modules[cover.part][edge.line];
    }
  }
  for (const auto& [part, ofLine] : modules) {
    int most = 0;
    for (const auto& [line, count] : ofLine) {
      const auto colour = colours.lines.find(line);
      if (colour != colours.lines.end() && count > most) {
        most = count;
        result[part] = colour->second;
      }
    }
  }
  return result;
}

//! The colour of a part that has one of its own.
std::optional<int> ownColour(const sketch::SketchColours& colours,
                             const model::PlacedPart& placed) {
  constexpr double kHere = 0.01;  // modules
  for (const sketch::PaintedPart& painted : colours.parts) {
    if (painted.part == placed.part && lattice::length(painted.at - placed.pose.position) < kHere) {
      return painted.colour;
    }
  }
  return std::nullopt;
}

}  // namespace

void paint(const sketch::SketchColours& colours, model::Model& model) {
  const std::map<int, int> byLine = coloursByLine(colours, model);
  const std::string scheme = colours.scheme.value_or("length");
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    model::PlacedPart& placed = model.parts[i];
    const parts::Part* part = parts::Catalogue::builtIn().find(placed.part);
    if (part == nullptr) {
      continue;
    }
    const auto ofLine = byLine.find(static_cast<int>(i));
    const auto ofKind = colours.kinds.find(kindOf(*part));
    if (const std::optional<int> own = ownColour(colours, placed)) {
      placed.color = *own;
    } else if (ofLine != byLine.end()) {
      placed.color = ofLine->second;
    } else if (ofKind != colours.kinds.end()) {
      placed.color = ofKind->second;
    } else if (colours.standard.has_value() && part->partClass == PartClass::kBeam) {
      placed.color = *colours.standard;
    } else {
      placed.color = schemeColour(scheme, *part, placed);
    }
  }
}

int countUnusualColours(const model::Model& model) {
  int count = 0;
  for (const model::PlacedPart& placed : model.parts) {
    const parts::Part* part = parts::Catalogue::builtIn().find(placed.part);
    count += part != nullptr && part->color != placed.color ? 1 : 0;
  }
  return count;
}

}  // namespace liftarm::design
