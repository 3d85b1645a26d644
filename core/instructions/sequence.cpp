#include "instructions/sequence.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "analysis/disassembly_state.h"
#include "instructions/congruence.h"
#include "instructions/stability.h"

namespace liftarm::instructions {

namespace {

using analysis::DisassemblyGroup;
using analysis::DisassemblyPlan;
using analysis::Removal;
using analysis::Scene;
using lattice::Vec3;
using parts::PartClass;

constexpr std::size_t kMaxPartsInStep = 6;
constexpr std::size_t kMaxWaysInStep = 2;

Add reversed(const Removal& removal) {
  Add add{removal.parts, {}, removal.group, removal.forced};
  for (auto leg = removal.legs.rbegin(); leg != removal.legs.rend(); ++leg) {
    add.legs.push_back(-*leg);
  }
  return add;
}

//! Writes the steps of one group after the other.
class Writer {
 public:
  Writer(const Scene& scene, const DisassemblyPlan& plan)
      : scene_(scene),
        plan_(plan),
        neighbours_(analysis::findNeighbours(scene)),
        number_(plan.groups.size(), -1),
        done_(plan.groups.size(), 0) {
    sequence_.stuck = plan.stuck;
  }

  Sequence run() {
    nameGroups();
    copyNested();
    writeGroup(0);
    return std::move(sequence_);
  }

 private:
  //! Gives groups that are the same one number: the first is built, the others are its copies.
  void nameGroups() {
    std::vector<std::size_t> open{0};
    for (std::size_t k = 0; k < open.size(); ++k) {
      const std::size_t g = open[k];
      if (isCopy(g)) {
        continue;  // what it is made of is built as that of the first one
      }
      number_[g] = static_cast<int>(sequence_.groups.size());
      sequence_.groups.push_back({plan_.groups[g].parts, {}, {}, {}});
      original_.push_back(g);
      for (const Removal& removal : plan_.groups[g].removals) {
        if (removal.group >= 0) {
          open.push_back(static_cast<std::size_t>(removal.group));
        }
      }
    }
  }

  bool isCopy(std::size_t g) {
    for (std::size_t known = 1; known < sequence_.groups.size(); ++known) {
      const bool asked = !hasForced(original_[known]) && !hasForced(g);
      if (asked && addCopy(known, plan_.groups[g].parts)) {
        number_[g] = static_cast<int>(known);
        return true;
      }
    }
    return false;
  }

  bool addCopy(std::size_t known, const std::vector<int>& parts) {
    Group& group = sequence_.groups[known];
    std::optional<Match> match = findMatch(scene_, group.parts, parts);
    if (!match.has_value()) {
      return false;
    }
    group.copies.push_back(std::move(match->parts));
    group.mirrored.push_back(match->mirrored);
    group.poses.push_back(match->pose);
    return true;
  }

  //! A copy of a group has copies of all that is built apart in it.
  void copyNested() {
    std::vector<std::size_t> followed(sequence_.groups.size(), 0);
    for (bool any = true; any;) {
      any = false;
      for (std::size_t known = 0; known < sequence_.groups.size(); ++known) {
        while (followed[known] < sequence_.groups[known].copies.size()) {
          any = true;
          copyInto(known, followed[known]++);
        }
      }
    }
  }

  void copyInto(std::size_t known, std::size_t copy) {
    for (const Removal& removal : plan_.groups[original_[known]].removals) {
      if (removal.group < 0) {
        continue;
      }
      const auto nested = static_cast<std::size_t>(removal.group);
      const std::vector<int>& from = sequence_.groups[known].parts;
      const std::vector<int>& to = sequence_.groups[known].copies[copy];
      std::vector<int> parts;
      for (const int part : plan_.groups[nested].parts) {
        const auto place = std::find(from.begin(), from.end(), part) - from.begin();
        parts.push_back(to[static_cast<std::size_t>(place)]);
      }
      std::sort(parts.begin(), parts.end());
      addCopy(static_cast<std::size_t>(number_[nested]), parts);
    }
  }

  [[nodiscard]] bool hasForced(std::size_t g) const {
    const std::vector<Removal>& removals = plan_.groups[g].removals;
    return std::any_of(removals.begin(), removals.end(), [&](const Removal& removal) {
      return removal.forced ||
             (removal.group >= 0 && hasForced(static_cast<std::size_t>(removal.group)));
    });
  }

  void writeGroup(std::size_t g) {
    const std::vector<Removal>& removals = plan_.groups[g].removals;
    std::vector<int> built;
    Step step{number_[g], {}, false};
    const auto finish = [&] {
      if (!step.adds.empty()) {
        step.stable = stands(built) || (number_[g] != 0 && lies(built));
        sequence_.steps.push_back(std::move(step));
        step = {number_[g], {}, false};
      }
    };
    for (auto removal = removals.rbegin(); removal != removals.rend(); ++removal) {
      Add add = reversed(*removal);
      if (!joins(step, add, built.size()) && !mustGoOn(step, built)) {
        finish();
      }
      if (add.subgroup >= 0) {
        const auto child =
            static_cast<std::size_t>(number_[static_cast<std::size_t>(add.subgroup)]);
        if (done_[child] == 0) {
          done_[child] = 1;
          writeGroup(original_[child]);
        }
        add.subgroup = static_cast<int>(child);
      }
      built.insert(built.end(), add.parts.begin(), add.parts.end());
      step.adds.push_back(std::move(add));
    }
    finish();
  }

