#include "layout/frame_sites.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "base/check.h"
#include "base/index.h"
#include "layout/frame_beam.h"

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;

constexpr double kOnNode = 1e-3;  // modules
constexpr double kGrid = 1000.0;  // lines are told apart to a thousandth of a module
constexpr int kLeastCovered = 1;  // edges of its run, for each arm

//! Principal axis along which a unit vector lies, or -1.
int principalIndex(Vec3 direction) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(direction[k]) > 1.0 - 1e-9) {
      return k;
    }
  }
  return -1;
}

//! A line along a principal axis: the axis, and where it is across it.
using LineKey = std::array<std::int64_t, 3>;

LineKey lineOf(Vec3 point, int along) {
  return {along,
          std::llround(kGrid * point[(along + 1) % 3]),
          std::llround(kGrid * point[(along + 2) % 3])};
}

bool mayHave(const guide::GuideRun& run, Axis axis) {
  return std::find(run.axes.begin(), run.axes.end(), axis) != run.axes.end();
}

std::uint32_t reversed(std::uint32_t bits, int count) {
  std::uint32_t result = 0;
  for (int i = 0; i < count; ++i) {
    result |= (bits >> static_cast<unsigned>(i) & 1U) << static_cast<unsigned>(count - 1 - i);
  }
  return result;
}

class SiteFinder {
 public:
  SiteFinder(const guide::GuidingGraph& graph,
             const std::vector<LocalView>& views,
             const std::vector<std::vector<std::pair<int, int>>>& seenBy)
      : graph_(graph), views_(views), seenBy_(seenBy) {
    for (std::size_t r = 0; r < graph.runs.size(); ++r) {
      const int along = principalIndex(graph.runs[r].direction);
      if (along >= 0) {
        lines_[lineOf(firstNode(static_cast<int>(r)), along)].push_back(static_cast<int>(r));
      }
    }
  }

  std::vector<FrameSite> find() {
    for (const guide::Junction& junction : graph_.junctions) {
      for (const guide::Incidence& a : junction.incident) {
        for (const guide::Incidence& b : junction.incident) {
          if (junction.joint < 0 && a.run != b.run) {
            layAt(junction, a.run, b.run);
          }
        }
      }
    }
    return std::move(sites_);
  }

 private:
  [[nodiscard]] const guide::GuideRun& run(int id) const { return graph_.runs[at(id)]; }

  [[nodiscard]] Vec3 firstNode(int id) const { return graph_.nodes[at(run(id).nodes.front())]; }

  //! All frames whose first crossing is at this junction, its bars along these two runs.
  void layAt(const guide::Junction& junction, int runA, int runB) {
    const int alongA = principalIndex(run(runA).direction);
    const int alongB = principalIndex(run(runB).direction);
    if (alongA < 0 || alongB < 0 || alongA == alongB) {
      return;
    }
    const Axis axis = lattice::axisFromIndex(3 - alongA - alongB);
    if (!mayHave(run(runA), axis) || !mayHave(run(runB), axis)) {
      return;
    }
    for (std::size_t f = 0; f < frameBeams().size(); ++f) {
      for (const double signA : {1.0, -1.0}) {
        for (const double signB : {1.0, -1.0}) {
          lay(static_cast<int>(f),
              axis,
              graph_.nodes[at(junction.node)],
              signA * run(runA).direction,
              signB * run(runB).direction);
        }
      }
    }
  }

  //! The frame with its first crossing at a point and the bars there along two directions.
  void lay(int form, Axis axis, Vec3 point, Vec3 alongA, Vec3 alongB) {
    const FrameBeam& frame = frameBeams()[at(form)];
    const FrameCrossing& crossing = frame.crossings.front();
    const FrameBar& barA = frame.bars[at(crossing.barA)];
    const Vec3 directionB = frame.bars[at(crossing.barB)].direction;
    FrameSite site;
    site.frame = form;
    site.axis = axis;
    site.pose.rotation =
        lattice::fromColumns(alongA, alongB, lattice::cross(alongA, alongB)) *
        lattice::transposed(lattice::fromColumns(
            barA.direction, directionB, lattice::cross(barA.direction, directionB)));
    const Vec3 corner = barA.from + static_cast<double>(crossing.nodeA) * barA.direction;
    site.pose.position = point - site.pose.rotation * corner;
    for (const FrameBar& bar : frame.bars) {
      const std::optional<SiteArm> arm = armOf(bar, site.pose, axis);
      if (!arm || !isFree(*arm)) {
        return;
      }
      site.exact = site.exact || run(arm->run).exact;
      site.arms.push_back(*arm);
    }
    if (crossingsMeet(frame, site)) {
      add(frame, std::move(site));
    }
  }

  //! The run that a bar lies on, the one of which it covers most.
  [[nodiscard]] std::optional<SiteArm> armOf(const FrameBar& bar,
                                             const lattice::Pose& pose,
                                             Axis axis) const {
    const Vec3 from = pose.apply(bar.from);
    const Vec3 direction = pose.rotation * bar.direction;
    const auto line = lines_.find(lineOf(from, principalIndex(direction)));
    std::optional<SiteArm> best;
    int most = kLeastCovered - 1;
    if (line == lines_.end()) {
      return best;
    }
    for (const int id : line->second) {
      const guide::GuideRun& candidate = run(id);
      const double place = lattice::dot(from - firstNode(id), candidate.direction);
      const auto index = static_cast<int>(std::lround(place));
      const bool forward = lattice::dot(direction, candidate.direction) > 0.0;
      const int start = forward ? index : index - bar.nodes + 1;
      const int last = start + bar.nodes - 1;
      const int past = candidate.exact ? 0 : 1;
      const int covered = std::min(last, candidate.edgeCount()) - std::max(start, 0);
      if (!(std::abs(place - index) < kOnNode) || !mayHave(candidate, axis) || start < -past ||
          last > candidate.edgeCount() + past || covered <= most) {
        continue;
      }
      most = covered;
      best = SiteArm{id, Beam{start, bar.nodes, 0}, 0};
      best->beam.crossed = forward ? bar.crossed : reversed(bar.crossed, bar.nodes);
    }
    return best;
  }

