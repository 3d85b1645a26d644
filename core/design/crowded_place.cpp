#include "design/crowded_place.h"

#include <algorithm>
#include <utility>

#include "design/attempt.h"
#include "search/annealer.h"
#include "sketch/arrangement.h"
#include "sketch/json_text.h"

namespace liftarm::design {

namespace {

using lattice::Vec3;

// Modules of each line to either side: beams further away do not touch what is at the node, but
// for lines at the sharpest angles of whole triangles.
constexpr int kNear = 7;
constexpr std::uint32_t kRoundsOfSome = 5;
constexpr double kWorkOfAll = 2.5e9;  // AnnealingOptions::mostWork
constexpr double kWorkOfSome = 2e8;
constexpr std::uint32_t kStep = 1000;

//! The first and last of a line's nodes that lie within so many modules of a point, if any.
std::optional<std::pair<int, int>> nodesNear(const sketch::Line& line, Vec3 at, double radius) {
  const Vec3 step = (1.0 / line.length) * (line.to - line.from);
  std::optional<std::pair<int, int>> nodes;
  for (int k = 0; k <= line.length; ++k) {
    if (lattice::length(line.from + static_cast<double>(k) * step - at) <
        radius + sketch::kSamePoint) {
      nodes = std::pair(nodes ? nodes->first : k, k);
    }
  }
  return nodes;
}

//! Some lines of a sketch alone, cut to what is near a place.
sketch::Sketch cutOut(const sketch::Sketch& sketch,
                      Vec3 at,
                      double radius,
                      const std::vector<int>& lines) {
  sketch::Sketch near;
  near.keepOut = sketch.keepOut;
  near.ground = sketch.ground;
  for (const int index : lines) {
    const sketch::Line& line = sketch.lines[static_cast<std::size_t>(index)];
    const std::pair<int, int> nodes = nodesNear(line, at, radius).value_or(std::pair(0, 0));
    const int first = std::max(0, nodes.first - kNear);
    const int last = std::min(line.length, nodes.second + kNear);
    const Vec3 step = (1.0 / line.length) * (line.to - line.from);
    sketch::Line cut = line;
    cut.from = line.from + static_cast<double>(first) * step;
    cut.to = line.from + static_cast<double>(last) * step;
    cut.length = last - first;
    near.lines.push_back(cut);
  }
  return near;
}

//! The joints at the place, between the lines that are there.
void addJoints(const sketch::Sketch& sketch,
               Vec3 at,
               double radius,
               const std::vector<int>& lines,
               sketch::Sketch& near) {
  for (const sketch::Joint& joint : sketch.joints) {
    if (lattice::length(joint.at - at) >= radius + sketch::kSamePoint) {
      continue;
    }
    sketch::Joint kept = joint;
    for (std::vector<int>& group : kept.between) {
      std::vector<int> there;
      for (const int line : group) {
        const auto found = std::find(lines.begin(), lines.end(), line);
        if (found != lines.end()) {
          there.push_back(static_cast<int>(found - lines.begin()));
        }
      }
      group = std::move(there);
    }
    const bool whole = std::none_of(kept.between.begin(),
                                    kept.between.end(),
                                    [](const std::vector<int>& group) { return group.empty(); });
    if (whole && (!kept.between.empty() || lines.size() == 2)) {
      near.joints.push_back(std::move(kept));
    }
  }
}

std::string listOf(const std::vector<int>& lines) {
  std::string text;
  for (const int line : lines) {
    text += (text.empty() ? "lines[" : ", lines[") + std::to_string(line) + "]";
  }
  return text;
}

}  // namespace

std::vector<Vec3> violatedPlaces(const guide::GuidingGraph& graph,
                                 const search::LayoutSnapshot& layout) {
  std::vector<Vec3> places;
  for (std::size_t j = 0; j < layout.junctions.size(); ++j) {
    if (layout.junctions[j].violations() > 0) {
      places.push_back(graph.nodes[static_cast<std::size_t>(graph.junctions[j].node)]);
    }
  }
  return places;
}

search::AnnealingOptions optionsAlone(const sketch::Sketch& sketch,
                                      search::AnnealingOptions options,
                                      std::uint32_t rounds) {
  options.earlier = {};
  options.maxRounds = rounds;
  options.minIterations = std::min(options.minIterations, kShortRound);
  if (sketch.joints.empty()) {
    options.axles.clear();
  }
  return options;
}

bool joinsAll(const sketch::Sketch& sketch,
              const Settings& settings,
              const mechanisms::MechanismTable& table,
              std::uint32_t rounds,
              double work) {
  layout::ConnectionSolver solver(table, settings.connection);
  const layout::LayoutProblem problem = problemOf(sketch, settings);
  search::AnnealingOptions options = optionsAlone(sketch, settings.annealing, rounds);
  options.supply = {};
  options.mostWork = work;
  options.mostWorkUntilWhole = work;
  search::Annealer annealer(problem, solver, std::move(options));
  while (!annealer.advance(kStep)) {
  }
  return isWhole(annealer.best());
}

std::vector<int> linesNear(const sketch::Sketch& sketch, Vec3 at, double radius) {
  std::vector<int> lines;
  for (std::size_t i = 0; i < sketch.lines.size(); ++i) {
    if (nodesNear(sketch.lines[i], at, radius)) {
      lines.push_back(static_cast<int>(i));
    }
  }
  return lines;
}

std::optional<CrowdedPlace> findCrowded(const sketch::Sketch& sketch,
                                        Vec3 at,
                                        double radius,
                                        const Settings& settings,
                                        const mechanisms::MechanismTable& table) {
  Settings alone = settings;
  alone.keeps.clear();
  const auto joined = [&](const std::vector<int>& lines, std::uint32_t rounds, double work) {
    sketch::Sketch near = cutOut(sketch, at, radius, lines);
    addJoints(sketch, at, radius, lines, near);
    return joinsAll(near, alone, table, rounds, work);
  };
  CrowdedPlace place{at, radius, linesNear(sketch, at, radius), {}};
  if (joined(place.lines, kRoundsAlone, kWorkOfAll)) {
    return std::nullopt;
  }
  std::vector<int> staying;
  for (const int line : place.lines) {
    staying.push_back(line);
    if (staying.size() > 1 && !joined(staying, kRoundsOfSome, kWorkOfSome)) {
      staying.pop_back();
      place.without.push_back(line);
    }
  }
  return place.without.empty() ? std::nullopt : std::optional(std::move(place));
}

std::string messageOf(const CrowdedPlace& place) {
  const auto number = [](double value) { return sketch::shortNumber(value); };
  const std::string where =
      place.radius > 0.0 ? "have nodes within " + number(place.radius) + " modules of" : "meet at";
  return "no parts were found that join the lines which " + where + " [" + number(place.at.x) +
         ", " + number(place.at.y) + ", " + number(place.at.z) +
         "], even with nothing else around: " + listOf(place.lines) + "; without " +
         listOf(place.without) + " the others can be joined";
}

}  // namespace liftarm::design
