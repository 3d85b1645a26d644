#include "design/wishes.h"

#include <algorithm>
#include <cmath>

#include "design/alikeness.h"
#include "sketch/arrangement.h"

namespace liftarm::design {

namespace {

constexpr double kHalfBeam = 0.5;  // modules from a beam's middle line to its side

}  // namespace

sketch::Sketch withWishes(const sketch::Sketch& sketch, Wishes wishes) {
  sketch::Sketch wanted = sketch;
  if (wishes.standing && !wanted.ground && !wanted.lines.empty()) {
    double lowest = wanted.lines.front().from.z;
    for (const sketch::Line& line : wanted.lines) {
      lowest = std::min({lowest, line.from.z, line.to.z});
    }
    wanted.ground = lowest - kHalfBeam;
  }
  if (wishes.symmetric && wanted.symmetries.empty()) {
    wanted.symmetries = wishedSymmetries(sketch);
    if (wishes.only >= 0) {
      wanted.symmetries = {wanted.symmetries[static_cast<std::size_t>(wishes.only)]};
    } else if (wanted.symmetries.front().kind == sketch::Symmetry::Kind::kReflection) {
      std::erase_if(wanted.symmetries, [](const sketch::Symmetry& symmetry) {
        return symmetry.kind != sketch::Symmetry::Kind::kReflection;
      });
    }
  }
  return wanted;
}

std::vector<Wishes> plansFor(Wishes all, std::size_t mirrors) {
  std::vector<Wishes> plans{Wishes{}};
  if (all.standing) {
    plans.push_back(Wishes{true, false});
  }
  if (all.symmetric && mirrors > 0) {
    plans.push_back(Wishes{all.standing, true, -1, true});
  }
  if (all.symmetric && mirrors > 1) {
    for (auto i = static_cast<int>(mirrors) - 1; i >= 0; --i) {
      plans.push_back(Wishes{all.standing, true, i});
    }
  }
  if (all.symmetric && mirrors > 0) {
    plans.push_back(all);
  }
  return plans;
}

bool liesFlat(const sketch::Sketch& sketch) {
  return std::all_of(sketch.lines.begin(), sketch.lines.end(), [&](const sketch::Line& line) {
    const double level = sketch.lines.front().from.z;
    return std::abs(line.from.z - level) < sketch::kSamePoint &&
           std::abs(line.to.z - level) < sketch::kSamePoint;
  });
}

}  // namespace liftarm::design
