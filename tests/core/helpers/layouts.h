#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/rng.h"
#include "core/helpers/sketches.h"
#include "layout/layout.h"
#include "mechanisms/mechanism_table.h"

// Header only, for the same reason as sketches.h.

namespace liftarm::testing {

//! \brief The default connectors composed to mechanisms of at most two parts; made once.
inline const mechanisms::MechanismTable& defaultTable() {
  static const mechanisms::MechanismTable kTable(mechanisms::composeMechanisms(
      parts::Catalogue::builtIn(), {{"2780", "6558", "87082", "15100", "48989", "55615"}, 2, 9}));
  return kTable;
}

//! \brief A layout problem with all that it needs, for one sketch.
struct LayoutBench {
  explicit LayoutBench(const sketch::Sketch& sketch)
      : problem(layout::makeLayoutProblem(graphOf(sketch))), solver(defaultTable()) {}

  layout::LayoutProblem problem;
  layout::ConnectionSolver solver;
};

//! \brief Some legal cover of a run: beams that overlap by one or two on neighbouring layers, at
//! random sticking out past the ends by one. Collisions with other runs are not looked at.
inline layout::Cover randomCover(const guide::GuideRun& run, base::Rng* rng) {
  constexpr std::array<int, 8> kLengths{2, 3, 5, 7, 9, 11, 13, 15};
  layout::Cover cover;
  cover.axis = run.axes[rng->below(static_cast<std::uint32_t>(run.axes.size()))];
  int start = rng->below(4) == 0 ? -1 : 0;
  int layer = static_cast<int>(rng->below(3)) - 1;
  while (true) {
    std::vector<int> fitting;
    for (const int length : kLengths) {
      const int last = start + length - 1;
      const int before = cover.beams.empty() ? -1 : cover.beams.back().last();
      if (last <= run.edgeCount() + 1 && last > before && last > 0) {
        fitting.push_back(length);
      }
    }
    const int length = fitting[rng->below(static_cast<std::uint32_t>(fitting.size()))];
    cover.beams.push_back({start, length, layer});
    const int last = cover.beams.back().last();
    if (last >= run.edgeCount()) {
      return cover;
    }
    // A third beam is on the first one's layer, maybe: it must not reach back to it.
    const std::size_t count = cover.beams.size();
    const int before = count > 1 ? cover.beams[count - 2].last() : -2;
    const int shared = last - 1 > std::max(before, start) ? 1 + static_cast<int>(rng->below(2)) : 1;
    start = last - shared + 1;
    layer += layer > 0 || (layer > -guide::kMaxLayer && rng->below(2) == 0) ? -1 : 1;
  }
}

//! \brief An axle on a principal run: one that suits the beams there, or some other with bushes at
//! random places.
inline layout::Cover randomAxle(const layout::Layout& layout, int run, base::Rng* rng) {
  const guide::GuideRun& guideRun = layout.problem().graph.runs[static_cast<std::size_t>(run)];
  layout::AxleSite site = layout.axleSite(run);
  if (rng->below(3) == 0) {
    site.seats = rng->below(1U << 10U);
  }
  layout::Cover cover{guideRun.axes.front(), {}};
  cover.axle = layout::layAxle(site, layout::allAxleParts());
  return cover;
}

//! \brief Covers and connections, as text that is equal bit for bit or not.
inline std::string structureOf(const layout::Layout& layout) {
  std::string text;
  const auto put = [&](auto value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (std::size_t r = 0; r < layout.problem().graph.runs.size(); ++r) {
    const layout::RunState& run = layout.run(static_cast<int>(r));
    put(lattice::index(run.cover.axis));
    for (const layout::Beam& beam : run.cover.beams) {
      put(beam.start);
      put(beam.holes);
      put(beam.layer);
    }
    put(run.cover.axle.part);
    put(run.cover.axle.start);
    put(run.cover.axle.turned);
    put(run.cover.axle.bushes);
    put(run.collisions);
    put(run.forbidden);
  }
  for (std::size_t j = 0; j < layout.problem().graph.junctions.size(); ++j) {
    const layout::JunctionState& junction = layout.junction(static_cast<int>(j));
    for (const layout::PlacedMechanism& placed : junction.connection.mechanisms) {
      put(placed.oriented);
      put(placed.at.x);
      put(placed.at.y);
      put(placed.at.z);
    }
    put(junction.connection.failed);
    put(junction.connection.cost);
    put(junction.gaps);
    put(junction.overfull);
    put(junction.leans);
  }
  return text;
}

//! \brief All that revert() must bring back: covers, connections and tallies, bit for bit.
inline std::string fingerprint(const layout::Layout& layout) {
  std::string text = structureOf(layout);
  const auto put = [&](auto value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(layout.weightedViolations());
  const layout::Tallies& t = layout.tallies();
  for (const int count : {t.beams,
                          t.holes,
                          t.layerSquares,
                          t.overhang,
                          t.hinges,
                          t.collisions,
                          t.forbidden,
                          t.gaps,
                          t.overfull,
                          t.failedConnections,
                          t.connectors,
                          t.mechanisms,
                          t.mechanismHeads,
                          t.mechanismCells,
                          t.axles}) {
    put(count);
  }
  put(t.pinHeadRatios);
  put(t.connectionCost);
  return text;
}

}  // namespace liftarm::testing
