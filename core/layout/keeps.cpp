#include "layout/keeps.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "layout/axle.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "layout/layout.h"
#include "sketch/arrangement.h"

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;

constexpr double kParallel = 1.0 - 1e-6;
constexpr int kPast = 1;  // modules that a beam may stick out past its run

Vec3 directionOf(const sketch::Line& line) {
  return (1.0 / lattice::length(line.to - line.from)) * (line.to - line.from);
}

Vec3 middleOf(const sketch::Sketch& sketch, const sketch::KeptPart& part) {
  const sketch::Line& line = sketch.lines[at(part.on.line)];
  return line.from + 0.5 * static_cast<double>(part.on.from + part.on.to) * directionOf(line) +
         static_cast<double>(part.layer) * lattice::unitVector(part.holeAxis);
}

bool hasAxis(const guide::GuideRun& run, Axis axis) {
  return std::find(run.axes.begin(), run.axes.end(), axis) != run.axes.end();
}

const parts::Part* straightPart(const std::string& id) {
  const parts::Part* part = parts::Catalogue::builtIn().find(id);
  const bool round =
      part != nullptr &&
      std::all_of(part->features.begin(), part->features.end(), [](const parts::Feature& feature) {
        return feature.kind == parts::FeatureKind::kPinHole;
      });
  return round && part->holes >= 2 && part->partClass == parts::PartClass::kBeam ? part : nullptr;
}

//! Fills in the keeps of one problem.
class KeepPlacer {
 public:
  KeepPlacer(const sketch::Sketch& sketch, const sketch::Keeps& keeps, LayoutProblem* problem)
      : sketch_(sketch), keeps_(keeps), problem_(problem), finder_(sketch, problem->graph) {}

  void place() {
    problem_->keeps.resize(problem_->graph.runs.size());
    for (const sketch::Keep& keep : keeps_) {
      for (const sketch::KeptPart& part : keep.parts) {
        if (const char* fault = placePart(part)) {
          problem_->keepFaults.push_back({keep.line, fault, middleOf(sketch_, part)});
        }
      }
      for (const sketch::BarredPart& part : keep.barred) {
        bar(part);
      }
      addRules(keep);
    }
  }

 private:
  const char* placePart(const sketch::KeptPart& part) {
    std::vector<RunStretch> bars;
    std::vector<sketch::Stretch> stretches{part.on};
    stretches.insert(stretches.end(), part.with.begin(), part.with.end());
    for (const sketch::Stretch& stretch : stretches) {
      const std::optional<RunStretch> bar = finder_.find(stretch);
      if (!bar) {
        return "the part kept here goes past the end of its line";
      }
      if (!hasAxis(problem_->graph.runs[at(bar->run)], part.holeAxis)) {
        return "the holes of the part kept here cannot go along that axis on this line";
      }
      bars.push_back(*bar);
    }
    std::vector<std::pair<int, Beam>> beams = beamsOf(part, bars);
    if (beams.empty()) {
      return "the part kept here does not fit this place";
    }
    for (const auto& [run, beam] : beams) {
      if (!problem_->graph.runs[at(run)].allows(beam.layer)) {
        return "the part kept here is on a layer that its line may not have";
      }
      if (isTaken(run, beam, part.holeAxis)) {
        return "another part is kept where this one is";
      }
    }
    for (const auto& [run, beam] : beams) {
      std::vector<Beam>& kept = problem_->keeps[at(run)].beams;
      const auto after = std::find_if(kept.begin(), kept.end(), [&, b = beam](const Beam& other) {
        return other.start > b.start;
      });
      kept.insert(after, beam);
    }
    return nullptr;
  }

