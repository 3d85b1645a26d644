#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/index.h"
#include "search/moves.h"

namespace liftarm::search {

namespace {

using base::at;

//! What a layer becomes: turned over or not, then shifted.
struct LayerMap {
  int sign = 1;
  int shift = 0;

  [[nodiscard]] int of(int layer) const { return sign * layer + shift; }
};

constexpr std::array<LayerMap, 5> kMaps{{{1, 1}, {1, -1}, {-1, 0}, {-1, 1}, {-1, -1}}};

const std::vector<guide::RunImage> kNoImages;

//! The runs that hang together with this one by junctions and have its hole axis: its component.
std::vector<int> planeOf(const SearchState& state, int run) {
  const guide::GuidingGraph& graph = state.graph();
  const lattice::Axis axis = state.coverOf(run).axis;
  std::vector<int> plane{run};
  std::vector<std::uint8_t> seen(graph.runs.size(), 0);
  seen[at(run)] = 1;
  for (std::size_t next = 0; next < plane.size(); ++next) {
    for (const int junction : graph.runs[at(plane[next])].junctions) {
      for (const guide::Incidence& incidence : graph.junctions[at(junction)].incident) {
        if (seen[at(incidence.run)] == 0 && state.coverOf(incidence.run).axis == axis) {
          seen[at(incidence.run)] = 1;
          plane.push_back(incidence.run);
        }
      }
    }
  }
  return plane;
}

//! Whether the beams of a run may take their new layers: false for an exact line, a frame, an axle,
//! where something is kept, and where a layer would be too far.
bool mayShift(const SearchState& state, int run, const LayerMap& map) {
  const layout::Cover& cover = state.coverOf(run);
  if (state.graph().runs[at(run)].exact || cover.axle.used() ||
      state.problem().keepOf(run) != nullptr) {
    return false;
  }
  return std::all_of(cover.beams.begin(), cover.beams.end(), [&](const layout::Beam& beam) {
    return beam.site < 0 && std::abs(map.of(beam.layer)) <= guide::kMaxLayer;
  });
}

//! Whether symmetries let a run of a plane shift: false where a mirror turns the plane over, or
//! beams pass each other in one.
bool imagesMayShift(const SearchState& state, int run, const std::vector<int>& plane) {
  const OrbitCovers& orbits = state.covering().orbits();
  if (!orbits.binds(run)) {
    return true;
  }
  const lattice::Axis axis = state.coverOf(run).axis;
  const auto place = at(lattice::index(axis));
  for (const guide::RunImage& image : orbits.orbits().images(run)) {
    const bool inPlane = std::find(plane.begin(), plane.end(), image.run) != plane.end();
    if ((inPlane && image.signs[place] < 0) || image.lifts[place] != 0) {
      return false;
    }
  }
  const guide::SelfBinding binding = orbits.orbits().binding(run, axis);
  return !binding.pinned && binding.sign >= 0;
}

}  // namespace

bool shiftPlane(SearchState& state, const MoveContext& context) {
  const LayerMap map = kMaps[state.rng().below(static_cast<std::uint32_t>(kMaps.size()))];
  const std::vector<int> plane = planeOf(state, context.pick.run);
  if (!std::all_of(plane.begin(), plane.end(), [&](int run) {
        return mayShift(state, run, map) && imagesMayShift(state, run, plane);
      })) {
    return false;
  }
  const OrbitCovers& orbits = state.covering().orbits();
  std::vector<std::uint8_t> shifted(state.graph().runs.size(), 0);
  for (const int run : plane) {
    if (shifted[at(run)] != 0) {
      continue;  // with one of its images
    }
    shifted[at(run)] = 1;
    for (const guide::RunImage& image : orbits.active() ? orbits.orbits().images(run) : kNoImages) {
      shifted[at(image.run)] = 1;
    }
    layout::Cover cover = state.coverOf(run);
    for (layout::Beam& beam : cover.beams) {
      beam.layer = map.of(beam.layer);
    }
    state.place(run, cover);
  }
  return true;
}

}  // namespace liftarm::search
