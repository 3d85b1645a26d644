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

constexpr double kAlike = 0.06;      // modules; snapping may leave most of it
constexpr double kMostLayers = 4.0;  // between beams that stand for one line

bool isMirror(const Mat3& a) {
  constexpr double kExact = 1e-3;
  return lattice::determinant(a) < 0.0 && std::abs(a.m[0] + a.m[4] + a.m[8] - 1.0) < kExact;
}

bool isRotation(const Mat3& a) {
  return lattice::determinant(a) > 0.0;
}

bool isHalfTurn(const Mat3& a) {
  return isRotation(a) && lattice::length(a * (a * Vec3{1, 2, 3}) - Vec3{1, 2, 3}) < kAlike;
}

//! What a beam is to the eye: where its holes are, and across which direction it is flat.
struct Holes {
  int part = -1;
  Vec3 middle;
  Vec3 flat;  // the axis of most of its holes
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
    beam.flat = scene.model->parts[i].pose.rotation * part->features.front().axis;
    beams.push_back(std::move(beam));
  }
  return beams;
}

double nearestHole(const Holes& beam, Vec3 p) {
  double best = lattice::length(beam.at.front() - p);
  for (const Vec3& hole : beam.at) {
    best = std::min(best, lattice::length(hole - p));
  }
  return best;
}

//! Whether all holes but one are their own images: an odd number of them across a mirror that is
//! half a module off the holes.
bool isOffByOne(const Holes& beam, const PointIsometry& map) {
  std::size_t own = 0;
  double most = 0.0;
  for (const Vec3& hole : beam.at) {
    const double distance = nearestHole(beam, map.apply(hole));
    own += distance < kAlike ? 1 : 0;
    most = std::max(most, distance);
  }
  return own + 1 == beam.at.size() && std::abs(most - 1.0) < kAlike;
}

//! Whether a beam and its own image would be at one place, across each other.
bool meetsItsImage(const Holes& beam, const PointIsometry& map) {
  const Vec3 step = beam.at[1] - beam.at[0];
  const Vec3 image = map.apply(beam.at[1]) - map.apply(beam.at[0]);
  return lattice::length(lattice::cross(image, step)) > kAlike &&
         std::any_of(beam.at.begin(), beam.at.end(), [&](Vec3 hole) {
           return nearestHole(beam, map.apply(hole)) < 1.0 - kAlike;
         });
}

//! Whether two beams stand for one line of the drawing, on whatever layers.
bool areInLine(const Holes& a, const Holes& b) {
  const Vec3 step = a.at[1] - a.at[0];
  const Vec3 apart = b.middle - a.middle;
  const Vec3 across = apart - lattice::dot(apart, step) * step;
  return lattice::length(lattice::cross(step, b.at[1] - b.at[0])) < kAlike &&
         lattice::length(lattice::cross(a.flat, b.flat)) < kAlike &&
         lattice::length(across - lattice::dot(across, a.flat) * a.flat) < kAlike &&
         lattice::length(across) < kMostLayers + kAlike;
}

//! By beam: how far from its image's place it may lie where no two beams can lie as the map has
//! them; nothing where they can. \details A beam has an odd number of holes. Across a mirror that
//! is half a module off its holes it has one more on one side: its image is its own, moved by one.
//! And beams that meet in the mirror cannot both lie on one layer there: they pass each other, with
//! all that is in line with them.
std::vector<Vec3> givesOf(const std::vector<Holes>& beams, const PointIsometry& map) {
  std::vector<Vec3> gives(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (isOffByOne(beams[i], map)) {
      gives[i] = beams[i].at[1] - beams[i].at[0];
    } else if (meetsItsImage(beams[i], map)) {
      for (std::size_t k = 0; k < beams.size(); ++k) {
        if (areInLine(beams[i], beams[k])) {
          gives[k] = beams[k].flat;
        }
      }
    }
  }
  return gives;
}

//! Beams by where their middles are.
class BeamIndex {
 public:
  explicit BeamIndex(const std::vector<Holes>& beams) {
    for (const Holes& beam : beams) {
      cells_[cellOf(beam.middle)].push_back(&beam);
    }
  }

