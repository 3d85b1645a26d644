#include "search/earlier_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/index.h"
#include "layout/bent_beam.h"

namespace liftarm::search {

namespace {

using base::at;

constexpr double kGrid = 1000.0;  // places are told apart to a thousandth of a module
constexpr double kFarthest = 1e6;

using Ends = std::array<std::int64_t, 6>;

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

bool isFrameBar(const layout::Beam& beam) {
  return beam.mate < 0 && beam.form >= 0;
}

bool isAllowed(const layout::Beam& beam, const Allowed& allowed) {
  if (isFrameBar(beam)) {
    return beam.tail == 0 && base::contains(allowed.frames, beam.form);
  }
  const bool straight = beam.mate < 0 && beam.form < 0 && beam.tail == 0;
  return straight ? base::contains(allowed.lengths, beam.holes)
                  : beam.mate >= 0 && base::contains(allowed.bends, beam.form) && beam.holes >= 1 &&
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

//! The site at which a frame lies of which a bar is on this run, when all its other bars are where
//! they must be; -1: there is none. \param covers By run, null where none is kept.
int siteOf(int run,
           const layout::Beam& bar,
           const Allowed& allowed,
           const std::vector<const layout::Cover*>& covers) {
  const auto lies = [&](const layout::FrameSite& site, const layout::SiteArm& arm) {
    const layout::Cover* cover = covers[at(arm.run)];
    return cover != nullptr && cover->axis == site.axis &&
           std::any_of(cover->beams.begin(), cover->beams.end(), [&](const layout::Beam& other) {
             return isFrameBar(other) && other.form == bar.form && other.layer == bar.layer &&
                    other.start == arm.beam.start && other.holes == arm.beam.holes;
           });
  };
  for (std::size_t s = 0; s < allowed.sites.size(); ++s) {
    const layout::FrameSite& site = allowed.sites[s];
    const bool mine = std::any_of(site.arms.begin(), site.arms.end(), [&](const auto& arm) {
      return arm.run == run && arm.beam.start == bar.start && arm.beam.holes == bar.holes;
    });
    if (mine && site.frame == bar.form && (!site.exact || bar.layer == 0) &&
        std::all_of(site.arms.begin(), site.arms.end(), [&](const layout::SiteArm& arm) {
          return lies(site, arm);
        })) {
      return static_cast<int>(s);
    }
  }
  return -1;
}

//! The covers of earlier runs at the runs where they are now.
std::vector<const layout::Cover*> coversAt(const std::vector<int>& places,
                                           const EarlierLayout& earlier,
                                           std::size_t runs) {
  std::vector<const layout::Cover*> covers(runs, nullptr);
  for (std::size_t e = 0; e < places.size(); ++e) {
    if (places[e] >= 0) {
      covers[at(places[e])] = &earlier[e].cover;
    }
  }
  return covers;
}

//! Whether every frame with a bar on an earlier run lies where one may lie now.
bool hasItsFrames(int runs,
                  int self,
                  const std::vector<int>& places,
                  const EarlierLayout& earlier,
                  const Allowed& allowed) {
  const std::vector<layout::Beam>& beams = earlier[at(self)].cover.beams;
  if (std::none_of(beams.begin(), beams.end(), isFrameBar)) {
    return true;
  }
  const std::vector<const layout::Cover*> covers = coversAt(places, earlier, at(runs));
  return std::all_of(beams.begin(), beams.end(), [&](const layout::Beam& beam) {
    return !isFrameBar(beam) || siteOf(places[at(self)], beam, allowed, covers) >= 0;
  });
}

//! Where earlier runs are now.
struct Places {
  std::vector<int> runs;      //!< by earlier run: the run that it is now, or -1
  std::vector<bool> changed;  //!< by run: new, or not met as it was
};

//! Runs with the same ends, whose covers are still allowed.
Places placesOf(const guide::GuidingGraph& graph,
                const EarlierLayout& earlier,
                const Allowed& allowed) {
  std::map<Ends, int> known;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    const guide::GuideRun& run = graph.runs[r];
    known[endsOf(graph.nodes[at(run.nodes.front())], graph.nodes[at(run.nodes.back())])] =
        static_cast<int>(r);
  }
  Places places{std::vector<int>(earlier.size(), -1), std::vector<bool>(graph.runs.size(), true)};
  std::vector<bool> taken(graph.runs.size(), false);
  for (std::size_t e = 0; e < earlier.size(); ++e) {
    const auto found = known.find(endsOf(earlier[e].from, earlier[e].to));
    if (found == known.end() || taken[at(found->second)]) {
      continue;
    }
    const guide::GuideRun& run = graph.runs[at(found->second)];
    const bool same = meetsOf(graph, run) == earlier[e].meets;
    if (suits(run, earlier[e].cover, allowed, same)) {
      places.runs[e] = found->second;
      taken[at(found->second)] = true;
      places.changed[at(found->second)] = !same;
    }
  }
  return places;
}

//! Drops runs whose bent beams or frames have lost another run, until none has.
void dropTorn(const guide::GuidingGraph& graph,
              const EarlierLayout& earlier,
              const Allowed& allowed,
              Places* places) {
  const auto runs = static_cast<int>(graph.runs.size());
  for (bool again = true; again;) {
    again = false;
    for (std::size_t e = 0; e < earlier.size(); ++e) {
      const auto self = static_cast<int>(e);
      if (places->runs[e] >= 0 && (!hasItsMates(graph, self, places->runs, earlier) ||
                                   !hasItsFrames(runs, self, places->runs, earlier, allowed))) {
        places->changed[at(places->runs[e])] = true;
        places->runs[e] = -1;
        again = true;
      }
    }
  }
}

//! The cover of an earlier run as it is to lie on a run now. \param covers See coversAt.
layout::Cover coverNow(const EarlierRun& earlier,
                       int run,
                       const std::vector<int>& places,
                       const Allowed& allowed,
                       const std::vector<const layout::Cover*>& covers) {
  layout::Cover cover = earlier.cover;
  for (layout::Beam& beam : cover.beams) {
    if (isFrameBar(beam)) {
      const int site = siteOf(run, beam, allowed, covers);
      const int layer = beam.layer;
      beam = layout::armOn(allowed.sites[at(site)], run).beam;
      beam.layer = layer;
      continue;
    }
    beam.mate = beam.mate < 0 ? -1 : places[at(beam.mate)];
  }
  return cover;
}

//! Whether a run meets one that has no cover.
bool meetsBare(const guide::GuidingGraph& graph,
               const guide::GuideRun& run,
               const std::vector<std::optional<layout::Cover>>& covers) {
  return std::any_of(run.junctions.begin(), run.junctions.end(), [&](int j) {
    const std::vector<guide::Incidence>& incident = graph.junctions[at(j)].incident;
    return std::any_of(incident.begin(), incident.end(), [&](const guide::Incidence& incidence) {
      return !covers[at(incidence.run)].has_value();
    });
  });
}

}  // namespace

EarlierLayout earlierLayout(const guide::GuidingGraph& graph,
                            const std::vector<layout::FrameSite>& sites,
                            const std::vector<layout::Cover>& covers) {
  EarlierLayout earlier;
  for (std::size_t r = 0; r < covers.size(); ++r) {
    const guide::GuideRun& run = graph.runs[r];
    earlier.push_back({graph.nodes[at(run.nodes.front())],
                       graph.nodes[at(run.nodes.back())],
                       covers[r],
                       meetsOf(graph, run)});
    for (layout::Beam& beam : earlier.back().cover.beams) {
      if (beam.site >= 0) {
        beam = {beam.start, beam.holes, beam.layer, -1, sites[at(beam.site)].frame};
      }
    }
  }
  return earlier;
}

KeptRuns keepRuns(const guide::GuidingGraph& graph,
                  const EarlierLayout& earlier,
                  const Allowed& allowed) {
  Places places = placesOf(graph, earlier, allowed);
  dropTorn(graph, earlier, allowed, &places);
  KeptRuns result;
  result.covers.resize(graph.runs.size());
  const std::vector<const layout::Cover*> covers =
      coversAt(places.runs, earlier, graph.runs.size());
  for (std::size_t e = 0; e < earlier.size(); ++e) {
    const int run = places.runs[e];
    if (run >= 0) {
      ++result.kept;
      result.covers[at(run)] = coverNow(earlier[e], run, places.runs, allowed, covers);
    }
  }
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    if (places.changed[r] || meetsBare(graph, graph.runs[r], result.covers)) {
      result.touched.push_back(static_cast<int>(r));
    }
  }
  return result;
}

