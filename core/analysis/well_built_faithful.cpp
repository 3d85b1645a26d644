#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "analysis/well_built_items.h"
#include "model/number_text.h"

namespace liftarm::analysis {

namespace {

using lattice::Cell;
using lattice::Vec3;

double distanceTo(const EdgeCover& edge, Vec3 p) {
  const Vec3 along = edge.to - edge.from;
  const double t =
      std::clamp(lattice::dot(p - edge.from, along) / lattice::dot(along, along), 0.0, 1.0);
  return lattice::length(p - edge.from - t * along);
}

//! The unit edges of a sketch by the cells of kPitch modules that they begin in.
class EdgeGrid {
 public:
  explicit EdgeGrid(const std::vector<EdgeCover>& edges) {
    for (const EdgeCover& edge : edges) {
      cells_[cellOf(edge.from)].push_back(&edge);
    }
  }

  //! Distance to the nearest edge, at most `most`.
  [[nodiscard]] double distance(Vec3 p, double most) const {
    const double reach = most + 1.0;
    const Cell low = cellOf(p - Vec3{reach, reach, reach});
    const Cell high = cellOf(p + Vec3{reach, reach, reach});
    double nearest = most;
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int z = low.z; z <= high.z; ++z) {
          const auto cell = cells_.find({x, y, z});
          if (cell == cells_.end()) {
            continue;
          }
          for (const EdgeCover* edge : cell->second) {
            nearest = std::min(nearest, distanceTo(*edge, p));
          }
        }
      }
    }
    return nearest;
  }

 private:
  static constexpr double kPitch = 4.0;

  static Cell cellOf(Vec3 p) {
    const auto cell = [](double v) { return static_cast<int>(std::floor(v / kPitch)); };
    return {cell(p.x), cell(p.y), cell(p.z)};
  }

  std::map<Cell, std::vector<const EdgeCover*>> cells_;
};

struct Farthest {
  double distance = 0.0;
  Vec3 at;
};

//! The module of a part that lies farthest from the drawing.
Farthest farthestModule(const ScenePart& part, const EdgeGrid& edges) {
  constexpr double kMost = 6.0;  // further out is as bad
  Farthest farthest;
  for (const Shape& shape : part.shapes) {
    for (const Vec3 p : {shape.prism.from, shape.prism.to}) {
      const double distance = edges.distance(p, kMost);
      if (distance > farthest.distance) {
        farthest = {distance, p};
      }
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
  const EdgeGrid edges(query.coverage);
  Farthest farthest;
  for (const ScenePart& part : query.scene.parts) {
    const Farthest own = farthestModule(part, edges);
    farthest = own.distance > farthest.distance ? own : farthest;
  }
  item.detail = "beams lie " + model::numberText(mean, 2) +
                " layers off their lines on average, nothing sticks out more than " +
                model::numberText(farthest.distance, 1) + " modules";
  item.figures = {{"meanLayer", mean}, {"greatestProtrusion", farthest.distance}};
  return item;
}

}  // namespace liftarm::analysis
