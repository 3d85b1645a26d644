#include "objective/symmetry_measure.h"

#include <algorithm>
#include <limits>

namespace liftarm::objective {

namespace {

using lattice::Vec3;

std::vector<Vec3> holesOf(const guide::GuidingGraph& graph,
                          const std::vector<layout::Cover>& covers,
                          const std::vector<int>& runs) {
  std::vector<Vec3> holes;
  for (const int id : runs) {
    const guide::GuideRun& run = graph.runs[static_cast<std::size_t>(id)];
    const layout::Cover& cover = covers[static_cast<std::size_t>(id)];
    for (const layout::Beam& beam : cover.beams) {
      for (int i = beam.start; i <= beam.last(); ++i) {
        holes.push_back(layout::holePosition(graph, run, cover.axis, i, beam.layer));
      }
    }
  }
  return holes;
}

//! The largest squared distance from a point of `from` to its nearest point of `to`.
double directedSquared(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  double farthest = 0.0;
  for (const Vec3& p : from) {
    double nearest = std::numeric_limits<double>::max();
    for (const Vec3& q : to) {
      const Vec3 d = p - q;
      nearest = std::min(nearest, lattice::dot(d, d));
      if (nearest <= farthest) {
        break;  // this point cannot raise the maximum any more
      }
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace

SymmetryMap reflection(Vec3 normal, double offset) {
  SymmetryMap map;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      map.linear.m[static_cast<std::size_t>(3 * row + column)] =
          (row == column ? 1.0 : 0.0) - 2.0 * normal[row] * normal[column];
    }
  }
  map.shift = 2.0 * offset * normal;
  return map;
}

SymmetryMap translation(Vec3 vector) {
  SymmetryMap map;
  map.shift = vector;
  return map;
}

double symmetryDeviation(const guide::GuidingGraph& graph,
                         const std::vector<layout::Cover>& covers,
                         const std::vector<SymmetryGroup>& groups) {
  double sum = 0.0;
  for (const SymmetryGroup& group : groups) {
    const std::vector<Vec3> holes = holesOf(graph, covers, group.runs);
    std::vector<Vec3> partners = holesOf(graph, covers, group.partners);
    if (holes.empty() || partners.empty()) {
      continue;
    }
    std::transform(partners.begin(), partners.end(), partners.begin(), [&](Vec3 p) {
      return group.map.apply(p);
    });
    const double squared =
        std::max(directedSquared(holes, partners), directedSquared(partners, holes));
    sum += squared / static_cast<double>(holes.size());
  }
  return groups.empty() ? 0.0 : sum / static_cast<double>(groups.size());
}

}  // namespace liftarm::objective
