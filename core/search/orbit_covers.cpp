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
    if (!orbits_.allows(one, axis) || (self.pinned && layer != 0)) {
      return false;
    }
    for (const guide::RunImage& image : orbits_.images(one)) {
      if (!mayBendUnder(image, one, other, axis)) {
        return false;
      }
    }
  }
  return true;
}

bool OrbitCovers::mayBendUnder(const guide::RunImage& image,
                               int run,
                               int mate,
                               lattice::Axis axis) const {
  const std::optional<int> mapped = imageOfMate(run, image, mate);
  // A bent beam whose arms change places is left out.
  if (!mapped || image.run == mate || *mapped == run || image.lifts != kNoLifts) {
    return false;
  }
  if (image.run == run) {
    return image.reversed != (*mapped == mate);
  }
  // Where both have an arm on the mate, these lie at its two ends.
  return *mapped != mate || (orbits_.binding(mate, axis).centred &&
                             layout::cornerIndex(problem_->graph, mate, image.run) !=
                                 layout::cornerIndex(problem_->graph, mate, run));
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

//! The beam across the middle of a run that has bent beams at both ends: on the layer next to
//! theirs, where it can be pinned to them. \param arm The one nearest to the middle.
Beam OrbitCovers::middleBetween(int run,
                                const Beam& arm,
                                const guide::SelfBinding& binding,
                                base::Rng* rng) const {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  const int edges = guideRun.edgeCount();
  std::vector<Beam> middles;
  for (const int holes : lengths_) {
    const int start = (edges + 1 - holes) / 2;
    if ((edges + 1 - holes) % 2 == 0 && start > arm.start && start <= arm.last()) {
      middles.push_back({start, holes, 0, -1});
    }
  }
  if (middles.empty()) {
    return {0, 0, 0, -1};
  }
  Beam middle = middles[rng->below(static_cast<std::uint32_t>(middles.size()))];
  const bool line = binding.pinned || binding.sign < 0 || guideRun.exact;
  middle.layer = arm.layer + (rng->below(2) == 0 ? 1 : -1);
  middle.layer = line ? 0 : std::clamp(middle.layer, -guide::kMaxLayer, guide::kMaxLayer);
  return middle;
}

//! What a mirror that cuts a run in half makes of a beam of it; nothing where the other run of a
//! bent beam has no image there.
std::optional<Beam> OrbitCovers::reversed(int run, lattice::Axis axis, const Beam& beam) const {
  const int edges = problem_->graph.runs[at(run)].edgeCount();
  Beam image{edges - beam.last(), beam.holes, beam.layer * orbits_.binding(run, axis).sign};
  image.form = beam.form;
  image.tail = -beam.tail;
  if (beam.mate < 0) {
    return image;
  }
  for (const guide::RunImage& map : orbits_.images(run)) {
    if (map.run == run && map.reversed) {
      const std::optional<int> mate = imageOfMate(run, map, beam.mate);
      image.mate = mate.value_or(-1);
      return mate ? std::optional(image) : std::nullopt;
    }
  }
  return std::nullopt;
}

bool OrbitCovers::hasRoom(int run, lattice::Axis axis, const Beam& arm) const {
  if (!active() || !orbits_.binding(run, axis).centred) {
    return true;
  }
  const int edges = problem_->graph.runs[at(run)].edgeCount();
  return 2 * arm.solidLast() < edges || 2 * arm.solidStart() > edges;
}

//! The arms that must lie in the first half of a run that a mirror cuts in half, by their start.
//! Nothing where one meets its own image.
std::optional<std::vector<Beam>> OrbitCovers::armsOfHalf(int run,
                                                         lattice::Axis axis,
                                                         std::span<const Beam> fixed) const {
  const int edges = problem_->graph.runs[at(run)].edgeCount();
  std::vector<Beam> arms;
  for (const Beam& arm : fixed) {
    const bool far = 2 * arm.solidStart() > edges;
    const std::optional<Beam> folded = far ? reversed(run, axis, arm) : std::optional(arm);
    if (!folded || !hasRoom(run, axis, *folded)) {
      return std::nullopt;
    }
    if (std::find(arms.begin(), arms.end(), *folded) == arms.end()) {
      arms.push_back(*folded);
    }
  }
  std::sort(
      arms.begin(), arms.end(), [](const Beam& a, const Beam& b) { return a.start < b.start; });
  return arms;
}

//! One half of a cover, its middle, and the half anew from the other end; nothing where the two
//! beams beside the middle would meet.
std::optional<Cover> OrbitCovers::unfolded(int run, const Beam& middle, const Cover& cover) const {
  const int edges = problem_->graph.runs[at(run)].edgeCount();
  Cover mirrored{cover.axis, {}};
  for (const Beam& beam : cover.beams) {
    if (beam == middle) {
      break;
    }
    mirrored.beams.push_back(beam);
  }
  const std::size_t half = mirrored.beams.size();
  if (half > 0 && orbits_.binding(run, cover.axis).sign > 0 &&
      2 * mirrored.beams.back().last() >= edges) {
    return std::nullopt;
  }
  mirrored.beams.push_back(middle);
  for (std::size_t i = half; i > 0; --i) {
    const std::optional<Beam> image = reversed(run, cover.axis, mirrored.beams[i - 1]);
    if (!image) {
      return std::nullopt;
    }
    mirrored.beams.push_back(*image);
  }
  return mirrored;
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
  std::optional<std::vector<Beam>> half = armsOfHalf(run, request.axis, request.fixed);
  if (!half) {
    return std::nullopt;
  }
  const Beam middle = half->empty() ? middleBeam(run, binding, reach, rng)
                                    : middleBetween(run, half->back(), binding, rng);
  if (middle.holes == 0) {
    return std::nullopt;
  }
  half->push_back(middle);
  request.fixed = *half;
  const std::optional<Cover> cover = coverer->propose(*layout, request, rng);
  return cover ? unfolded(run, middle, *cover) : std::nullopt;
}

void OrbitCovers::release(int run, const std::vector<Cover>& covers) {
  orbits_.release(run);
  // A bent beam has images only where both its runs have.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t r = 0; r < covers.size(); ++r) {
      const std::vector<Beam>& beams = covers[r].beams;
      if (binds(static_cast<int>(r)) && std::any_of(beams.begin(), beams.end(), [&](const Beam& b) {
            return b.mate >= 0 && !binds(b.mate);
          })) {
        orbits_.release(static_cast<int>(r));
        changed = true;
      }
    }
  }
}

void OrbitCovers::releaseAt(int junction) {
  for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
    orbits_.release(incidence.run);
  }
}

}  // namespace liftarm::search
