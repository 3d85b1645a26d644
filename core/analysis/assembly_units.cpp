#include "analysis/assembly_units.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;
using parts::PartClass;

void sortOut(std::vector<int>& units) {
  std::sort(units.begin(), units.end());
  units.erase(std::unique(units.begin(), units.end()), units.end());
}

AssemblyUnit unitOf(const Scene& scene, const Removal& removal) {
  AssemblyUnit unit;
  unit.removal = removal;
  Box box;
  for (const int part : removal.parts) {
    box.add(scene.parts[at(part)].box);
  }
  unit.floor = box.min.z;
  unit.middle = 0.5 * (box.min + box.max);
  const PartClass c = scene.parts[at(removal.parts.front())].part->partClass;
  unit.fastener = removal.parts.size() == 1 &&
                  (c == PartClass::kPin || c == PartClass::kAxle || c == PartClass::kBush);
  return unit;
}

}  // namespace

std::vector<AssemblyUnit> assemblyUnits(const DisassemblyGraphs& graphs,
                                        const std::vector<Removal>& removals) {
  std::vector<AssemblyUnit> units;
  std::vector<int> unitOfPart(graphs.scene.parts.size(), -1);
  for (auto removal = removals.rbegin(); removal != removals.rend(); ++removal) {
    for (const int part : removal->parts) {
      unitOfPart[at(part)] = static_cast<int>(units.size());
    }
    units.push_back(unitOf(graphs.scene, *removal));
  }
  const std::size_t directions = graphs.blocking.directions().size();
  for (std::size_t u = 0; u < units.size(); ++u) {
    AssemblyUnit& unit = units[u];
    const auto collect = [&](const std::vector<int>& parts, std::vector<int>& into) {
      for (const int part : parts) {
        if (const int v = unitOfPart[at(part)]; v >= 0 && at(v) != u) {
          into.push_back(v);
        }
      }
    };
    unit.hits.resize(directions);
    for (const int part : unit.removal.parts) {
      collect(graphs.neighbours[at(part)], unit.touches);
      for (std::size_t d = 0; d < directions; ++d) {
        collect(graphs.blocking.blockers(static_cast<int>(d), part), unit.hits[d]);
      }
    }
    sortOut(unit.touches);
    std::for_each(unit.hits.begin(), unit.hits.end(), sortOut);
  }
  return units;
}

}  // namespace liftarm::analysis