  //! The beams of a part by run; none where it cannot lie so.
  std::vector<std::pair<int, Beam>> beamsOf(const sketch::KeptPart& part,
                                            const std::vector<RunStretch>& bars) const {
    if (bentBeamIndex(part.part) >= 0) {
      return armsOfBent(part, bars);
    }
    if (frameBeamIndex(part.part) >= 0) {
      return barsOfFrame(part, bars);
    }
    const parts::Part* straight = straightPart(part.part);
    if (straight == nullptr || bars.size() != 1 || straight->holes != bars[0].holes) {
      return {};
    }
    return {{bars[0].run, Beam{bars[0].start, bars[0].holes, part.layer}}};
  }

  [[nodiscard]] std::vector<std::pair<int, Beam>> armsOfBent(
      const sketch::KeptPart& part, const std::vector<RunStretch>& bars) const {
    const guide::GuidingGraph& graph = problem_->graph;
    if (bars.size() != 2 || bars[0].run == bars[1].run ||
        commonJunction(graph, bars[0].run, bars[1].run) < 0) {
      return {};
    }
    std::vector<Bend> bends;
    addBends(graph, bentBeamIndex(part.part), bars[0].run, bars[1].run, part.layer, &bends);
    for (const Bend& bend : bends) {
      if (bend.arm.start == bars[0].start && bend.arm.holes == bars[0].holes &&
          bend.mateArm.start == bars[1].start && bend.mateArm.holes == bars[1].holes) {
        return {{bars[0].run, bend.arm}, {bars[1].run, bend.mateArm}};
      }
    }
    return {};
  }

  [[nodiscard]] std::vector<std::pair<int, Beam>> barsOfFrame(
      const sketch::KeptPart& part, const std::vector<RunStretch>& bars) const {
    for (const FrameSite& site : problem_->sites) {
      const auto has = [&](const RunStretch& bar) {
        return std::any_of(site.arms.begin(), site.arms.end(), [&](const SiteArm& arm) {
          return arm.run == bar.run && arm.beam.start == bar.start && arm.beam.holes == bar.holes;
        });
      };
      if (site.frame != frameBeamIndex(part.part) || site.axis != part.holeAxis ||
          site.arms.size() != bars.size() || (site.exact && part.layer != 0) ||
          !std::all_of(bars.begin(), bars.end(), has)) {
        continue;
      }
      std::vector<std::pair<int, Beam>> beams;
      for (const SiteArm& arm : site.arms) {
        beams.emplace_back(arm.run, arm.beam);
        beams.back().second.layer = part.layer;
      }
      return beams;
    }
    return {};
  }

  //! Whether a kept beam is in the way of another.
  [[nodiscard]] bool isTaken(int run, const Beam& beam, Axis axis) const {
    const guide::GuidingGraph& graph = problem_->graph;
    const Stadium mine = stadiumOf(graph, graph.runs[at(run)], axis, beam);
    const auto meets = [&](int other) {
      const Axis theirs = graph.runs[at(other)].axes.front();
      const std::vector<Beam>& kept = problem_->keeps[at(other)].beams;
      return std::any_of(kept.begin(), kept.end(), [&](const Beam& b) {
        return overlap(mine, stadiumOf(graph, graph.runs[at(other)], theirs, b));
      });
    };
    const std::vector<int>& near = graph.runs[at(run)].near;
    return meets(run) || std::any_of(near.begin(), near.end(), meets);
  }

  void bar(const sketch::BarredPart& part) {
    const std::optional<RunStretch> bar = finder_.find(part.on);
    if (!bar) {
      return;  // the line has changed since
    }
    RunKeep& keep = problem_->keeps[at(bar->run)];
    if (axlePartIndex(part.part) >= 0) {
      keep.noAxle = true;
      return;
    }
    keep.bans.push_back(
        {bar->start, bar->holes, bentBeamIndex(part.part), frameBeamIndex(part.part)});
  }

