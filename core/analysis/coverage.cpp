#include "analysis/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/assembly.h"
#include "analysis/cover_matching.h"
#include "analysis/piece_matching.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr double kParallelCosine = 0.9998;
constexpr double kOffTolerance = 0.06;

//! A beam's covering stretch in the world.
struct WorldStretch {
  int part = -1;
  Vec3 from;
  Vec3 to;
  Vec3 holeAxis;
  bool thin = false;
  int layerSaid = 0;
  int number = 0;  // among the part's
};

std::vector<WorldStretch> stretchesOf(const Scene& scene) {
  std::vector<WorldStretch> result;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const parts::Part* part = scene.parts[i].part;
    if (part == nullptr || part->partClass != parts::PartClass::kBeam) {
      continue;
    }
    const lattice::Pose& pose = scene.model->parts[i].pose;
    for (std::size_t s = 0; s < part->stretches.size(); ++s) {
      result.push_back({static_cast<int>(i),
                        pose.apply(part->stretches[s].from),
                        pose.apply(part->stretches[s].to),
                        pose.rotation * part->solid.front().axis,
                        part->thickness < 1.0,
                        scene.model->parts[i].layer,
                        static_cast<int>(s)});
    }
  }
  return result;
}

//! Whether the offset is a layer: whole modules, or a quarter beside one for thin beams.
bool isLayer(double layer, bool thin) {
  const double shifted =
      thin ? std::abs(layer - std::floor(layer) - 0.5) - 0.25 : layer - std::floor(layer + 0.5);
  return std::abs(shifted) <= kOffTolerance;
}

//! Whether a stretch may stand for the line; fills in its layer.
bool standsFor(const WorldStretch& stretch, const sketch::Line& line, double& layer) {
  const Vec3 offset = stretch.from - line.from;
  layer = lattice::dot(offset, stretch.holeAxis);
  const double limit = line.exact ? (stretch.thin ? 0.25 : 0.0) : kMaxLayer + 0.25;
  if (std::abs(layer) > limit + kOffTolerance || !isLayer(layer, stretch.thin)) {
    return false;
  }
  return !line.holeAxis.has_value() || std::abs(lattice::dot(lattice::unitVector(*line.holeAxis),
                                                             stretch.holeAxis)) >= kParallelCosine;
}

void coverEdges(const WorldStretch& stretch, const sketch::Line& line, EdgeCover* edges) {
  // Not quite a unit where a line's length does not close with its neighbours' (sketch.residual).
  const Vec3 direction = (1.0 / line.length) * (line.to - line.from);
  const Vec3 along = stretch.to - stretch.from;
  if (std::abs(lattice::dot(direction, along)) <
      kParallelCosine * lattice::length(direction) * lattice::length(along)) {
    return;
  }
  const Vec3 offset = stretch.from - line.from;
  const Vec3 aside = offset - lattice::dot(offset, direction) * direction;
  double layer = 0.0;
  if (!standsFor(stretch, line, layer) ||
      lattice::length(aside - layer * stretch.holeAxis) > kOffTolerance) {
    return;
  }
  const double a = lattice::dot(offset, direction);
  const double b = a + lattice::dot(along, direction);
  const int first = std::max(0, static_cast<int>(std::ceil(std::min(a, b) - kOffTolerance)));
  const int last =
      std::min(line.length, static_cast<int>(std::floor(std::max(a, b) + kOffTolerance)));
  const Vec3& axis = stretch.holeAxis;
  const double forward = axis.x + axis.y + axis.z < 0 ? -layer : layer;
  const bool said = std::lround(forward) == stretch.layerSaid;
  for (int k = first; k < last; ++k) {
    const double place = std::abs(k + 0.5 - a);
    edges[k].covers.push_back({stretch.part, layer, stretch.holeAxis, said, stretch.number, place});
  }
}

}  // namespace

std::vector<EdgeCover> findCoverage(const Scene& scene) {
  std::vector<EdgeCover> edges;
  if (!scene.sketch.has_value()) {
    return edges;
  }
  const std::vector<WorldStretch> stretches = stretchesOf(scene);
  for (std::size_t l = 0; l < scene.sketch->lines.size(); ++l) {
    const sketch::Line& line = scene.sketch->lines[l];
    const Vec3 unit = (1.0 / line.length) * (line.to - line.from);
    const std::size_t begin = edges.size();
    for (int k = 0; k < line.length; ++k) {
      edges.push_back({static_cast<int>(l),
                       k,
                       line.from + static_cast<double>(k) * unit,
                       line.from + static_cast<double>(k + 1) * unit,
                       {}});
    }
    for (const WorldStretch& stretch : stretches) {
      coverEdges(stretch, line, edges.data() + begin);
    }
  }
  keepOwnCovers(findAssemblies(scene), piecesOfSketch(scene, edges), edges);
  matchCovers(edges);
  return edges;
}

}  // namespace liftarm::analysis
