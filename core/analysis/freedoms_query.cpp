#include "analysis/freedoms_query.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "analysis/axle_lines.h"

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

bool coversAny(int part, const std::vector<int>& lines, const std::vector<EdgeCover>& coverage) {
  return std::any_of(coverage.begin(), coverage.end(), [&](const EdgeCover& edge) {
    return std::count(lines.begin(), lines.end(), edge.line) > 0 &&
           std::any_of(edge.covers.begin(), edge.covers.end(), [&](const Cover& cover) {
             return cover.part == part;
           });
  });
}

//! For lines without a beam, which an axle stands for: the nearest beam that it holds and that is
//! not of the other side; the axle itself where it holds none.
int partOnAxle(const AxleLines& axles,
               const std::vector<int>& lines,
               const std::vector<int>& others,
               Vec3 place,
               const std::vector<EdgeCover>& coverage) {
  int best = -1;
  double nearest = 1e9;
  for (const int axle : axles.ofLines(lines, coverage)) {
    best = best < 0 ? axle : best;
    for (const model::Connection* c : axles.heldBy(axle)) {
      const double distance = lattice::length(c->at - place);
      if (distance < nearest - kSamePlace && !coversAny(c->female, others, coverage)) {
        nearest = distance;
        best = c->female;
      }
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
  const AxleLines axles(scene);
  for (const sketch::Joint& joint : scene.sketch->joints) {
    const auto [first, second] = sidesOf(joint, coverage);
    JointLine line{joint.at,
                   joint.axis,
                   partOf(first, joint.at, coverage),
                   partOf(second, joint.at, coverage)};
    line.a = line.a < 0 ? partOnAxle(axles, first, second, joint.at, coverage) : line.a;
    line.b = line.b < 0 ? partOnAxle(axles, second, first, joint.at, coverage) : line.b;
    lines.push_back(line);
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
  for (const JointLine& joint : query.joints) {
    for (const int part : {joint.a, joint.b}) {
      if (part >= 0) {
        query.frame[static_cast<std::size_t>(part)] = true;  // an axle that is one side of a joint
      }
    }
  }
  return query;
}

}  // namespace liftarm::analysis
