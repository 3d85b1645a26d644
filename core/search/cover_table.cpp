#include "search/cover_table.h"

#include <algorithm>

#include "base/index.h"
#include "search/axle_sites.h"

namespace liftarm::search {

namespace {

using base::at;

//! Some edges of a run, by their indices: first .. last - 1, which may lie past its ends.
struct Stretch {
  int run = 0;
  int first = 0;
  int last = 0;
};

class TableMaker {
 public:
  TableMaker(const layout::LayoutProblem& problem,
             const AnnealingOptions& options,
             Bridging bridging)
      : problem_(problem), graph_(problem.graph), options_(options), bridging_(bridging) {}

  CoverTable make() {
    addEdges();
    for (int run = 0; run < static_cast<int>(graph_.runs.size()); ++run) {
      addStraight(run);
    }
    if (options_.parts.corners) {
      addBent();
    }
    if (options_.parts.frames) {
      addFrames();
    }
    if (options_.parts.axles) {
      addAxles();
    }
    return std::move(table_);
  }

 private:
  void addEdges() {
    for (std::size_t r = 0; r < graph_.runs.size(); ++r) {
      const guide::GuideRun& run = graph_.runs[r];
      std::vector<int> numbers(at(run.edgeCount()), 0);
      for (std::size_t j = 0; j < run.junctions.size(); ++j) {
        if (mayBridge(run, graph_.junctions[at(run.junctions[j])])) {
          const int node = run.junctionIndices[j];
          std::fill(numbers.begin() + std::max(0, node - 1),
                    numbers.begin() + std::min(run.edgeCount(), node + 1),
                    kBridged);
        }
      }
      for (int e = 0; e < run.edgeCount(); ++e) {
        if (numbers[at(e)] != kBridged) {
          numbers[at(e)] = static_cast<int>(table_.edges.size());
          table_.edges.push_back({static_cast<int>(r), e});
        }
      }
      numbers_.push_back(std::move(numbers));
    }
  }

  [[nodiscard]] bool mayBridge(const guide::GuideRun& run, const guide::Junction& junction) const {
    if (bridging_ == Bridging::kWhereNeeded || guide::mayBridge(run, junction)) {
      return guide::mayBridge(run, junction);
    }
    return run.principal && std::any_of(junction.incident.begin(),
                                        junction.incident.end(),
                                        [&](const guide::Incidence& incidence) {
                                          const guide::GuideRun& other =
                                              graph_.runs[at(incidence.run)];
                                          return other.axes.size() > 1 || other.axes != run.axes;
                                        });
  }

  void add(CoverPart part, int parts, const std::vector<Stretch>& stretches) {
    TableCover cover{part, parts, {}, {}};
    for (const Stretch& stretch : stretches) {
      const std::vector<int>& numbers = numbers_[at(stretch.run)];
      if (bridging_ == Bridging::kWhereNeeded) {
        cover.runs.push_back(stretch.run);
      }
      const int last = std::min(stretch.last, static_cast<int>(numbers.size()));
      for (int e = std::max(0, stretch.first); e < last; ++e) {
        if (numbers[at(e)] != kBridged) {
          cover.edges.push_back(numbers[at(e)]);
        }
      }
    }
    std::sort(cover.runs.begin(), cover.runs.end());
    std::sort(cover.edges.begin(), cover.edges.end());
    if (!cover.runs.empty() || !cover.edges.empty()) {
      table_.covers.push_back(std::move(cover));
    }
  }

  void addStraight(int run) {
    const guide::GuideRun& guideRun = graph_.runs[at(run)];
    const int past = guideRun.exact ? 0 : 1;
    for (const int holes : options_.lengths) {
      for (int start = -past; start + holes - 1 <= guideRun.edgeCount() + past; ++start) {
        add({CoverKind::kStraight, holes},
            layout::partsOfBeam(holes),
            {{run, start, start + holes - 1}});
      }
    }
  }

  //! Bent beams on every two runs that meet, are no joint's, and may have a hole axis in common.
  void addBent() {
    std::vector<layout::Bend> bends;
    for (int run = 0; run < static_cast<int>(graph_.runs.size()); ++run) {
      for (const int mate : runsMet(graph_, run)) {
        const int junction = layout::commonJunction(graph_, run, mate);
        if (mate < run || junction < 0 || graph_.junctions[at(junction)].joint >= 0 ||
            !haveAxisInCommon(run, mate)) {
          continue;
        }
        for (const int form : options_.bends) {
          bends.clear();
          layout::addBends(graph_, form, run, mate, 0, &bends);
          for (const layout::Bend& bend : bends) {
            add({CoverKind::kBent, form},
                1,
                {{run, bend.arm.start, bend.arm.last()},
                 {mate, bend.mateArm.start, bend.mateArm.last()}});
          }
        }
      }
    }
  }

  [[nodiscard]] bool haveAxisInCommon(int run, int mate) const {
    const std::vector<lattice::Axis>& axes = graph_.runs[at(run)].axes;
    const std::vector<lattice::Axis>& others = graph_.runs[at(mate)].axes;
    return std::any_of(axes.begin(), axes.end(), [&](lattice::Axis axis) {
      return std::find(others.begin(), others.end(), axis) != others.end();
    });
  }

  void addFrames() {
    for (const layout::FrameSite& site : problem_.sites) {
      if (std::find(options_.frames.begin(), options_.frames.end(), site.frame) ==
          options_.frames.end()) {
        continue;
      }
      std::vector<Stretch> stretches;
      for (const layout::SiteArm& arm : site.arms) {
        stretches.push_back({arm.run, arm.beam.start, arm.beam.last()});
      }
      add({CoverKind::kFrame, site.frame}, 1, stretches);
    }
  }

  //! Axles lie on their lines, so two that meet would go through one another.
  void addAxles() {
    std::vector<std::vector<int>> byRun(graph_.runs.size());
    for (const int axle : options_.axles) {
      const int length = layout::axleParts()[at(axle)].length;
      for (int run = 0; run < static_cast<int>(graph_.runs.size()); ++run) {
        if (mayHaveAxle(graph_, run, length)) {
          const auto number = static_cast<int>(table_.covers.size());
          add({CoverKind::kAxle, axle}, 1, {{run, 0, graph_.runs[at(run)].edgeCount()}});
          if (static_cast<int>(table_.covers.size()) > number) {
            byRun[at(run)].push_back(number);
          }
        }
      }
    }
    for (const guide::Junction& junction : graph_.junctions) {
      std::vector<int> rivals;
      for (const guide::Incidence& incidence : junction.incident) {
        const std::vector<int>& axles = byRun[at(incidence.run)];
        rivals.insert(rivals.end(), axles.begin(), axles.end());
      }
      if (rivals.size() > 1) {
        table_.rivals.push_back(std::move(rivals));
      }
    }
  }

  static constexpr int kBridged = -1;

  const layout::LayoutProblem& problem_;
  const guide::GuidingGraph& graph_;
  const AnnealingOptions& options_;
  Bridging bridging_;
  std::vector<std::vector<int>> numbers_;  // by run and edge: its place in the table, or kBridged
  CoverTable table_;
};

}  // namespace

CoverTable makeCoverTable(const layout::LayoutProblem& problem,
                          const AnnealingOptions& options,
                          Bridging bridging) {
  return TableMaker(problem, options, bridging).make();
}

}  // namespace liftarm::search
