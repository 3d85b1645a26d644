#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "analysis/well_built_items.h"
#include "model/number_text.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

double distanceTo(const sketch::Line& line, Vec3 p) {
  const Vec3 along = line.to - line.from;
  const double t =
      std::clamp(lattice::dot(p - line.from, along) / lattice::dot(along, along), 0.0, 1.0);
  return lattice::length(p - line.from - t * along);
}

//! The lines that may be the nearest to some point within a sphere.
std::vector<const sketch::Line*> linesNear(const std::vector<sketch::Line>& lines,
                                           Vec3 centre,
                                           double radius) {
  std::vector<double> distances;
  distances.reserve(lines.size());
  for (const sketch::Line& line : lines) {
    distances.push_back(distanceTo(line, centre));
  }
  const double nearest = *std::min_element(distances.begin(), distances.end());
  std::vector<const sketch::Line*> result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (distances[i] <= nearest + 2 * radius) {
      result.push_back(&lines[i]);
    }
  }
  return result;
}

//! How far the middle of a part's farthest module lies from the drawing.
double farthestModule(const ScenePart& part, const std::vector<sketch::Line>& lines) {
  if (part.box.empty()) {
    return 0.0;
  }
  const Vec3 centre = 0.5 * (part.box.min + part.box.max);
  const double radius = 0.5 * lattice::length(part.box.max - part.box.min);
  const std::vector<const sketch::Line*> near = linesNear(lines, centre, radius);
  double farthest = 0.0;
  for (const Shape& shape : part.shapes) {
    for (const Vec3 p : {shape.prism.from, shape.prism.to}) {
      double nearest = distanceTo(*near.front(), p);
      for (const sketch::Line* line : near) {
        nearest = std::min(nearest, distanceTo(*line, p));
      }
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

//! Layers that beams lie off, added up over the modules that they stand for.
struct Layers {
  double sum = 0.0;
  int modules = 0;
};

}  // namespace

WellBuiltItem judgeFaithful(const WellBuiltQuery& query) {
  WellBuiltItem item;
  item.id = "faithful";
  item.title = "Looks like the drawing";
  if (query.coverage.empty()) {
    item.applies = false;
    item.detail = "no drawing to compare with";
    return item;
  }
  Layers all;
  std::map<int, Layers> ofPart;
  for (const EdgeCover& edge : query.coverage) {
    for (const Cover& cover : edge.covers) {
      for (Layers* layers : {&all, &ofPart[cover.part]}) {
        layers->sum += std::abs(cover.layer);
        ++layers->modules;
      }
    }
  }
  const double mean = all.modules > 0 ? all.sum / all.modules : 0.0;
  item.ok = mean < kMostMeanLayer;
  constexpr double kFarOff = 1.5;  // layers that light a beam up
  for (const auto& [part, layers] : ofPart) {
    const double off = layers.sum / layers.modules;
    if (off > kFarOff) {
      const Vec3 at = query.scene.model->parts[static_cast<std::size_t>(part)].pose.position;
      item.places.push_back({"farOff",
                             nameOf(query.scene, part) + " lies " + model::numberText(off, 1) +
                                 " layers off its line",
                             at,
                             {part}});
    }
  }
  double farthest = 0.0;
  for (const ScenePart& part : query.scene.parts) {
    farthest = std::max(farthest, farthestModule(part, query.scene.sketch->lines));
  }
  const std::string most = model::numberText(farthest, 1);
  item.detail = "beams lie " + model::numberText(mean, 2) +
                " layers off their lines on average, nothing sticks out more than " + most +
                (most == "1" ? " module" : " modules");
  item.figures = {{"meanLayer", mean}, {"greatestProtrusion", farthest}};
  return item;
}

}  // namespace liftarm::analysis
