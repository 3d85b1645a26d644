#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/well_built_items.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using parts::FeatureKind;
using parts::PartClass;

constexpr double kNearer = 1e-6;

using SlotKey = std::tuple<int, int, int>;  // part, feature, slot

//! Which slots, male or female, have something in or around them.
std::set<SlotKey> usedSlots(const Scene& scene) {
  std::set<SlotKey> used;
  for (const model::Connection& c : scene.connections) {
    if (model::isGood(c.fit)) {
      used.insert({c.male, c.maleFeature, c.maleSlot});
      used.insert({c.female, c.femaleFeature, c.femaleSlot});
    }
  }
  return used;
}

//! The slots of a male feature that count as heads: the two ends of an axle, all others' modules.
std::vector<int> headsOf(const parts::Part& part, const parts::Feature& feature) {
  const int slots = static_cast<int>(feature.slots.size());
  if (part.partClass == PartClass::kAxle && slots > 1) {
    return {0, slots - 1};
  }
  std::vector<int> heads;
  for (int s = 0; s < slots; ++s) {
    heads.push_back(s);
  }
  return heads;
}

//! The modules of a connector's body; what runs from one to another only joins them.
std::vector<Vec3> modulesOf(const parts::Part& part) {
  std::vector<Vec3> modules;
  for (const parts::Prism& prism : part.solid) {
    if (lattice::length(prism.to - prism.from) < kNearer) {
      modules.push_back(prism.from);
    }
  }
  return modules;
}

//! Whether a slot belongs to this module of a body: none of the others is nearer.
bool isOf(Vec3 module, Vec3 slot, const std::vector<Vec3>& modules) {
  const double own = lattice::length(slot - module);
  return std::none_of(modules.begin(), modules.end(), [&](Vec3 other) {
    return lattice::length(slot - other) < own - kNearer;
  });
}

struct Count {
  int naked = 0;
  int total = 0;
};

class CleanJudge {
 public:
  explicit CleanJudge(const Scene& scene) : scene_(scene), used_(usedSlots(scene)) {}

  WellBuiltItem judge() {
    item_.id = "clean";
    item_.title = "No head or arm holds nothing";
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      if (scene_.parts[i].part != nullptr) {
        countHeads(static_cast<int>(i));
        countArms(static_cast<int>(i));
      }
    }
    const int naked = pins_.naked + axles_.naked;
    const int total = pins_.total + axles_.total;
    item_.ok = naked <= kMostNakedHeads * total;
    item_.detail = std::to_string(naked) + " of " + std::to_string(total) +
                   " heads sit in nothing, " + std::to_string(arms_.naked) + " of " +
                   std::to_string(arms_.total) + " connector arms hold nothing";
    item_.figures = {{"nakedHeads", naked},
                     {"heads", total},
                     {"nakedPinHeads", pins_.naked},
                     {"pinHeads", pins_.total},
                     {"nakedAxleEnds", axles_.naked},
                     {"axleEnds", axles_.total},
                     {"idleArms", arms_.naked},
                     {"arms", arms_.total}};
    return std::move(item_);
  }

 private:
  void countHeads(int index) {
    const parts::Part& part = *scene_.parts[static_cast<std::size_t>(index)].part;
    for (std::size_t f = 0; f < part.features.size(); ++f) {
      const parts::Feature& feature = part.features[f];
      if (!parts::isMale(feature.kind)) {
        continue;
      }
      Count& count = feature.kind == FeatureKind::kPin ? pins_ : axles_;
      for (const int slot : headsOf(part, feature)) {
        ++count.total;
        if (used_.count({index, static_cast<int>(f), slot}) == 0) {
          ++count.naked;
          tell(index,
               feature.slots[static_cast<std::size_t>(slot)],
               "nakedHead",
               "a head of " + nameOf(scene_, index) + " sits in nothing at ");
        }
      }
    }
  }

  //! Ends of a connector's body: modules with at most one module beside them.
  void countArms(int index) {
    const parts::Part& part = *scene_.parts[static_cast<std::size_t>(index)].part;
    if (part.partClass != PartClass::kConnector) {
      return;
    }
    const std::vector<Vec3> modules = modulesOf(part);
    for (const Vec3 module : modules) {
      int beside = 0;
      for (const Vec3 other : modules) {
        const double apart = lattice::length(other - module);
        beside += apart > 0.1 && apart < 1.1 ? 1 : 0;
      }
      if (beside <= 1) {
        countArm(index, part, module, modules);
      }
    }
  }

  void countArm(int index, const parts::Part& part, Vec3 module, const std::vector<Vec3>& modules) {
    bool offers = false;
    bool hasHeads = false;
    bool holds = false;
    for (std::size_t f = 0; f < part.features.size(); ++f) {
      for (std::size_t s = 0; s < part.features[f].slots.size(); ++s) {
        if (isOf(module, part.features[f].slots[s], modules)) {
          offers = true;
          hasHeads = hasHeads || parts::isMale(part.features[f].kind);
          holds = holds || used_.count({index, static_cast<int>(f), static_cast<int>(s)}) != 0;
        }
      }
    }
    arms_.total += offers ? 1 : 0;
    arms_.naked += offers && !holds ? 1 : 0;
    if (offers && !holds && !hasHeads) {  // its heads are told already
      tell(index, module, "idleArm", "an arm of " + nameOf(scene_, index) + " holds nothing at ");
    }
  }

  void tell(int index, Vec3 inPart, const char* kind, const std::string& what) {
    const Vec3 at = scene_.model->parts[static_cast<std::size_t>(index)].pose.apply(inPart);
    item_.places.push_back({kind, what + pointText(at), at, {index}});
  }

  const Scene& scene_;
  std::set<SlotKey> used_;
  WellBuiltItem item_;
  Count pins_;
  Count axles_;
  Count arms_;
};

}  // namespace

WellBuiltItem judgeCleanness(const WellBuiltQuery& query) {
  return CleanJudge(query.scene).judge();
}

}  // namespace liftarm::analysis
