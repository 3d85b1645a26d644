#include "search/axle_sites.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/index.h"
#include "layout/axle_collisions.h"
#include "layout/bent_beam.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;
using lattice::Axis;

bool mayTurnTo(const guide::GuideRun& run, Axis axis) {
  return std::find(run.axes.begin(), run.axes.end(), axis) != run.axes.end();
}

//! Runs of a joint that are to stay as one with this one; nothing where it belongs to no side.
std::vector<int> sideOf(const guide::GuideJoint& joint, int run) {
  for (const std::vector<int>& group : joint.runGroups) {
    if (std::find(group.begin(), group.end(), run) != group.end()) {
      return group;
    }
  }
  return {};
}

class FamilyFinder {
 public:
  FamilyFinder(const layout::Layout& layout, const std::vector<int>& runs, const AxleCosts& costs)
      : layout_(layout), graph_(layout.problem().graph), costs_(costs) {
    for (const int run : runs) {
      if (isOpen(run) && ownGain(run) > 0.0) {
        runs_.push_back(run);
      }
    }
  }

  std::vector<AxleFamily> find() {
    std::vector<AxleFamily> families;
    std::vector<int> root(graph_.runs.size());
    std::iota(root.begin(), root.end(), 0);
    const auto rootOf = [&](int run) {
      while (root[at(run)] != run) {
        run = root[at(run)];
      }
      return run;
    };
    for (const int a : runs_) {
      for (const int b : runs_) {
        if (a < b && axisOf(a) == axisOf(b) && shareARun(a, b)) {
          root[at(rootOf(b))] = rootOf(a);
        }
      }
    }
    for (const int run : runs_) {
      std::vector<int> members;
      for (const int other : runs_) {
        if (rootOf(other) == rootOf(run)) {
          members.push_back(other);
        }
      }
      if (members.size() > 1) {
        add({run}, &families);
      }
      if (members.front() == run) {
        add(members, &families);
      }
    }
    std::stable_sort(families.begin(),
                     families.end(),
                     [](const AxleFamily& a, const AxleFamily& b) { return a.gain > b.gain; });
    return families;
  }

 private:
  [[nodiscard]] Axis axisOf(int run) const {
    return layout::alongAxisOf(graph_.runs[at(run)]).axis;
  }

  //! An axle with a bare end is not what a builder puts where a beam is drawn.
  [[nodiscard]] bool isHeldAtBothEnds(const guide::GuideRun& run) const {
    return !run.junctionIndices.empty() && run.junctionIndices.front() == 0 &&
           run.junctionIndices.back() == run.edgeCount();
  }

  //! Arms of bent beams stay as they lie.
  [[nodiscard]] bool isOpen(int run) const {
    if (!isHeldAtBothEnds(graph_.runs[at(run)]) || layout::hasArms(layout_.run(run).cover) ||
        layout_.run(run).cover.axle.used()) {
      return false;
    }
    const std::vector<int> met = runsMet(graph_, run);
    return std::all_of(met.begin(), met.end(), [&](int other) {
      const layout::Cover& cover = layout_.run(other).cover;
      return cover.axis == axisOf(run) || !layout::hasArms(cover);
    });
  }

  [[nodiscard]] bool shareARun(int a, int b) const {
    const std::vector<int> metByA = runsMet(graph_, a);
    const std::vector<int> metByB = runsMet(graph_, b);
    return std::any_of(metByA.begin(), metByA.end(), [&](int run) {
      return std::find(metByB.begin(), metByB.end(), run) != metByB.end();
    });
  }

  //! Beams that would turn on an axle through a junction without friction.
  [[nodiscard]] int looseAt(int junction, int run) const {
    if (graph_.junctions[at(junction)].joint >= 0) {
      return 0;
    }
    std::set<std::pair<int, int>> bodies;  // a bent beam is one, by its two runs; so is a frame
    for (const guide::Incidence& incidence : graph_.junctions[at(junction)].incident) {
      if (incidence.run == run) {
        continue;
      }
      std::pair<int, int> body{incidence.run, -1};
      for (const layout::Beam& beam : layout_.run(incidence.run).cover.beams) {
        if (beam.isArm() && beam.reaches(incidence.index)) {
          body = beam.site >= 0 ? std::pair(-1, beam.site)
                                : std::pair<int, int>(std::minmax(incidence.run, beam.mate));
        }
      }
      bodies.insert(body);
    }
    return std::max(0, static_cast<int>(bodies.size()) - 1);
  }

