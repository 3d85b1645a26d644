#include "search/orbit_covers.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/index.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;
using layout::Beam;
using layout::Cover;

constexpr std::array<int, 3> kNoLifts{};

//! What a symmetry makes of a cover; arms of bent beams still name the mate that they had.
Cover imageOf(const Cover& cover, const guide::RunImage& image, int edges) {
  const std::size_t axis = at(lattice::index(cover.axis));
  Cover mapped{lattice::axisFromIndex(image.axes[axis]), {}};
  for (const Beam& beam : cover.beams) {
    Beam mirrored = beam;
    mirrored.start = image.reversed ? edges - beam.last() : beam.start;
    mirrored.layer = image.layerOf(beam.layer, axis);
    mirrored.tail = image.reversed ? -beam.tail : beam.tail;
    mapped.beams.push_back(mirrored);
  }
  if (image.reversed) {
    std::reverse(mapped.beams.begin(), mapped.beams.end());
  }
  return mapped;
}

//! Beams of a cover with this middle beam, about: what lies on either side takes the longest.
int beamsAround(const Beam& middle) {
  const int side = std::max(0, middle.start);
  return layout::partsOfBeam(middle.holes) +
         2 * ((side + guide::kLongestBeam - 1) / guide::kLongestBeam);
}

//! One half of a cover, its middle, and the half anew from the other end; nothing where the two
//! beams beside the middle would meet.
std::optional<Cover> mirroredAbout(const Beam& middle, const Cover& cover, int edges, int sign) {
  Cover mirrored{cover.axis, {}};
  for (const Beam& beam : cover.beams) {
    if (beam == middle) {
      break;
    }
    mirrored.beams.push_back(beam);
  }
  const std::size_t half = mirrored.beams.size();
  if (half > 0 && sign > 0 && 2 * mirrored.beams.back().last() >= edges) {
    return std::nullopt;
  }
  mirrored.beams.push_back(middle);
  for (std::size_t i = half; i > 0; --i) {
    const Beam beam = mirrored.beams[i - 1];
    mirrored.beams.push_back({edges - beam.last(), beam.holes, beam.layer * sign, -1});
  }
  return mirrored;
}

}  // namespace

OrbitCovers::OrbitCovers(const layout::LayoutProblem& problem, std::vector<int> lengths)
    : problem_(&problem), lengths_(std::move(lengths)) {
  if (!problem.graph.symmetries.empty()) {
    orbits_ = guide::Orbits(problem.graph);
  }
}

void OrbitCovers::place(layout::Layout* layout, int run, const Cover& cover) const {
  layout->setCover(run, cover);
  const int edges = problem_->graph.runs[at(run)].edgeCount();
  for (const guide::RunImage& image : orbits_.images(run)) {
    if (image.run != run) {
      Cover mapped = imageOf(cover, image, edges);
      for (Beam& beam : mapped.beams) {
        if (beam.mate >= 0) {
          const std::optional<int> mate = imageOfMate(run, image, beam.mate);
          LIFTARM_CHECK(mate.has_value(), "a bent beam is laid only where its images have room");
          beam.mate = *mate;
        }
      }
      layout->setCover(image.run, std::move(mapped));
    }
  }
}

//! Where a symmetry takes the other run of a bent beam: the image of it that meets the image of
//! this one where it should.
std::optional<int> OrbitCovers::imageOfMate(int run, const guide::RunImage& image, int mate) const {
  const guide::GuidingGraph& graph = problem_->graph;
  const int corner = layout::cornerIndex(graph, run, mate);
  const int mapped = image.reversed ? graph.runs[at(run)].edgeCount() - corner : corner;
  std::vector<int> candidates{mate};
  for (const guide::RunImage& other : orbits_.images(mate)) {
    candidates.push_back(other.run);
  }
  for (const int candidate : candidates) {
    if (candidate != image.run && layout::commonJunction(graph, image.run, candidate) >= 0 &&
        layout::cornerIndex(graph, image.run, candidate) == mapped) {
      return candidate;
    }
  }
  return std::nullopt;
}