  //! Whether no joint turns about a hole that goes another way, no shaft may run in one, and all
  //! junctions near are on the run's lattice.
  [[nodiscard]] bool isFree(const SiteArm& arm) const {
    const guide::GuideRun& own = run(arm.run);
    if (own.exact && own.axes.size() == 1 && arm.beam.crossed != 0) {
      return false;
    }
    for (std::size_t j = 0; j < own.junctions.size(); ++j) {
      const int node = own.junctionIndices[j];
      if (graph_.junctions[at(own.junctions[j])].joint >= 0 && arm.beam.reaches(node) &&
          !arm.beam.hasHoleAt(node)) {
        return false;
      }
    }
    const auto& seen = seenBy_[at(arm.run)];
    return std::none_of(seen.begin(), seen.end(), [&](const std::pair<int, int>& place) {
      const RunView& view = views_[at(place.first)].runs[at(place.second)];
      return !view.aligned && static_cast<double>(arm.beam.start) <= view.high &&
             static_cast<double>(arm.beam.last()) >= view.low;
    });
  }

  //! Node index on the run of a node of a bar. Arms are in the order of the bars still.
  static int indexOn(const FrameBar& bar, const SiteArm& arm, int node, bool forward) {
    return forward ? arm.beam.start + node : arm.beam.start + bar.nodes - 1 - node;
  }

  [[nodiscard]] bool crossingsMeet(const FrameBeam& frame, const FrameSite& site) const {
    for (std::size_t a = 0; a < site.arms.size(); ++a) {
      for (std::size_t b = a + 1; b < site.arms.size(); ++b) {
        if (site.arms[a].run == site.arms[b].run) {
          return false;
        }
      }
    }
    const auto isForward = [&](int bar) {
      return lattice::dot(site.pose.rotation * frame.bars[at(bar)].direction,
                          run(site.arms[at(bar)].run).direction) > 0.0;
    };
    return std::all_of(
        frame.crossings.begin(), frame.crossings.end(), [&](const FrameCrossing& crossing) {
          const SiteArm& a = site.arms[at(crossing.barA)];
          const SiteArm& b = site.arms[at(crossing.barB)];
          const int junction = commonJunction(graph_, a.run, b.run);
          return junction >= 0 && graph_.junctions[at(junction)].joint < 0 &&
                 cornerIndex(graph_, a.run, b.run) == indexOn(frame.bars[at(crossing.barA)],
                                                              a,
                                                              crossing.nodeA,
                                                              isForward(crossing.barA)) &&
                 cornerIndex(graph_, b.run, a.run) == indexOn(frame.bars[at(crossing.barB)],
                                                              b,
                                                              crossing.nodeB,
                                                              isForward(crossing.barB));
        });
  }

  //! Takes a place, unless the same arms lie there already: a frame looks the same from several
  //! sides.
  void add(const FrameBeam& frame, FrameSite site) {
    std::vector<int> shared(site.arms.size(), 0);  // by bar: nodes that bars on lower runs have
    for (const FrameCrossing& crossing : frame.crossings) {
      const bool aFirst = site.arms[at(crossing.barA)].run < site.arms[at(crossing.barB)].run;
      ++shared[at(aFirst ? crossing.barB : crossing.barA)];
    }
    for (std::size_t bar = 0; bar < site.arms.size(); ++bar) {
      site.arms[bar].own = site.arms[bar].beam.holes - shared[bar];
      site.arms[bar].beam.site = static_cast<int>(sites_.size());
    }
    std::sort(site.arms.begin(), site.arms.end(), [](const SiteArm& a, const SiteArm& b) {
      return a.run < b.run;
    });
    Key key{site.frame, {}};
    for (const SiteArm& arm : site.arms) {
      key.second.emplace_back(arm.run, arm.beam.start, arm.beam.crossed);
    }
    if (known_.insert(std::move(key)).second) {
      sites_.push_back(std::move(site));
    }
  }

  using Key = std::pair<int, std::vector<std::tuple<int, int, std::uint32_t>>>;

  const guide::GuidingGraph& graph_;
  const std::vector<LocalView>& views_;
  const std::vector<std::vector<std::pair<int, int>>>& seenBy_;
  std::map<LineKey, std::vector<int>> lines_;  // runs by line
  std::set<Key> known_;
  std::vector<FrameSite> sites_;
};

}  // namespace

std::vector<FrameSite> findFrameSites(const guide::GuidingGraph& graph,
                                      const std::vector<LocalView>& views,
                                      const std::vector<std::vector<std::pair<int, int>>>& seenBy) {
  return SiteFinder(graph, views, seenBy).find();
}

const SiteArm& armOn(const FrameSite& site, int run) {
  const auto found = std::find_if(
      site.arms.begin(), site.arms.end(), [&](const SiteArm& arm) { return arm.run == run; });
  LIFTARM_CHECK(found != site.arms.end(), "a frame's arm is on one of its runs");
  return *found;
}

}  // namespace liftarm::layout
