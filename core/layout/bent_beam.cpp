#include "layout/bent_beam.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "layout/part_list.h"

namespace liftarm::layout {

namespace {

using lattice::Vec3;
using parts::Feature;
using parts::FeatureKind;

constexpr double kSameAngle = 1e-4;  // of cosines

bool hasHole(const parts::Part& part, Vec3 at, FeatureKind kind) {
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& feature) {
    return feature.kind == kind && isSamePlace(feature.center, at);
  });
}

bool isPlain(const parts::Part& part) {
  return part.partClass == parts::PartClass::kBeam && part.thickness == 1.0 &&
         part.stretches.size() == 2 &&
         std::all_of(part.features.begin(), part.features.end(), [&](const Feature& feature) {
           return std::abs(lattice::dot(feature.axis, part.features.front().axis)) >
                  1.0 - kSamePlace;
         });
}

//! A stretch as an arm from a hole of its own; none when the hole is not on it.
std::optional<BentArm> armFrom(const parts::Part& part, const parts::Stretch& stretch, Vec3 hole) {
  const double length = lattice::length(stretch.to - stretch.from);
  const Vec3 along = (1.0 / length) * (stretch.to - stretch.from);
  const double place = lattice::dot(hole - stretch.from, along);
  if (place < -kSamePlace || place > length + kSamePlace ||
      !isSamePlace(stretch.from + place * along, hole)) {
    return std::nullopt;
  }
  const bool forward = place < 0.5 * length + kSamePlace;
  BentArm arm;
  arm.direction = forward ? along : -along;
  arm.holes = static_cast<int>(std::lround(length)) + 1;
  arm.behind = static_cast<int>(std::lround(forward ? place : length - place));
  const Vec3 end = forward ? stretch.to : stretch.from;
  arm.tail = hasHole(part, end + arm.direction, FeatureKind::kAxleHole);
  return arm;
}

std::optional<BentBeam> bentFrom(const parts::Part& part) {
  for (const Feature& feature : part.features) {
    const auto first = armFrom(part, part.stretches[0], feature.center);
    const auto second = armFrom(part, part.stretches[1], feature.center);
    if (first && second) {
      return BentBeam{part.id,
                      feature.center,
                      {*first, *second},
                      lattice::dot(first->direction, second->direction)};
    }
  }
  return std::nullopt;
}

//! Columns: the first vector, the one square to it in their plane, and the normal.
lattice::Mat3 frameOf(Vec3 first, Vec3 second) {
  const Vec3 aside = second - lattice::dot(first, second) * first;
  const Vec3 square = (1.0 / lattice::length(aside)) * aside;
  return lattice::fromColumns(first, square, lattice::cross(first, square));
}

//! Whether an arm stays on its run, but for one module past either end.
bool fits(const guide::GuideRun& run, const Beam& arm) {
  const int past = run.exact ? 0 : 1;
  return arm.solidStart() >= -past && arm.solidLast() <= run.edgeCount() + past;
}

}  // namespace

bool bendsAlong(const BentBeam& bent, Vec3 first, Vec3 second) {
  return std::abs(lattice::dot(first, second) - bent.cosine) < kSameAngle;
}

lattice::Pose poseOf(const BentBeam& bent, Vec3 corner, Vec3 first, Vec3 second) {
  const lattice::Mat3 rotation =
      frameOf(first, second) *
      lattice::transposed(frameOf(bent.arms[0].direction, bent.arms[1].direction));
  return {corner - rotation * bent.corner, rotation};
}

bool hasArms(const Cover& cover) {
  return std::any_of(
      cover.beams.begin(), cover.beams.end(), [](const Beam& beam) { return beam.isArm(); });
}

std::vector<Beam> armsOf(const Cover& cover) {
  std::vector<Beam> arms;
  for (const Beam& beam : cover.beams) {
    if (beam.isArm()) {
      arms.push_back(beam);
    }
  }
  return arms;
}

void addBends(const guide::GuidingGraph& graph,
              int form,
              int run,
              int mate,
              int layer,
              std::vector<Bend>* bends) {
  const BentBeam& bent = bentBeams()[static_cast<std::size_t>(form)];
  const guide::GuideRun& mine = graph.runs[static_cast<std::size_t>(run)];
  const guide::GuideRun& theirs = graph.runs[static_cast<std::size_t>(mate)];
  const int corner = cornerIndex(graph, run, mate);
  const int mateCorner = cornerIndex(graph, mate, run);
  for (const std::size_t first : {0U, 1U}) {
    for (const int way : {1, -1}) {
      for (const int mateWay : {1, -1}) {
        const Vec3 along = static_cast<double>(way) * mine.direction;
        const Vec3 mateAlong = static_cast<double>(mateWay) * theirs.direction;
        if (!bendsAlong(bent, along, mateAlong)) {
          continue;
        }
        Beam arm = bent.arms[first].laidAt(corner, way, layer);
        Beam mateArm = bent.arms[1 - first].laidAt(mateCorner, mateWay, layer);
        arm.mate = mate;
        mateArm.mate = run;
        arm.form = mateArm.form = form;
        const bool known = std::any_of(bends->begin(), bends->end(), [&](const Bend& bend) {
          return bend.arm == arm && bend.mateArm == mateArm;
        });
        if (fits(mine, arm) && fits(theirs, mateArm) && !known) {
          bends->push_back(
              {arm, mateArm, first == 0 ? along : mateAlong, first == 0 ? mateAlong : along});
        }
      }
    }
  }
}

std::vector<BentBeam> bentBeamsOf(const std::vector<parts::Part>& parts) {
  std::vector<BentBeam> all;
  for (const parts::Part& part : parts) {
    if (isPlain(part)) {
      if (auto bent = bentFrom(part)) {
        all.push_back(std::move(*bent));
      }
    }
  }
  std::sort(
      all.begin(), all.end(), [](const BentBeam& a, const BentBeam& b) { return a.part < b.part; });
  return all;
}

const std::vector<BentBeam>& bentBeams() {
  static const std::vector<BentBeam> all = bentBeamsOf(parts::Catalogue::builtIn().parts());
  return all;
}

std::vector<int> allBentBeams() {
  return indicesOf(bentBeams());
}

int bentBeamIndex(const std::string& part) {
  return indexOfPart(bentBeams(), part);
}

}  // namespace liftarm::layout