  void addRules(const sketch::Keep& keep) {
    const int length = sketch_.lines[at(keep.line)].length;
    unsigned layers = 0;
    for (const int layer : keep.layers) {
      layers |= 1U << static_cast<unsigned>(layer + guide::kMaxLayer);
    }
    for (int edge = 0; edge < length && layers != 0; ++edge) {
      if (const auto place = finder_.find({keep.line, edge, edge + 1})) {
        std::vector<LayerRule>& rules = problem_->keeps[at(place->run)].rules;
        if (!rules.empty() && rules.back().last == place->start && rules.back().layers == layers) {
          rules.back().last = place->start + 1;
        } else if (!rules.empty() && rules.back().first == place->start + 1 &&
                   rules.back().layers == layers) {
          rules.back().first = place->start;
        } else {
          rules.push_back({place->start, place->start + 1, layers});
        }
      }
    }
    for (const int node : keep.splits) {
      const int from = std::min(node, length - 1);
      if (const auto place = finder_.find({keep.line, from, from + 1})) {
        const auto next = finder_.find({keep.line, node, node});
        problem_->keeps[at(place->run)].splits.push_back(next ? next->start : place->start);
      }
    }
  }

  const sketch::Sketch& sketch_;
  const sketch::Keeps& keeps_;
  LayoutProblem* problem_;
  StretchFinder finder_;
};

}  // namespace

bool RunKeep::permits(const Beam& beam, const std::vector<FrameSite>& sites) const {
  const int frame = beam.site >= 0 ? sites[at(beam.site)].frame : -1;
  const int bend = beam.mate >= 0 ? beam.form : -1;
  const bool banned = std::any_of(bans.begin(), bans.end(), [&](const Ban& ban) {
    return ban.start == beam.start && ban.holes == beam.holes && ban.bend == bend &&
           ban.frame == frame;
  });
  const bool passes = std::any_of(splits.begin(), splits.end(), [&](int node) {
    return beam.solidStart() < node - 1 && beam.solidLast() > node + 1;
  });
  const unsigned bit = 1U << static_cast<unsigned>(beam.layer + guide::kMaxLayer);
  const bool offLayer = std::any_of(rules.begin(), rules.end(), [&](const LayerRule& rule) {
    return beam.start < rule.last && beam.last() > rule.first && (rule.layers & bit) == 0U;
  });
  return keeps(beam) || (!banned && !passes && !offLayer);
}

bool RunKeep::keeps(const Beam& beam) const {
  return std::find(beams.begin(), beams.end(), beam) != beams.end();
}

StretchFinder::StretchFinder(const sketch::Sketch& sketch, const guide::GuidingGraph& graph)
    : graph_(&graph) {
  for (std::size_t l = 0; l < sketch.lines.size(); ++l) {
    const sketch::Line& line = sketch.lines[l];
    const Vec3 along = directionOf(line);
    for (std::size_t r = 0; r < graph.runs.size(); ++r) {
      const guide::GuideRun& run = graph.runs[r];
      const double cosine = lattice::dot(along, run.direction);
      const Vec3 offset = line.from - graph.nodes[at(run.nodes.front())];
      const double first = lattice::dot(offset, run.direction);
      if (std::abs(cosine) < kParallel ||
          lattice::length(offset - first * run.direction) > sketch::kSamePoint) {
        continue;
      }
      const int sign = cosine > 0.0 ? 1 : -1;
      const int start = static_cast<int>(std::lround(first));
      const int end = start + sign * line.length;
      if (std::min(start, end) < run.edgeCount() && std::max(start, end) > 0) {
        places_.push_back({static_cast<int>(l), static_cast<int>(r), start, sign, line.length});
      }
    }
  }
}

std::optional<RunStretch> StretchFinder::find(const sketch::Stretch& stretch) const {
  std::optional<RunStretch> best;
  int most = -1;
  for (const LineOnRun& place : places_) {
    const int edges = graph_->runs[at(place.run)].edgeCount();
    const int start = place.sign > 0 ? place.first + stretch.from : place.first - stretch.to;
    const int last = start + stretch.to - stretch.from;
    const int covered = std::min(edges, last) - std::max(0, start);
    if (place.line == stretch.line && start >= -kPast && last <= edges + kPast && covered > most) {
      most = covered;
      best = RunStretch{place.run, start, last - start + 1};
    }
  }
  return best;
}

