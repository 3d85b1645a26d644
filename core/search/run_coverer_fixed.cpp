#include <algorithm>

#include "search/run_coverer.h"

// Beams that a cover must have: arms of bent beams and bars of frames.

namespace liftarm::search {

namespace {

using layout::Beam;
using layout::Cover;

constexpr double kFixedBonus = 1e7;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

void RunCoverer::setFixed(std::vector<Beam> fixed) {
  fixed_ = std::move(fixed);
  lengths_ = allowed_;
  for (const Beam& beam : fixed_) {
    const auto place = std::lower_bound(lengths_.begin(), lengths_.end(), beam.holes);
    if (place == lengths_.end() || *place != beam.holes) {
      lengths_.insert(place, beam.holes);
    }
  }
}

//! Place of a length among those allowed, or -1.
int RunCoverer::allowedPlace(std::size_t length) const {
  if (lengths_.size() == allowed_.size()) {
    return static_cast<int>(length);
  }
  const auto found = std::find(allowed_.begin(), allowed_.end(), lengths_[length]);
  return found == allowed_.end() ? -1 : static_cast<int>(found - allowed_.begin());
}

//! Makes the fixed beams irresistible, and what stands in their place impossible.
void RunCoverer::favourFixed() {
  for (const Beam& fixed : fixed_) {
    for (int start = -1; start <= edges_; ++start) {
      for (std::size_t n = 0; n < lengths_.size(); ++n) {
        const int last = start + lengths_[n] - 1;
        if (start == fixed.start && lengths_[n] == fixed.holes) {
          beamCost_[beamIndex(start, n, fixed.layer)] -=
              allowedPlace(n) < 0 ? kNever + kFixedBonus : kFixedBonus;
        } else if (last <= edges_ + 1 && start <= fixed.solidLast() && last >= fixed.solidStart()) {
          beamCost_[beamIndex(start, n, fixed.layer)] += kForbidden;
        }
      }
    }
  }
}

//! Notes where no beam can be pinned to a fixed one.
void RunCoverer::markCrossedHoles() {
  crossed_.clear();
  for (const Beam& fixed : fixed_) {
    for (int node = fixed.start; node <= fixed.last() && fixed.crossed != 0; ++node) {
      crossed_.resize(value_.size(), 0);
      crossed_[at(stateOf(node, fixed.layer))] = fixed.hasHoleAt(node) ? 0 : 1;
    }
  }
}

bool RunCoverer::isCrossed(int node, int layer) const {
  return !crossed_.empty() && crossed_[at(stateOf(node, layer))] != 0;
}

//! Marks the arms of bent beams in a cover; false when one is missing, or its axle hole's place is
//! taken.
bool RunCoverer::markFixed(Cover* cover) const {
  return std::all_of(fixed_.begin(), fixed_.end(), [&](const Beam& fixed) {
    bool found = false;
    for (Beam& beam : cover->beams) {
      if (beam.start == fixed.start && beam.holes == fixed.holes && beam.layer == fixed.layer) {
        beam = fixed;
        found = true;
      } else if (beam.layer == fixed.layer && beam.solidStart() <= fixed.solidLast() &&
                 beam.solidLast() >= fixed.solidStart()) {
        return false;
      }
    }
    return found;
  });
}

}  // namespace liftarm::search
