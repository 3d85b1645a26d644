#include "analysis/check.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "analysis/assembly.h"
#include "analysis/connection_check.h"
#include "analysis/coverage.h"
#include "analysis/disassembly.h"
#include "analysis/drive_check.h"
#include "analysis/interpenetration.h"
#include "analysis/real_parts.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

namespace {

void add(CheckReport& report, const char* id, const char* title, const ItemResult& result) {
  report.items.push_back({id, title, result.problems.empty(), result.detail});
  report.problems.insert(report.problems.end(), result.problems.begin(), result.problems.end());
}

//! The box around the real geometry of all parts.
Box boxOf(const Scene& scene) {
  Box box;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const parts::Part* part = scene.parts[i].part;
    if (part == nullptr) {
      continue;
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
      lattice::Vec3 p = part->boundsMin;
      for (int k = 0; k < 3; ++k) {
        p[k] = (corner >> static_cast<unsigned>(k) & 1U) != 0 ? part->boundsMax[k] : p[k];
      }
      const lattice::Vec3 world = scene.model->parts[i].pose.apply(p);
      box.add({world, world});
    }
  }
  return box;
}

int countOfKind(const std::vector<Problem>& problems, const char* kind) {
  return static_cast<int>(
      std::count_if(problems.begin(), problems.end(), [&](const Problem& problem) {
        return problem.kind == kind;
      }));
}

void countParts(const Scene& scene, CheckCounts& counts) {
  for (const ScenePart& part : scene.parts) {
    ++counts.bricks;
    if (part.part != nullptr) {
      // One hole alone covers no edge: a spacer in a stack.
      const bool beam =
          part.part->partClass == parts::PartClass::kBeam && part.part->features.size() > 1;
      counts.beams += beam ? 1 : 0;
      counts.mass += part.part->mass;
    }
  }
  const Box box = boxOf(scene);
  counts.size = box.empty() ? lattice::Vec3{} : box.max - box.min;
}

bool fulfils(const ItemResult& item) {
  return item.problems.empty();
}

//! Item 7 of DESIGN 5: joints, and what gears couple.
ItemResult checkTurning(const Scene& scene, const MotionReport& motion) {
  ItemResult result = checkJoints(scene, motion);
  const ItemResult drives = checkDrives(scene, motion.trains);
  result.problems.insert(result.problems.end(), drives.problems.begin(), drives.problems.end());
  result.detail += drives.detail.empty() ? "" : "; " + drives.detail;
  return result;
}

//! Items 1 to 6 of DESIGN 5.
bool holdsTogether(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  return fulfils(checkRealParts(scene)) && fulfils(checkConnections(scene)) &&
         fulfils(checkAssembly(scene, coverage)) && fulfils(checkCoverage(scene, coverage)) &&
         fulfils(checkInterpenetration(scene)) && fulfils(checkDisassembly(scene));
}

}  // namespace

bool isBuildable(const model::Model& model, const parts::Catalogue& catalogue) {
  const Scene scene = makeScene(model, catalogue);
  const std::vector<EdgeCover> coverage = findCoverage(scene);
  const bool joints = scene.sketch.has_value() && !scene.sketch->joints.empty();
  return holdsTogether(scene, coverage) && fulfils(checkDrives(scene, findGearTrains(scene))) &&
         (!joints || fulfils(checkJoints(scene, analyseFreedoms(scene, coverage))));
}

CheckReport checkModel(const model::Model& model, const parts::Catalogue& catalogue) {
  const Scene scene = makeScene(model, catalogue);
  const std::vector<EdgeCover> coverage = findCoverage(scene);
  const ItemResult connections = checkConnections(scene);
  const ItemResult assembly = checkAssembly(scene, coverage);

  CheckReport report;
  add(report,
      "realParts",
      "Every part is a real one, neither mirrored nor bent",
      checkRealParts(scene));
  add(report,
      "interpenetration",
      "No two parts share space, none lies in a forbidden place",
      checkInterpenetration(scene));
  add(report, "connections", "Every head fits its hole, every part is held", connections);
  add(report, "assembly", "All parts hang together", assembly);
  add(report,
      "coverage",
      "Every line of the sketch is there from end to end",
      checkCoverage(scene, coverage));
  const ItemResult disassembly = checkDisassembly(scene);
  report.assemblable = disassembly.problems.empty();
  add(report, "disassembly", "It can be taken apart, so it can be put together", disassembly);
  report.motion = analyseMotion(scene, coverage);
  add(report, "joints", "Every joint turns", checkTurning(scene, report.motion));
  report.buildable = report.problems.empty();
  report.wellBuilt = judgeWellBuilt({scene, coverage, report.motion});

  countParts(scene, report.counts);
  report.counts.gaps = countGaps(scene, coverage);
  report.counts.collisions = countOfKind(report.problems, "collision");
  report.counts.uncovered = countOfKind(report.problems, "uncovered");
  report.counts.failedConnections =
      static_cast<int>(connections.problems.size() + assembly.problems.size());
  return report;
}

}  // namespace liftarm::analysis
