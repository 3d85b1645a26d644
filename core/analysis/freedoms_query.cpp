#include "analysis/freedoms_query.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr double kSamePlace = 0.05;  // modules

double distanceToEdge(Vec3 p, const EdgeCover& edge) {
  return std::min(lattice::length(p - edge.from), lattice::length(p - edge.to));
}

//! Lines that have a node at a place, by their first edge there.
std::vector<int> linesAt(const std::vector<EdgeCover>& coverage, Vec3 p) {
  std::vector<int> lines;
  for (const EdgeCover& edge : coverage) {
    const bool isNew = lines.empty() || lines.back() != edge.line;
    if (isNew && distanceToEdge(p, edge) < kSamePlace) {
      lines.push_back(edge.line);
    }
  }
  return lines;
}

std::pair<std::vector<int>, std::vector<int>> sidesOf(const sketch::Joint& joint,
                                                      const std::vector<EdgeCover>& coverage) {
  if (joint.between.size() >= 2) {
    return {joint.between[0], joint.between[1]};
  }
  const std::vector<int> meeting = linesAt(coverage, joint.at);
  if (joint.between.size() == 1) {
    std::vector<int> others;
    for (const int line : meeting) {
      if (std::count(joint.between[0].begin(), joint.between[0].end(), line) == 0) {
        others.push_back(line);
      }
    }
    return {joint.between[0], others};
  }
  if (meeting.empty()) {
    return {};
  }
  return {{meeting.front()}, {meeting.begin() + 1, meeting.end()}};
}

//! The beam that covers one of the lines nearest to a place.
int partOf(const std::vector<int>& lines, Vec3 place, const std::vector<EdgeCover>& coverage) {
  int best = -1;
  double nearest = 1e9;
  for (const EdgeCover& edge : coverage) {
    if (std::count(lines.begin(), lines.end(), edge.line) == 0 || edge.covers.empty()) {
      continue;
    }
    const double distance = distanceToEdge(place, edge);
    if (distance < nearest - kSamePlace) {
      nearest = distance;
      best = edge.covers.front().part;
    }
  }
  return best;
}

}  // namespace

std::vector<JointLine> findJointLines(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  std::vector<JointLine> lines;
  if (!scene.sketch.has_value()) {
    return lines;
  }
  for (const sketch::Joint& joint : scene.sketch->joints) {
    const auto [first, second] = sidesOf(joint, coverage);
    lines.push_back({joint.at,
                     joint.axis,
                     partOf(first, joint.at, coverage),
                     partOf(second, joint.at, coverage)});
  }
  return lines;
}

FreedomsQuery makeFreedomsQuery(const Scene& scene,
                                const std::vector<EdgeCover>& coverage,
                                Friction friction) {
  FreedomsQuery query;
  query.linkage = linkageOf(scene, friction);
  for (const ScenePart& part : scene.parts) {
    query.frame.push_back(part.part != nullptr && part.part->partClass == parts::PartClass::kBeam &&
                          part.part->features.size() > 1);
    query.weight.push_back(part.part != nullptr ? part.part->mass : 0.0);
  }
  query.joints = findJointLines(scene, coverage);
  return query;
}

}  // namespace liftarm::analysis
