#include <algorithm>
#include <cstdlib>

#include "search/annealer.h"

// All beams of one plane change layers together: what no move of single runs can do, since beams
// that cross must stay on layers of their own.

namespace liftarm::search {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

//! What a layer becomes: turned over or not, then shifted.
struct LayerMap {
  int sign = 1;
  int shift = 0;

  [[nodiscard]] int of(int layer) const { return sign * layer + shift; }
};

constexpr std::array<LayerMap, 5> kMaps{{{1, 1}, {1, -1}, {-1, 0}, {-1, 1}, {-1, -1}}};

const std::vector<guide::RunImage> kNoImages;

}  // namespace

//! The runs that hang together with this one by junctions and have its hole axis: its component.
std::vector<int> Annealer::planeOf(int run) const {
  const lattice::Axis axis = layout_.run(run).cover.axis;
  std::vector<int> plane{run};
  std::vector<std::uint8_t> seen(problem_->graph.runs.size(), 0);
  seen[at(run)] = 1;
  for (std::size_t next = 0; next < plane.size(); ++next) {
    for (const int junction : problem_->graph.runs[at(plane[next])].junctions) {
      for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
        if (seen[at(incidence.run)] == 0 && layout_.run(incidence.run).cover.axis == axis) {
          seen[at(incidence.run)] = 1;
          plane.push_back(incidence.run);
        }
      }
    }
  }
  return plane;
}

//! Shifts a component's layers by one or turns it over, its images with it. \return False where an
//! exact line, a frame, an axle, a mirror, beams that pass each other in one, or the farthest layer
//! forbids it.
bool Annealer::shift(int run) {
  const LayerMap map = kMaps[rng_.below(static_cast<std::uint32_t>(kMaps.size()))];
  const std::vector<int> plane = planeOf(run);
  const auto inPlane = [&](int r) {
    return std::find(plane.begin(), plane.end(), r) != plane.end();
  };
  for (const int r : plane) {
    const layout::Cover& cover = layout_.run(r).cover;
    if (problem_->graph.runs[at(r)].exact || cover.axle.used()) {
      return false;
    }
    for (const layout::Beam& beam : cover.beams) {
      if (beam.site >= 0 || std::abs(map.of(beam.layer)) > guide::kMaxLayer) {
        return false;
      }
    }
    if (!orbits_.binds(r)) {
      continue;
    }
    const guide::SelfBinding binding = orbits_.orbits().binding(r, cover.axis);
    const auto axis = at(lattice::index(cover.axis));
    for (const guide::RunImage& image : orbits_.orbits().images(r)) {
      if ((inPlane(image.run) && image.signs[axis] < 0) || image.lifts[axis] != 0) {
        return false;
      }
    }
    if (binding.pinned || binding.sign < 0) {
      return false;
    }
  }
  std::vector<std::uint8_t> shifted(problem_->graph.runs.size(), 0);
  for (const int r : plane) {
    if (shifted[at(r)] != 0) {
      continue;  // with one of its images
    }
    shifted[at(r)] = 1;
    for (const guide::RunImage& image : orbits_.active() ? orbits_.orbits().images(r) : kNoImages) {
      shifted[at(image.run)] = 1;
    }
    layout::Cover cover = layout_.run(r).cover;
    for (layout::Beam& beam : cover.beams) {
      beam.layer = map.of(beam.layer);
    }
    place(r, cover);
  }
  return true;
}

}  // namespace liftarm::search
