#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "analysis/well_built_items.h"
#include "sketch/arrangement.h"
#include "sketch/point_symmetry.h"

namespace liftarm::analysis {

namespace {

using lattice::Cell;
using lattice::Mat3;
using lattice::Vec3;
using sketch::PointIsometry;

constexpr double kSame = 0.06;  // modules; snapping may leave most of it

double determinant(const Mat3& a) {
  const Vec3 x{a.m[0], a.m[3], a.m[6]};
  const Vec3 y{a.m[1], a.m[4], a.m[7]};
  const Vec3 z{a.m[2], a.m[5], a.m[8]};
  return lattice::dot(lattice::cross(x, y), z);
}

bool isMirror(const Mat3& a) {
  constexpr double kExact = 1e-3;
  return determinant(a) < 0.0 && std::abs(a.m[0] + a.m[4] + a.m[8] - 1.0) < kExact;
}

bool isRotation(const Mat3& a) {
  return determinant(a) > 0.0;
}

//! What a beam is to the eye: where its holes are.
struct Holes {
  int part = -1;
  Vec3 middle;
  std::vector<Vec3> at;
};

std::vector<Holes> holesOfBeams(const Scene& scene) {
  std::vector<Holes> beams;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const parts::Part* part = scene.parts[i].part;
    if (part == nullptr || part->partClass != parts::PartClass::kBeam ||
        part->features.size() < 2) {
      continue;
    }
    Holes beam;
    beam.part = static_cast<int>(i);
    for (const parts::Feature& feature : part->features) {
      beam.at.push_back(scene.model->parts[i].pose.apply(feature.center));
      beam.middle = beam.middle + beam.at.back();
    }
    beam.middle = (1.0 / static_cast<double>(beam.at.size())) * beam.middle;
    beams.push_back(std::move(beam));
  }
  return beams;
}

//! Beams by where their middles are.
class BeamIndex {
 public:
  explicit BeamIndex(const std::vector<Holes>& beams) {
    for (const Holes& beam : beams) {
      cells_[cellOf(beam.middle)].push_back(&beam);
    }
  }

  //! Whether a beam's image under a map is there.
  [[nodiscard]] bool has(const Holes& beam, const PointIsometry& map) const {
    const Vec3 middle = map.apply(beam.middle);
    const Cell low = cellOf(middle - Vec3{kSame, kSame, kSame});
    const Cell high = cellOf(middle + Vec3{kSame, kSame, kSame});
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int z = low.z; z <= high.z; ++z) {
          const auto cell = cells_.find({x, y, z});
          if (cell != cells_.end() &&
              std::any_of(cell->second.begin(), cell->second.end(), [&](const Holes* other) {
                return isImage(beam, *other, map);
              })) {
            return true;
          }
        }
      }
    }
    return false;
  }

 private:
  static Cell cellOf(Vec3 p) {
    const auto cell = [](double v) { return static_cast<int>(std::floor(v)); };
    return {cell(p.x), cell(p.y), cell(p.z)};
  }

  static bool isImage(const Holes& beam, const Holes& other, const PointIsometry& map) {
    return beam.at.size() == other.at.size() &&
           std::all_of(beam.at.begin(), beam.at.end(), [&](Vec3 hole) {
             const Vec3 image = map.apply(hole);
             return std::any_of(other.at.begin(), other.at.end(), [&](Vec3 p) {
               return lattice::length(p - image) < kSame;
             });
           });
  }

  std::map<Cell, std::vector<const Holes*>> cells_;
};

std::vector<PointIsometry> judgedMaps(const sketch::Sketch& sketch) {
  const std::vector<PointIsometry> all = sketch::pointSymmetries(sketch::arrange(sketch), -1);
  for (const auto& wanted : {isMirror, isRotation}) {
    std::vector<PointIsometry> kept;
    std::copy_if(all.begin(), all.end(), std::back_inserter(kept), [&](const PointIsometry& map) {
      return wanted(map.linear);
    });
    if (!kept.empty()) {
      return kept;
    }
  }
  return {};
}

}  // namespace

WellBuiltItem judgeSymmetry(const WellBuiltQuery& query) {
  WellBuiltItem item;
  item.id = "symmetric";
  item.title = "Alike on both sides";
  const std::vector<Holes> beams = holesOfBeams(query.scene);
  const std::vector<PointIsometry> maps = query.scene.sketch.has_value()
                                              ? judgedMaps(*query.scene.sketch)
                                              : std::vector<PointIsometry>();
  item.applies = !maps.empty() && !beams.empty();
  if (!item.applies) {
    item.detail = "the drawing is not symmetric";
    return item;
  }
  const BeamIndex index(beams);
  std::vector<int> best(beams.size() + 1);  // beams without an image, under the best map
  int full = 0;
  for (const PointIsometry& map : maps) {
    std::vector<int> alone;
    for (const Holes& beam : beams) {
      if (!index.has(beam, map)) {
        alone.push_back(beam.part);
      }
    }
    full += alone.empty() ? 1 : 0;
    if (alone.size() < best.size()) {
      best = std::move(alone);
    }
  }
  const auto all = static_cast<double>(beams.size());
  const double mirrored = all - static_cast<double>(best.size());
  item.ok = mirrored >= kLeastMirrored * all;
  item.detail = std::to_string(beams.size() - best.size()) + " of " + std::to_string(beams.size()) +
                " beams have their image on the other side; " + std::to_string(full) + " of " +
                std::to_string(maps.size()) + " symmetries of the drawing are kept";
  item.figures = {{"mirroredBeams", mirrored},
                  {"beams", all},
                  {"symmetriesKept", full},
                  {"symmetries", static_cast<double>(maps.size())}};
  for (const int part : best) {
    const Vec3 at = query.scene.model->parts[static_cast<std::size_t>(part)].pose.position;
    item.places.push_back({"lopsided",
                           nameOf(query.scene, part) + " has nothing like it on the other side",
                           at,
                           {part}});
  }
  return item;
}

}  // namespace liftarm::analysis