void dropUnwanted(const layout::LayoutProblem& problem, KeptRuns* kept) {
  if (problem.keeps.empty()) {
    return;
  }
  const auto gone = [&](int run) { return !kept->covers[at(run)].has_value(); };
  const auto isBroken = [&](const layout::Beam& beam) {
    const std::vector<layout::SiteArm> none;
    const auto& arms = beam.site >= 0 ? problem.sites[at(beam.site)].arms : none;
    return (beam.mate >= 0 && gone(beam.mate)) ||
           std::any_of(arms.begin(), arms.end(), [&](const auto& arm) { return gone(arm.run); });
  };
  for (bool again = true; again;) {
    again = false;
    for (std::size_t r = 0; r < kept->covers.size(); ++r) {
      std::optional<layout::Cover>& cover = kept->covers[r];
      if (cover && (layout::keepViolations(problem, static_cast<int>(r), *cover) > 0 ||
                    std::any_of(cover->beams.begin(), cover->beams.end(), isBroken))) {
        cover.reset();
        --kept->kept;
        again = true;
      }
    }
  }
  std::vector<int> touched;
  for (std::size_t r = 0; r < kept->covers.size(); ++r) {
    const bool before =
        std::binary_search(kept->touched.begin(), kept->touched.end(), static_cast<int>(r));
    if (before || !kept->covers[r] ||
        meetsBare(problem.graph, problem.graph.runs[r], kept->covers)) {
      touched.push_back(static_cast<int>(r));
    }
  }
  kept->touched = std::move(touched);
}

}  // namespace liftarm::search
