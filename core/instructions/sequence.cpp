#include "instructions/sequence.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace liftarm::instructions {

namespace {

using analysis::DisassemblyGroup;
using analysis::DisassemblyPlan;
using analysis::Removal;

Add reversed(const Removal& removal) {
  Add add{removal.parts, {}, removal.group, removal.forced};
  for (auto leg = removal.legs.rbegin(); leg != removal.legs.rend(); ++leg) {
    add.legs.push_back(-*leg);
  }
  return add;
}

}  // namespace

Sequence planSequence(const analysis::Scene& scene) {
  const DisassemblyPlan plan = analysis::planDisassembly(scene);
  Sequence sequence;
  sequence.stuck = plan.stuck;
  for (const DisassemblyGroup& group : plan.groups) {
    sequence.groups.push_back({group.parts, {}, {}});
  }
  // A group's number is above that of the one that it goes into.
  for (std::size_t g = plan.groups.size(); g-- > 0;) {
    const std::vector<Removal>& removals = plan.groups[g].removals;
    for (auto removal = removals.rbegin(); removal != removals.rend(); ++removal) {
      sequence.steps.push_back({static_cast<int>(g), {reversed(*removal)}, true});
    }
  }
  return sequence;
}

}  // namespace liftarm::instructions
