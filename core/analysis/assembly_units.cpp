#include "analysis/assembly_units.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using parts::PartClass;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

class UnitFinder {
 public:
  explicit UnitFinder(const DisassemblyGraphs& graphs)
      : graphs_(graphs), unitOf_(graphs.scene.parts.size(), -1) {}

  std::vector<AssemblyUnit> find(const std::vector<Removal>& removals) {
    for (auto removal = removals.rbegin(); removal != removals.rend(); ++removal) {
      addUnit(*removal);
    }
    for (std::size_t u = 0; u < units_.size(); ++u) {
      findTouching(u);
    }
    units_.front().direction = bestWayOutOfFirst();
    findOrder();
    return std::move(units_);
  }

 private:
  void addUnit(const Removal& removal) {
    const Scene& scene = graphs_.scene;
    AssemblyUnit unit;
    unit.removal = removal;
    unit.keepsPlace = removal.forced || removal.legs.size() > 1;
    if (removal.legs.size() == 1) {
      const Vec3 way = lattice::normalized(removal.legs.front());
      const std::vector<Vec3>& directions = graphs_.blocking.directions();
      for (std::size_t d = 0; d < directions.size(); ++d) {
        if (lattice::dot(directions[d], way) > 1.0 - 1e-9) {
          unit.direction = static_cast<int>(d);
        }
      }
      unit.keepsPlace = unit.keepsPlace || unit.direction < 0;
    }
    Box box;
    for (const int part : removal.parts) {
      box.add(scene.parts[at(part)].box);
      unitOf_[at(part)] = static_cast<int>(units_.size());
    }
    unit.floor = box.min.z;
    unit.middle = 0.5 * (box.min + box.max);
    const PartClass c = scene.parts[at(removal.parts.front())].part->partClass;
    unit.fastener = removal.parts.size() == 1 &&
                    (c == PartClass::kPin || c == PartClass::kAxle || c == PartClass::kBush);
    units_.push_back(std::move(unit));
  }

  void findTouching(std::size_t u) {
    std::vector<int>& touches = units_[u].touches;
    for (const int part : units_[u].removal.parts) {
      for (const int other : graphs_.neighbours[at(part)]) {
        const int v = unitOf_[at(other)];
        if (v >= 0 && at(v) != u) {
          touches.push_back(v);
        }
      }
    }
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  }

  //! Units that a unit would hit on its way out.
  [[nodiscard]] std::vector<int> inTheWay(std::size_t u, int direction) const {
    std::vector<int> found;
    for (const int part : units_[u].removal.parts) {
      for (const int other : graphs_.blocking.blockers(direction, part)) {
        const int v = unitOf_[at(other)];
        if (v >= 0 && at(v) != u) {
          found.push_back(v);
        }
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  //! What lay there first leaves last, so it may leave any way: one that few others must wait for.
  [[nodiscard]] int bestWayOutOfFirst() const {
    const std::vector<Vec3>& directions = graphs_.blocking.directions();
    using Worth = std::tuple<std::size_t, double, int>;
    std::optional<Worth> best;
    for (std::size_t d = 0; d < directions.size(); ++d) {
      const Worth worth{
          inTheWay(0, static_cast<int>(d)).size(), -directions[d].z, static_cast<int>(d)};
      best = best.has_value() ? std::min(*best, worth) : worth;
    }
    return std::get<2>(*best);
  }

  void findOrder() {
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (units_[u].keepsPlace) {
        for (std::size_t v = 0; v < units_.size(); ++v) {
          if (v != u) {
            units_[std::max(u, v)].before.push_back(static_cast<int>(std::min(u, v)));
          }
        }
      } else {
        for (const int v : inTheWay(u, units_[u].direction)) {
          units_[at(v)].before.push_back(static_cast<int>(u));
        }
      }
    }
  }

  const DisassemblyGraphs& graphs_;
  std::vector<int> unitOf_;  // by part
  std::vector<AssemblyUnit> units_;
};

}  // namespace

std::vector<AssemblyUnit> assemblyUnits(const DisassemblyGraphs& graphs,
                                        const std::vector<Removal>& removals) {
  return UnitFinder(graphs).find(removals);
}

}  // namespace liftarm::analysis