  //! Whether a beam's image under a map is there, or as near as can be.
  [[nodiscard]] bool has(const Holes& beam, const PointIsometry& map, Vec3 give) const {
    return hasAt(beam, map, {}) || hasAt(beam, map, give) || hasAt(beam, map, -1.0 * give);
  }

 private:
  static Cell cellOf(Vec3 p) {
    const auto cell = [](double v) { return static_cast<int>(std::floor(v)); };
    return {cell(p.x), cell(p.y), cell(p.z)};
  }

  [[nodiscard]] bool hasAt(const Holes& beam, const PointIsometry& map, Vec3 shift) const {
    const Vec3 middle = map.apply(beam.middle) + shift;
    const Cell low = cellOf(middle - Vec3{kAlike, kAlike, kAlike});
    const Cell high = cellOf(middle + Vec3{kAlike, kAlike, kAlike});
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int z = low.z; z <= high.z; ++z) {
          const auto cell = cells_.find({x, y, z});
          if (cell != cells_.end() &&
              std::any_of(cell->second.begin(), cell->second.end(), [&](const Holes* other) {
                return isImage(beam, *other, map, shift);
              })) {
            return true;
          }
        }
      }
    }
    return false;
  }

  static bool isImage(const Holes& beam, const Holes& other, const PointIsometry& map, Vec3 shift) {
    return beam.at.size() == other.at.size() &&
           std::all_of(beam.at.begin(), beam.at.end(), [&](Vec3 hole) {
             const Vec3 image = map.apply(hole) + shift;
             return std::any_of(other.at.begin(), other.at.end(), [&](Vec3 p) {
               return lattice::length(p - image) < kAlike;
             });
           });
  }

  std::map<Cell, std::vector<const Holes*>> cells_;
};

//! Whether beams with holes along X, Y or Z can stand for each line that a map brings onto itself.
bool canBeObeyed(const sketch::Sketch& sketch, const PointIsometry& map) {
  return std::all_of(sketch.lines.begin(), sketch.lines.end(), [&](const sketch::Line& line) {
    const Vec3 from = map.apply(line.from);
    const Vec3 to = map.apply(line.to);
    const auto near = [](Vec3 a, Vec3 b) { return lattice::length(a - b) < kAlike; };
    if (!(near(from, line.from) && near(to, line.to)) &&
        !(near(from, line.to) && near(to, line.from))) {
      return true;
    }
    const Vec3 direction = lattice::normalized(line.to - line.from);
    for (int i = 0; i < 3; ++i) {
      const Vec3 axis = lattice::unitVector(lattice::axisFromIndex(i));
      const Vec3 image = map.linear * axis;
      if (std::abs(lattice::dot(axis, direction)) < kAlike &&
          std::abs(lattice::dot(axis, image)) > 1.0 - kAlike) {
        return true;
      }
    }
    return false;
  });
}

//! Mirrors; where there are none, rotations. Lines that cross in each of the mirrors are no two
//! beams on one layer: half-turns of such a drawing count beside them.
std::vector<PointIsometry> judgedMaps(const sketch::Sketch& sketch) {
  const sketch::Arrangement arrangement = sketch::arrange(sketch);
  const std::vector<PointIsometry> all = sketch::pointSymmetries(arrangement, -1);
  const auto obeyed = [&](const auto& wanted) {
    std::vector<PointIsometry> kept;
    std::copy_if(all.begin(), all.end(), std::back_inserter(kept), [&](const PointIsometry& map) {
      return wanted(map.linear) && canBeObeyed(sketch, map);
    });
    return kept;
  };
  std::vector<PointIsometry> maps = obeyed(isMirror);
  if (maps.empty()) {
    return obeyed(isRotation);
  }
  if (std::all_of(maps.begin(), maps.end(), [&](const PointIsometry& map) {
        return sketch::crossesItself(arrangement, map);
      })) {
    const std::vector<PointIsometry> turns = obeyed(isHalfTurn);
    maps.insert(maps.end(), turns.begin(), turns.end());
  }
  return maps;
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
    const std::vector<Vec3> gives = givesOf(beams, map);
    std::vector<int> alone;
    for (std::size_t i = 0; i < beams.size(); ++i) {
      if (!index.has(beams[i], map, gives[i])) {
        alone.push_back(beams[i].part);
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
