#include "objective/symmetry_measure.h"

#include <algorithm>
#include <functional>
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

constexpr double kSameSquared = 1e-4;

//! Runs of `from` with a hole that maps onto none of `holes`.
void addUnmatched(const guide::GuidingGraph& graph,
                  const std::vector<layout::Cover>& covers,
                  const std::vector<int>& from,
                  const std::function<Vec3(Vec3)>& map,
                  const std::vector<Vec3>& holes,
                  std::vector<int>* runs) {
  for (const int run : from) {
    const std::vector<Vec3> own = holesOf(graph, covers, {run});
    const bool matched = std::all_of(own.begin(), own.end(), [&](Vec3 hole) {
      return std::any_of(holes.begin(), holes.end(), [&](Vec3 other) {
        const Vec3 d = map(hole) - other;
        return lattice::dot(d, d) < kSameSquared;
      });
    });
    if (!matched) {
      runs->push_back(run);
    }
  }
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

std::vector<int> asymmetricRuns(const guide::GuidingGraph& graph,
                                const std::vector<layout::Cover>& covers,
                                const std::vector<SymmetryGroup>& groups) {
  std::vector<int> runs;
  for (const SymmetryGroup& group : groups) {
    std::vector<Vec3> mapped = holesOf(graph, covers, group.partners);
    std::transform(
        mapped.begin(), mapped.end(), mapped.begin(), [&](Vec3 p) { return group.map.apply(p); });
    const auto same = [](Vec3 p) { return p; };
    const auto apply = [&](Vec3 p) { return group.map.apply(p); };
    addUnmatched(graph, covers, group.runs, same, mapped, &runs);
    addUnmatched(graph, covers, group.partners, apply, holesOf(graph, covers, group.runs), &runs);
  }
  std::sort(runs.begin(), runs.end());
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  return runs;
}

}  // namespace liftarm::objective