bool OrbitCovers::mayBend(int run, int mate, lattice::Axis axis, int layer) const {
  if (!active()) {
    return true;
  }
  for (const auto& [one, other] : {std::pair(run, mate), std::pair(mate, run)}) {
    const guide::SelfBinding self = orbits_.binding(one, axis);
    if (!orbits_.allows(one, axis) || self.centred || (self.pinned && layer != 0)) {
      return false;
    }
    for (const guide::RunImage& image : orbits_.images(one)) {
      const std::optional<int> mapped = imageOfMate(one, image, other);
      // A bent beam whose arms change places, or that shares a run with its image, is left out.
      if (!mapped || image.run == other || *mapped == one || image.lifts != kNoLifts ||
          (image.run == one) != (*mapped == other)) {
        return false;
      }
    }
  }
  return true;
}

int OrbitCovers::farthestLift(int run, lattice::Axis axis) const {
  int lift = 0;
  if (!active()) {
    return lift;
  }
  for (const guide::RunImage& image : orbits_.images(run)) {
    lift = std::max(lift, std::abs(image.lifts[at(lattice::index(axis))]));
  }
  return lift;
}

//! The beam across the middle of a run that reads the same from both ends; holes 0: none fits.
Beam OrbitCovers::middleBeam(int run,
                             const guide::SelfBinding& binding,
                             int reach,
                             base::Rng* rng) const {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  const int edges = guideRun.edgeCount();
  const int over = guideRun.exact ? 0 : 1;
  std::vector<Beam> middles;
  for (const int holes : lengths_) {
    if ((edges + 1 - holes) % 2 == 0 && holes <= edges + 1 + 2 * over) {
      middles.push_back({(edges + 1 - holes) / 2, holes, 0, -1});
    }
  }
  if (middles.empty()) {
    return {0, 0, 0, -1};
  }
  if (rng->unit() < kTuning.moves.cheapMiddle) {
    int fewest = beamsAround(middles[0]);
    for (const Beam& middle : middles) {
      fewest = std::min(fewest, beamsAround(middle));
    }
    middles.erase(
        std::remove_if(
            middles.begin(), middles.end(), [&](const Beam& b) { return beamsAround(b) > fewest; }),
        middles.end());
  }
  Beam middle = middles[rng->below(static_cast<std::uint32_t>(middles.size()))];
  const bool line = binding.pinned || binding.sign < 0 || guideRun.exact || reach == 0;
  if (!line && rng->unit() >= kTuning.moves.middleOnLine) {
    middle.layer = static_cast<int>(rng->below(static_cast<std::uint32_t>(2 * reach + 1))) - reach;
  }
  return middle;
}

std::optional<Cover> OrbitCovers::propose(RunCoverer* coverer,
                                          layout::Layout* layout,
                                          CoverRequest request,
                                          base::Rng* rng) const {
  const int run = request.run;
  if (!orbits_.allows(run, request.axis)) {
    return std::nullopt;
  }
  place(layout, run, {request.axis, {}});
  const guide::SelfBinding binding = orbits_.binding(run, request.axis);
  int& reach = request.manner.reach;
  reach = binding.pinned ? 0 : std::min(reach, guide::kMaxLayer - farthestLift(run, request.axis));
  if (!binding.centred) {
    return coverer->propose(*layout, request, rng);
  }
  const Beam middle = middleBeam(run, binding, reach, rng);
  if (middle.holes == 0) {
    return std::nullopt;
  }
  request.fixed = {&middle, 1};
  const std::optional<Cover> cover = coverer->propose(*layout, request, rng);
  if (!cover) {
    return std::nullopt;
  }
  return mirroredAbout(middle, *cover, problem_->graph.runs[at(run)].edgeCount(), binding.sign);
}

void OrbitCovers::releaseAt(int junction) {
  for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
    orbits_.release(incidence.run);
  }
}

}  // namespace liftarm::search