  //! What an axle may save on its own run, all mechanisms at its junctions included. It may not
  //! take more parts than there are now.
  [[nodiscard]] double ownGain(int run) const {
    const guide::GuideRun& guideRun = graph_.runs[at(run)];
    const std::vector<layout::Beam>& beams = layout_.run(run).cover.beams;
    int parts = 0;
    double gain = 0.0;
    for (std::size_t b = 0; b < beams.size(); ++b) {
      const int pins = b == 0 ? 0 : layout::inlinePins(guideRun, beams[b - 1], beams[b]).count;
      parts += layout::partsOfBeam(beams[b].holes) + pins;
      gain += costs_.beam * static_cast<double>(layout::partsOfBeam(beams[b].holes)) +
              costs_.hole * static_cast<double>(beams[b].holes) + static_cast<double>(pins);
    }
    gain += costs_.loose;
    int least = 2;  // the axle, with a stop, and a bush
    for (std::size_t j = 0; j < guideRun.junctions.size(); ++j) {
      const layout::JunctionState& state = layout_.junction(guideRun.junctions[j]);
      for (const layout::PlacedMechanism& placed : state.connection.mechanisms) {
        parts += static_cast<int>(layout_.table().oriented(placed.oriented).shape.parts.size());
      }
      parts += static_cast<int>(state.spacers.size());
      gain += static_cast<double>(state.spacers.size()) + state.connection.cost -
              costs_.hinge * kTuning.axles.hingesEach * looseAt(guideRun.junctions[j], run);
      // Stacks may lie towards each other by the layers that they have.
      const int apart = j == 0 ? 1 : guideRun.junctionIndices[j] - guideRun.junctionIndices[j - 1];
      least += apart > 3 ? 2 : (apart > 1 ? 1 : 0);
    }
    return least > parts ? 0.0 : gain - static_cast<double>(least);
  }

  //! What it costs the runs that a family goes through to turn their holes its way.
  [[nodiscard]] double turningCost(const std::vector<int>& family) const {
    const Axis axis = axisOf(family.front());
    std::set<int> turned;
    for (const int run : family) {
      for (const int met : runsMet(graph_, run)) {
        if (layout_.run(met).cover.axis != axis) {
          turned.insert(met);
        }
      }
    }
    double cost = 0.0;
    for (const int run : turned) {
      for (const int junction : graph_.runs[at(run)].junctions) {
        for (const guide::Incidence& incidence : graph_.junctions[at(junction)].incident) {
          const bool goes = incidence.run == run || turned.count(incidence.run) > 0 ||
                            std::find(family.begin(), family.end(), incidence.run) != family.end();
          if (goes) {
            continue;
          }
          const Axis theirs = layout_.run(incidence.run).cover.axis;
          cost += theirs == layout_.run(run).cover.axis ? kTuning.axles.mixedCost : 0.0;
          cost -= theirs == axis ? kTuning.axles.mixedCost : 0.0;
        }
      }
    }
    return cost;
  }

  void add(const std::vector<int>& members, std::vector<AxleFamily>* families) const {
    AxleFamily family{members, -turningCost(members)};
    for (const int run : members) {
      family.gain += ownGain(run);
    }
    if (family.gain >= kTuning.axles.leastGain) {
      families->push_back(std::move(family));
    }
  }

  const layout::Layout& layout_;
  const guide::GuidingGraph& graph_;
  AxleCosts costs_;
  std::vector<int> runs_;
};

}  // namespace

bool mayHaveAxle(const guide::GuidingGraph& graph, int run, int longest) {
  const guide::GuideRun& guideRun = graph.runs[at(run)];
  if (!guideRun.principal || guideRun.axes.size() < 2 || guideRun.junctions.empty() ||
      guideRun.edgeCount() < kTuning.axles.fewestEdges || guideRun.edgeCount() + 1 > longest) {
    return false;
  }
  const Axis axis = layout::alongAxisOf(guideRun).axis;
  for (const int id : guideRun.junctions) {
    const guide::Junction& junction = graph.junctions[at(id)];
    if (junction.joint >= 0) {
      const guide::GuideJoint& joint = graph.joints[at(junction.joint)];
      if (joint.axis != axis || sideOf(joint, run).size() > 1) {
        return false;
      }
    }
    for (const guide::Incidence& incidence : junction.incident) {
      if (incidence.run != run && !mayTurnTo(graph.runs[at(incidence.run)], axis)) {
        return false;
      }
    }
  }
  return true;
}

bool needsAxle(const guide::GuidingGraph& graph, int run) {
  const std::vector<int>& junctions = graph.runs[at(run)].junctions;
  return std::any_of(junctions.begin(), junctions.end(), [&](int id) {
    const int joint = graph.junctions[at(id)].joint;
    return joint >= 0 && !sideOf(graph.joints[at(joint)], run).empty();
  });
}

std::vector<int> runsMet(const guide::GuidingGraph& graph, int run) {
  std::set<int> met;
  for (const int junction : graph.runs[at(run)].junctions) {
    for (const guide::Incidence& incidence : graph.junctions[at(junction)].incident) {
      met.insert(incidence.run);
    }
  }
  met.erase(run);
  return {met.begin(), met.end()};
}

std::vector<AxleFamily> findAxleFamilies(const layout::Layout& layout,
                                         const std::vector<int>& runs,
                                         const AxleCosts& costs) {
  return FamilyFinder(layout, runs, costs).find();
}

}  // namespace liftarm::search