  [[nodiscard]] bool stands(const std::vector<int>& parts) const {
    return standAnyway(scene_, connectedSets(parts));
  }

  [[nodiscard]] bool lies(const std::vector<int>& parts) const {
    return connectedSets(parts).size() == 1 && canBeLaidDown(scene_, parts);
  }

  //! Whether parts would hang in the air if the step ended here: what joins them comes next.
  [[nodiscard]] bool mustGoOn(const Step& step, const std::vector<int>& built) const {
    return !step.adds.empty() && step.adds.size() < kMaxPartsInStep &&
           connectedSets(built).size() > 1 && !stands(built);
  }

  //! Whether one picture can show this too: a few pins and connectors and then what goes on them,
  //! or alike parts that go the same way.
  [[nodiscard]] bool joins(const Step& step, const Add& add, std::size_t built) const {
    if (step.adds.empty()) {
      return true;
    }
    const Add& last = step.adds.back();
    if (built == 1 && add.subgroup >= 0 && last.subgroup < 0 && !add.forced) {
      return true;  // a picture of the first part alone would say nothing
    }
    if (add.subgroup >= 0 || add.forced || last.subgroup >= 0 || last.forced ||
        step.adds.size() >= kMaxPartsInStep || waysOf(step, add) > kMaxWaysInStep) {
      return false;
    }
    if (holdsOthers(last)) {
      return !holdsOthers(add) || !touchesAny(step, add);
    }
    const bool first = built == step.adds.size();  // nothing to lay it on yet
    if (holdsOthers(add)) {
      return first;
    }
    return partOf(last).id == partOf(add).id && sameWay(last, add) && !touchesAny(step, add);
  }

  //! How many ways the arrows of a picture would point.
  static std::size_t waysOf(const Step& step, const Add& add) {
    std::vector<const Add*> different;
    const auto count = [&](const Add& one) {
      if (!one.legs.empty() && std::none_of(different.begin(), different.end(), [&](const Add* d) {
            return sameWay(*d, one);
          })) {
        different.push_back(&one);
      }
    };
    std::for_each(step.adds.begin(), step.adds.end(), count);
    count(add);
    return different.size();
  }

  [[nodiscard]] const parts::Part& partOf(const Add& add) const {
    return *scene_.parts[static_cast<std::size_t>(add.parts.front())].part;
  }

  //! Anything but a beam or a gear: it goes in so that others can go on it.
  [[nodiscard]] bool holdsOthers(const Add& add) const {
    const PartClass c = partOf(add).partClass;
    return c != PartClass::kBeam && c != PartClass::kGear;
  }

  static bool sameWay(const Add& a, const Add& b) {
    if (a.legs.empty() || b.legs.empty()) {
      return a.legs.empty() == b.legs.empty();
    }
    return lattice::dot(lattice::normalized(a.legs.back()), lattice::normalized(b.legs.back())) >
           0.99;
  }

  [[nodiscard]] bool touchesAny(const Step& step, const Add& add) const {
    const std::vector<int>& near = neighbours_[static_cast<std::size_t>(add.parts.front())];
    return std::any_of(step.adds.begin(), step.adds.end(), [&](const Add& other) {
      return std::binary_search(near.begin(), near.end(), other.parts.front());
    });
  }

  [[nodiscard]] std::vector<std::vector<int>> connectedSets(const std::vector<int>& parts) const {
    std::vector<char> open(scene_.parts.size(), 0);
    for (const int part : parts) {
      open[static_cast<std::size_t>(part)] = 1;
    }
    std::vector<std::vector<int>> sets;
    for (const int root : parts) {
      if (open[static_cast<std::size_t>(root)] == 0) {
        continue;
      }
      open[static_cast<std::size_t>(root)] = 0;
      std::vector<int> set{root};
      for (std::size_t i = 0; i < set.size(); ++i) {
        for (const int next : neighbours_[static_cast<std::size_t>(set[i])]) {
          if (open[static_cast<std::size_t>(next)] != 0) {
            open[static_cast<std::size_t>(next)] = 0;
            set.push_back(next);
          }
        }
      }
      sets.push_back(std::move(set));
    }
    return sets;
  }

  const Scene& scene_;
  const DisassemblyPlan& plan_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> number_;            // of each group of the plan, here
  std::vector<std::size_t> original_;  // of each group here, in the plan
  std::vector<char> done_;
  Sequence sequence_;
};

}  // namespace

Sequence planSequence(const Scene& scene) {
  analysis::DisassemblyWishes wishes;
  wishes.units = findRepeatedFrames(scene);
  const Footing footing(scene);
  wishes.stands = [&](const std::vector<int>& parts) { return footing.stands(parts); };
  wishes.holdTogether = true;
  wishes.upwards = true;
  wishes.rests = [&](const std::vector<int>& parts) { return standAnyway(scene, {parts}); };
  const DisassemblyPlan plan = analysis::planDisassembly(scene, wishes);
  return Writer(scene, plan).run();
}

}  // namespace liftarm::instructions
