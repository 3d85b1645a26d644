#include <algorithm>

#include "search/annealer.h"
#include "search/arm_costs.h"

// Moves that lay frames and take them off: a frame covers stretches of several runs at once.

namespace liftarm::search {

namespace {

constexpr double kLeastSaved = 0.5;  // beams, about
constexpr std::uint32_t kMostFollowers = 7;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

//! The beams of a cover without one arm.
layout::Cover withoutArm(layout::Cover cover, const layout::Beam& arm) {
  cover.beams.erase(std::remove(cover.beams.begin(), cover.beams.end(), arm), cover.beams.end());
  return cover;
}

}  // namespace

//! Sites where a frame and what its runs need beside it are fewer beams than these runs need
//! without. Where there is none the search draws no random number for frames.
void Annealer::findUsefulSites() {
  for (std::size_t s = 0; s < problem_->sites.size() && options_.parts.frames; ++s) {
    const layout::FrameSite& site = problem_->sites[s];
    double saved = -1.0;
    for (const layout::SiteArm& arm : site.arms) {
      saved += static_cast<double>(fewestBeams_[at(arm.run)]) -
               beamsBeside(arm.beam, problem_->graph.runs[at(arm.run)].edgeCount());
    }
    if (saved >= kLeastSaved && contains(options_.frames, site.frame)) {
      frameSites_.push_back(static_cast<int>(s));
    }
  }
}

//! Begins anew where the best layout has frames and cannot be built: without the holes across their
//! bars, then without frames. \return False when there is nothing to mend.
bool Annealer::withdrawFrames() {
  const bool framed =
      std::any_of(best_.covers.begin(), best_.covers.end(), [](const layout::Cover& cover) {
        return std::any_of(cover.beams.begin(), cover.beams.end(), [](const layout::Beam& beam) {
          return beam.site >= 0;
        });
      });
  if (!framed || isBuildable(best_)) {
    return false;
  }
  if (!acrossFrames_) {
    frameSites_.clear();
  }
  acrossFrames_ = false;
  layout_.setAcross(false);
  startOver();
  return true;
}

//! Whether no symmetry binds a site's runs, and all have its hole axis or may turn to it.
bool Annealer::mayLieAt(const layout::FrameSite& site) const {
  return std::all_of(site.arms.begin(), site.arms.end(), [&](const layout::SiteArm& arm) {
    return !orbits_.binds(arm.run) && mustHaveAxle_[at(arm.run)] == 0 &&
           (options_.parts.turns || layout_.run(arm.run).cover.axis == site.axis);
  });
}

//! Takes off the bent beam or the frame that an arm on a run belongs to, and adds its other runs to
//! a list.
void Annealer::takeOff(int run, const layout::Beam& arm, std::vector<int>* bare) {
  const auto strip = [&](int other, const auto& belongs) {
    const layout::Cover cover = layout_.run(other).cover;
    const auto found = std::find_if(cover.beams.begin(), cover.beams.end(), belongs);
    if (found != cover.beams.end()) {
      layout_.setCover(other, withoutArm(cover, *found));
    }
    if (other != run && !contains(*bare, other)) {
      bare->push_back(other);
    }
  };
  if (arm.site < 0) {
    strip(arm.mate, [&](const layout::Beam& beam) { return beam.mate == run; });
    strip(run, [&](const layout::Beam& beam) { return beam == arm; });
    return;
  }
  for (const layout::SiteArm& other : problem_->sites[at(arm.site)].arms) {
    strip(other.run, [&](const layout::Beam& beam) { return beam.site == arm.site; });
  }
}

//! Takes a frame off its other runs, which are covered anew. \pre It is off this one.
bool Annealer::takeFrameOff(int run, int site, double noise) {
  std::vector<int> bare;
  layout::Beam bar;
  bar.site = site;
  takeOff(run, bar, &bare);
  bool changed = false;
  for (const int other : bare) {
    const layout::Cover& cover = layout_.run(other).cover;
    const std::vector<layout::Beam> kept = layout::armsOf(cover);
    changed = coverRun(other, cover.axis, noise, kept) || changed;
  }
  return changed;
}

//! Lets some of the runs follow that cross those whose layers have changed along their length.
void Annealer::followCrossing(const std::vector<int>& covered, double noise) {
  const std::uint32_t followers = rng_.below(kMostFollowers);
  for (std::uint32_t i = 0; i < followers; ++i) {
    const int run = covered[rng_.below(static_cast<std::uint32_t>(covered.size()))];
    const int other = pickPartner(run);
    if (other >= 0 && !contains(covered, other)) {
      recover(other, noise);
    }
  }
}

//! Lays a frame at some place where it may save beams. What lies in its way goes, and the rest of
//! its runs is covered anew.
bool Annealer::layFrame(double noise) {
  const int id = frameSites_[rng_.below(static_cast<std::uint32_t>(frameSites_.size()))];
  const layout::FrameSite& site = problem_->sites[at(id)];
  const int layer = site.exact ? 0 : static_cast<int>(rng_.below(3)) - 1;
  if (!mayLieAt(site)) {
    return false;
  }
  std::vector<int> covered;
  for (const layout::SiteArm& arm : site.arms) {
    covered.push_back(arm.run);
  }
  for (const layout::SiteArm& arm : site.arms) {
    const layout::Cover cover = layout_.run(arm.run).cover;
    for (const layout::Beam& other : layout::armsOf(cover)) {
      if (cover.axis != site.axis || meetsAny(arm.beam, {other})) {
        takeOff(arm.run, other, &covered);
      }
    }
  }
  std::vector<std::vector<layout::Beam>> fixed;
  std::vector<lattice::Axis> axes;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const layout::Cover cover = layout_.run(covered[i]).cover;
    fixed.push_back(layout::armsOf(cover));
    axes.push_back(i < site.arms.size() ? site.axis : cover.axis);
    if (i < site.arms.size()) {
      fixed.back().push_back(site.arms[i].beam);
      fixed.back().back().layer = layer;
    }
    layout_.setCover(covered[i], {axes.back(), {}});
  }
  for (std::size_t i = 0; i < covered.size(); ++i) {
    if (!coverRun(covered[i], axes[i], noise, fixed[i])) {
      return false;
    }
  }
  followCrossing(covered, noise);
  return true;
}

}  // namespace liftarm::search
