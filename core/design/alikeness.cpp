#include "design/alikeness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>

#include "layout/beam.h"
#include "sketch/point_symmetry.h"
#include "sketch/symmetry_finder.h"

namespace liftarm::design {

namespace {

using lattice::Vec3;
using sketch::PointIsometry;

constexpr double kSame = 0.06;  // modules; snapping may leave most of it
constexpr double kAlong = 1e-6;

//! A beam's line of holes.
struct HoleLine {
  int run = -1;
  Vec3 first;
  Vec3 last;
  Vec3 holeAxis;
  int holes = 0;

  [[nodiscard]] Vec3 middle() const { return 0.5 * (first + last); }
};

std::vector<HoleLine> holeLines(const layout::LayoutProblem& problem,
                                const search::LayoutSnapshot& layout) {
  std::vector<HoleLine> lines;
  for (std::size_t r = 0; r < layout.covers.size(); ++r) {
    const layout::Cover& cover = layout.covers[r];
    const guide::GuideRun& run = problem.graph.runs[r];
    for (const layout::Beam& beam : cover.beams) {
      const auto at = [&](int index) {
        return layout::holePosition(problem.graph, run, cover.axis, index, beam.layer);
      };
      lines.push_back({static_cast<int>(r),
                       at(beam.start),
                       at(beam.last()),
                       lattice::unitVector(cover.axis),
                       beam.holes});
    }
  }
  return lines;
}

bool near(Vec3 a, Vec3 b) {
  return lattice::length(a - b) < kSame;
}

//! The same holes, from either end.
bool isSame(const HoleLine& a, const HoleLine& b, Vec3 shift) {
  return a.holes == b.holes && ((near(a.first, b.first + shift) && near(a.last, b.last + shift)) ||
                                (near(a.first, b.last + shift) && near(a.last, b.first + shift)));
}

HoleLine imageOf(const HoleLine& beam, const PointIsometry& map) {
  return {beam.run, map.apply(beam.first), map.apply(beam.last), beam.holeAxis, beam.holes};
}

Vec3 stepOf(const HoleLine& beam) {
  return (1.0 / std::max(1, beam.holes - 1)) * (beam.last - beam.first);
}

//! Whether two beams have a place in common, about.
bool meet(const HoleLine& a, const HoleLine& b) {
  const Vec3 stepA = stepOf(a);
  const Vec3 stepB = stepOf(b);
  for (int i = 0; i < a.holes; ++i) {
    for (int k = 0; k < b.holes; ++k) {
      if (lattice::length(a.first + i * stepA - b.first - k * stepB) < 1.0 - kSame) {
        return true;
      }
    }
  }
  return false;
}

//! By beam: how far its image may lie from where the map has it: nowhere else, or, where two beams
//! cannot lie so, a module to either side, with all beams of its run.
std::vector<Vec3> givesOf(const std::vector<HoleLine>& beams, const PointIsometry& map) {
  std::vector<Vec3> gives(beams.size());
  std::set<int> passing;  // runs that meet their images
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const HoleLine image = imageOf(beams[i], map);
    const Vec3 along = stepOf(beams[i]);
    if (isSame(beams[i], image, along) || isSame(beams[i], image, -1.0 * along)) {
      gives[i] = along;
    } else if (lattice::length(lattice::cross(stepOf(image), along)) > kSame &&
               meet(beams[i], image)) {
      passing.insert(beams[i].run);
    }
  }
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (passing.count(beams[i].run) > 0) {
      gives[i] = beams[i].holeAxis;
    }
  }
  return gives;
}

double shareUnder(const PointIsometry& map, const std::vector<HoleLine>& beams) {
  std::multimap<long, const HoleLine*> byPlace;
  const auto key = [](Vec3 p) { return std::lround(p.x + p.y + p.z); };
  for (const HoleLine& beam : beams) {
    byPlace.emplace(key(beam.middle()), &beam);
  }
  const std::vector<Vec3> gives = givesOf(beams, map);
  std::size_t found = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const HoleLine image = imageOf(beams[i], map);
    const Vec3 give = gives[i];
    const long place = key(image.middle());
    const auto low = byPlace.lower_bound(place - 2);
    const auto high = byPlace.upper_bound(place + 2);
    found += std::any_of(low, high, [&](const auto& entry) {
      const HoleLine& other = *entry.second;
      return isSame(other, image, {}) || isSame(other, image, give) ||
             isSame(other, image, -1.0 * give);
    });
  }
  return beams.empty() ? 1.0 : static_cast<double>(found) / static_cast<double>(beams.size());
}

//! Across X or Y. Diagonal mirrors swap hole axes and contradict those.
bool isSideways(const sketch::Symmetry& mirror) {
  const Vec3 normal = mirror.normal;
  return std::abs(normal.x) > 1.0 - kAlong || std::abs(normal.y) > 1.0 - kAlong;
}

}  // namespace

std::vector<sketch::Symmetry> wishedSymmetries(const sketch::Sketch& sketch) {
  const sketch::FoundSymmetries found = sketch::findSymmetries(sketch);
  std::vector<sketch::Symmetry> mirrors;
  std::copy_if(found.symmetries.begin(),
               found.symmetries.end(),
               std::back_inserter(mirrors),
               [](const sketch::Symmetry& symmetry) {
                 return symmetry.kind == sketch::Symmetry::Kind::kReflection &&
                        symmetry.lines.empty();
               });
  const auto others = std::stable_partition(mirrors.begin(), mirrors.end(), isSideways);
  if (others != mirrors.begin()) {
    mirrors.erase(others, mirrors.end());
  }
  const sketch::Arrangement arrangement = sketch::arrange(sketch);
  const bool cross =
      std::all_of(mirrors.begin(), mirrors.end(), [&](const sketch::Symmetry& mirror) {
        return sketch::crossesItself(arrangement, sketch::isometryOf(mirror));
      });
  for (std::size_t i = 0; cross && i < found.rotations.size(); ++i) {
    const sketch::RotationSymmetry& rotation = found.rotations[i];
    if (rotation.order % 2 == 0) {
      sketch::Symmetry turn;
      turn.kind = sketch::Symmetry::Kind::kRotation;
      turn.normal = rotation.axis;
      turn.vector = rotation.point;
      mirrors.push_back(std::move(turn));
    }
  }
  return mirrors;
}

double alikeness(const layout::LayoutProblem& problem,
                 const search::LayoutSnapshot& layout,
                 const std::vector<sketch::Symmetry>& symmetries) {
  const std::vector<HoleLine> beams = holeLines(problem, layout);
  double best = symmetries.empty() ? 1.0 : 0.0;
  for (const sketch::Symmetry& symmetry : symmetries) {
    best = std::max(best, shareUnder(sketch::isometryOf(symmetry), beams));
  }
  return best;
}

}  // namespace liftarm::design