sketch::Stretch StretchFinder::lineOf(const RunStretch& stretch) const {
  const LineOnRun* best = nullptr;
  int most = -1;
  for (const LineOnRun& place : places_) {
    const int low = std::min(place.first, place.first + place.sign * place.length);
    const int covered = std::min(low + place.length, stretch.start + stretch.holes - 1) -
                        std::max(low, stretch.start);
    if (place.run == stretch.run && covered > most) {
      best = &place;
      most = covered;
    }
  }
  if (best == nullptr) {
    return {};
  }
  const int a = best->sign * (stretch.start - best->first);
  const int b = best->sign * (stretch.start + stretch.holes - 1 - best->first);
  return {best->line, std::min(a, b), std::max(a, b)};
}

void turnToKeeps(const sketch::Sketch& sketch,
                 const sketch::Keeps& keeps,
                 guide::GuidingGraph* graph) {
  if (keeps.empty()) {
    return;
  }
  const StretchFinder finder(sketch, *graph);
  for (const sketch::Keep& keep : keeps) {
    for (const sketch::KeptPart& part : keep.parts) {
      std::vector<sketch::Stretch> stretches{part.on};
      stretches.insert(stretches.end(), part.with.begin(), part.with.end());
      for (const sketch::Stretch& stretch : stretches) {
        const std::optional<RunStretch> bar = finder.find(stretch);
        if (bar && hasAxis(graph->runs[at(bar->run)], part.holeAxis)) {
          graph->runs[at(bar->run)].axes = {part.holeAxis};
        }
      }
    }
  }
}

void addKeeps(const sketch::Sketch& sketch, const sketch::Keeps& keeps, LayoutProblem* problem) {
  if (!keeps.empty()) {
    KeepPlacer(sketch, keeps, problem).place();
  }
}

namespace {

//! Whether beams leave more of a run open than a mechanism may bridge: where nothing could be laid
//! beside those that are kept.
bool leavesGap(const std::vector<Beam>& beams, int edges) {
  int reached = -1;
  for (const Beam& beam : beams) {
    if (beam.start > reached + 2) {
      return true;
    }
    reached = std::max(reached, beam.last());
  }
  return reached < edges - 1;
}

}  // namespace

bool mayLie(const LayoutProblem& problem, int run, const Beam& beam) {
  const RunKeep* keep = problem.keepOf(run);
  return keep == nullptr ||
         (keep->permits(beam, problem.sites) &&
          std::none_of(keep->beams.begin(), keep->beams.end(), [&](const Beam& kept) {
            return beam.solidStart() <= kept.solidLast() && beam.solidLast() >= kept.solidStart();
          }));
}

int keepViolations(const LayoutProblem& problem, int run, const Cover& cover) {
  const RunKeep* keep = problem.keepOf(run);
  if (keep == nullptr) {
    return 0;
  }
  int count = cover.axle.used() && keep->noAxle ? 1 : 0;
  for (const Beam& beam : cover.beams) {
    count += keep->permits(beam, problem.sites) ? 0 : 1;
  }
  const int edges = problem.graph.runs[at(run)].edgeCount();
  count += !cover.beams.empty() && leavesGap(cover.beams, edges) ? 1 : 0;
  const bool turned = cover.axis != problem.graph.runs[at(run)].axes.front();
  for (const Beam& beam : keep->beams) {
    const bool there =
        !turned && std::find(cover.beams.begin(), cover.beams.end(), beam) != cover.beams.end();
    count += there ? 0 : kLostKeep;
  }
  return count;
}

Cover bareCover(const LayoutProblem& problem, int run, lattice::Axis axis) {
  const RunKeep* keep = problem.keepOf(run);
  return keep == nullptr ? Cover{axis, {}} : Cover{axis, keep->beams};
}

}  // namespace liftarm::layout
