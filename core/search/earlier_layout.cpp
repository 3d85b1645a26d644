#include "search/earlier_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "layout/bent_beam.h"

namespace liftarm::search {

namespace {

constexpr double kGrid = 1000.0;  // places are told apart to a thousandth of a module
constexpr double kFarthest = 1e6;

using Ends = std::array<std::int64_t, 6>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

std::int64_t gridded(double value) {
  // Written so that what is not a number counts as far away, too.
  return std::abs(value) < kFarthest ? std::llround(value * kGrid)
                                     : std::llround(kFarthest * kGrid);
}

Ends endsOf(lattice::Vec3 from, lattice::Vec3 to) {
  return {gridded(from.x),
          gridded(from.y),
          gridded(from.z),
          gridded(to.x),
          gridded(to.y),
          gridded(to.z)};
}

std::vector<int> meetsOf(const guide::GuidingGraph& graph, const guide::GuideRun& run) {
  std::vector<int> meets;
  for (std::size_t i = 0; i < run.junctions.size(); ++i) {
    const guide::Junction& junction = graph.junctions[at(run.junctions[i])];
    meets.push_back(run.junctionIndices[i]);
    meets.push_back(static_cast<int>(junction.incident.size()));
    meets.push_back(guide::mayBridge(run, junction) ? 1 : 0);
  }
  return meets;
}

bool leavesNoEdge(const guide::GuideRun& run, const layout::Cover& cover) {
  int covered = 0;
  for (const layout::Beam& beam : cover.beams) {
    if (beam.start > covered) {
      return false;
    }
    covered = std::max(covered, beam.last());
  }
  return covered >= run.edgeCount();
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

bool isAllowed(const layout::Beam& beam, const Allowed& allowed) {
  const bool straight = beam.mate < 0 && beam.form < 0 && beam.tail == 0;
  return straight ? contains(allowed.lengths, beam.holes)
                  : beam.mate >= 0 && contains(allowed.bends, beam.form) && beam.holes >= 1 &&
                        std::abs(beam.tail) <= 1;
}

//! Whether a cover may lie on the run as it is now; `same` when it meets the same as before.
bool suits(const guide::GuideRun& run,
           const layout::Cover& cover,
           const Allowed& allowed,
           bool same) {
  if (cover.beams.empty() ||
      std::find(run.axes.begin(), run.axes.end(), cover.axis) == run.axes.end()) {
    return false;
  }
  for (const layout::Beam& beam : cover.beams) {
    const bool inside = beam.start >= -1 && beam.last() <= run.edgeCount() + 1;
    const int reach = run.exact ? 0 : guide::kMaxLayer;
    if (!isAllowed(beam, allowed) || !inside || std::abs(beam.layer) > reach) {
      return false;
    }
  }
  // Edges may be left to mechanisms only where they were before.
  return same || leavesNoEdge(run, cover);
}

//! Whether two beams are the arms of a bent beam that can lie on these two runs.
bool makeABend(
    const guide::GuidingGraph& graph, int run, layout::Beam arm, int mate, layout::Beam mateArm) {
  arm.mate = mate;
  mateArm.mate = run;
  std::vector<layout::Bend> bends;
  layout::addBends(graph, arm.form, run, mate, arm.layer, &bends);
  return std::any_of(bends.begin(), bends.end(), [&](const layout::Bend& bend) {
    return bend.arm == arm && bend.mateArm == mateArm;
  });
}

//! Whether every arm on an earlier run has its other arm on a run that is kept and still meets it.
bool hasItsMates(const guide::GuidingGraph& graph,
                 int self,
                 const std::vector<int>& places,
                 const EarlierLayout& earlier) {
  for (const layout::Beam& beam : earlier[at(self)].cover.beams) {
    if (beam.mate < 0) {
      continue;
    }
    if (beam.mate == self || at(beam.mate) >= places.size() || places[at(beam.mate)] < 0 ||
        layout::commonJunction(graph, places[at(self)], places[at(beam.mate)]) < 0) {
      return false;
    }
    const layout::Cover& theirs = earlier[at(beam.mate)].cover;
    if (theirs.axis != earlier[at(self)].cover.axis ||
        std::none_of(theirs.beams.begin(), theirs.beams.end(), [&](const layout::Beam& other) {
          return other.mate == self &&
                 makeABend(graph, places[at(self)], beam, places[at(beam.mate)], other);
        })) {
      return false;
    }
  }
  return true;
}

}  // namespace

EarlierLayout earlierLayout(const guide::GuidingGraph& graph,
                            const std::vector<layout::Cover>& covers) {
  EarlierLayout earlier;
  for (std::size_t r = 0; r < covers.size(); ++r) {
    const guide::GuideRun& run = graph.runs[r];
    const bool framed = std::any_of(covers[r].beams.begin(),
                                    covers[r].beams.end(),
                                    [](const layout::Beam& beam) { return beam.site >= 0; });
    earlier.push_back({graph.nodes[at(run.nodes.front())],
                       graph.nodes[at(run.nodes.back())],
                       // Places of frames are those of this sketch: the next one lays them anew.
                       framed ? layout::Cover{covers[r].axis, {}} : covers[r],
                       meetsOf(graph, run)});
  }
  return earlier;
}

KeptRuns keepRuns(const guide::GuidingGraph& graph,
                  const EarlierLayout& earlier,
                  const Allowed& allowed) {
  std::map<Ends, int> known;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    const guide::GuideRun& run = graph.runs[r];
    known[endsOf(graph.nodes[at(run.nodes.front())], graph.nodes[at(run.nodes.back())])] =
        static_cast<int>(r);
  }
  std::vector<int> places(earlier.size(), -1);  // run of each earlier one
  std::vector<bool> taken(graph.runs.size(), false);
  std::vector<bool> changed(graph.runs.size(), true);
  for (std::size_t e = 0; e < earlier.size(); ++e) {
    const auto found = known.find(endsOf(earlier[e].from, earlier[e].to));
    if (found == known.end() || taken[at(found->second)]) {
      continue;
    }
    const guide::GuideRun& run = graph.runs[at(found->second)];
    const bool same = meetsOf(graph, run) == earlier[e].meets;
    if (suits(run, earlier[e].cover, allowed, same)) {
      places[e] = found->second;
      taken[at(found->second)] = true;
      changed[at(found->second)] = !same;
    }
  }
  for (bool again = true; again;) {
    again = false;
    for (std::size_t e = 0; e < earlier.size(); ++e) {
      if (places[e] >= 0 && !hasItsMates(graph, static_cast<int>(e), places, earlier)) {
        changed[at(places[e])] = true;
        places[e] = -1;
        again = true;
      }
    }
  }
  KeptRuns result;
  result.covers.resize(graph.runs.size());
  for (std::size_t e = 0; e < earlier.size(); ++e) {
    if (places[e] < 0) {
      continue;
    }
    ++result.kept;
    layout::Cover cover = earlier[e].cover;
    for (layout::Beam& beam : cover.beams) {
      beam.mate = beam.mate < 0 ? -1 : places[at(beam.mate)];
    }
    result.covers[at(places[e])] = std::move(cover);
  }
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    bool touched = changed[r];
    for (const int j : graph.runs[r].junctions) {
      for (const guide::Incidence& incidence : graph.junctions[at(j)].incident) {
        touched = touched || !result.covers[at(incidence.run)].has_value();
      }
    }
    if (touched) {
      result.touched.push_back(static_cast<int>(r));
    }
  }
  return result;
}

}  // namespace liftarm::search
