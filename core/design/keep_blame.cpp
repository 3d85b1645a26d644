#include "design/keep_blame.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "design/crowded_place.h"
#include "layout/layout.h"

namespace liftarm::design {

namespace {

using lattice::Vec3;

constexpr double kWork = 4e8;  // AnnealingOptions::mostWork
constexpr std::size_t kMostSuspects = 8;

//! One thing that is kept: what is said of it, where, and all that is kept but it.
struct Suspect {
  layout::KeepFault fault;
  sketch::Keeps without;
  double distance = 0.0;  // to the nearest violation
};

Vec3 pointOn(const sketch::Sketch& sketch, const sketch::Stretch& on) {
  const sketch::Line& line = sketch.lines[static_cast<std::size_t>(on.line)];
  const double share = 0.5 * static_cast<double>(on.from + on.to) / line.length;
  return line.from + share * (line.to - line.from);
}

class Suspects {
 public:
  Suspects(const sketch::Sketch& sketch, const sketch::Keeps& keeps)
      : sketch_(sketch), keeps_(keeps) {}

  std::vector<Suspect> all() {
    for (std::size_t k = 0; k < keeps_.size(); ++k) {
      const sketch::Keep& keep = keeps_[k];
      const std::string line = "lines[" + std::to_string(keep.line) + "]";
      for (std::size_t p = 0; p < keep.parts.size(); ++p) {
        add(k,
            "no model was found that keeps part " + keep.parts[p].part + " on " + line,
            keep.parts[p].on,
            [p](sketch::Keep& changed) { erase(changed.parts, p); });
      }
      for (std::size_t p = 0; p < keep.barred.size(); ++p) {
        add(k,
            "no model was found without part " + keep.barred[p].part + " on " + line,
            keep.barred[p].on,
            [p](sketch::Keep& changed) { erase(changed.barred, p); });
      }
      const sketch::Stretch whole{
          keep.line, 0, sketch_.lines[static_cast<std::size_t>(keep.line)].length};
      if (!keep.layers.empty()) {
        add(k,
            "no model was found with the layers that " + line + " may have",
            whole,
            [](sketch::Keep& changed) { changed.layers.clear(); });
      }
      for (std::size_t p = 0; p < keep.splits.size(); ++p) {
        add(k,
            "no model was found whose beams end where " + line + " is split",
            {keep.line, keep.splits[p], keep.splits[p]},
            [p](sketch::Keep& changed) { erase(changed.splits, p); });
      }
    }
    return std::move(suspects_);
  }

 private:
  template <typename T>
  static void erase(std::vector<T>& list, std::size_t index) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
  }

  template <typename Change>
  void add(std::size_t keep, std::string message, const sketch::Stretch& on, Change change) {
    Suspect suspect{{keeps_[keep].line, std::move(message), pointOn(sketch_, on)}, keeps_};
    change(suspect.without[keep]);
    suspects_.push_back(std::move(suspect));
  }

  const sketch::Sketch& sketch_;
  const sketch::Keeps& keeps_;
  std::vector<Suspect> suspects_;
};

}  // namespace

std::optional<layout::KeepFault> findBlame(const sketch::Sketch& sketch,
                                           const layout::LayoutProblem& problem,
                                           const search::LayoutSnapshot& failed,
                                           const Settings& settings,
                                           const mechanisms::MechanismTable& table) {
  Settings changed = settings;
  changed.keeps.clear();
  if (settings.keeps.empty() || !joinsAll(sketch, changed, table, kRoundsOfBlame, kWork)) {
    return std::nullopt;
  }
  const std::vector<Vec3> places = violatedPlaces(problem.graph, failed);
  std::vector<Suspect> suspects = Suspects(sketch, settings.keeps).all();
  for (Suspect& suspect : suspects) {
    suspect.distance = places.empty() ? 0.0 : 1e9;
    for (const Vec3 place : places) {
      suspect.distance = std::min(suspect.distance, lattice::length(place - suspect.fault.at));
    }
  }
  std::stable_sort(suspects.begin(), suspects.end(), [](const Suspect& a, const Suspect& b) {
    return a.distance < b.distance;
  });
  for (std::size_t i = 0; i < std::min(kMostSuspects, suspects.size()); ++i) {
    changed.keeps = suspects[i].without;
    if (joinsAll(sketch, changed, table, kRoundsOfBlame, kWork)) {
      suspects[i].fault.message += "; without that there is one";
      return std::move(suspects[i].fault);
    }
  }
  layout::KeepFault all = suspects.front().fault;
  all.message = "no model was found with all that is kept; with nothing kept there is one";
  return all;
}

std::vector<layout::KeepFault> findUnkept(const sketch::Sketch& sketch,
                                          const layout::LayoutProblem& problem,
                                          const std::vector<layout::Cover>& covers) {
  std::vector<layout::KeepFault> faults;
  if (problem.keeps.empty()) {
    return faults;
  }
  const layout::StretchFinder finder(sketch, problem.graph);
  for (std::size_t r = 0; r < covers.size(); ++r) {
    const int id = static_cast<int>(r);
    if (layout::keepViolations(problem, id, covers[r]) == 0) {
      continue;
    }
    const guide::GuideRun& run = problem.graph.runs[r];
    const sketch::Stretch whole = finder.lineOf({id, 0, run.edgeCount() + 1});
    faults.push_back(
        {whole.line, "the model has not all that is kept on this line", pointOn(sketch, whole)});
  }
  return faults;
}

}  // namespace liftarm::design
