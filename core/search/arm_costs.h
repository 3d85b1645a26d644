#pragma once

#include <algorithm>
#include <vector>

#include "guide/beam_bound.h"
#include "layout/beam.h"
#include "search/tuning.h"

namespace liftarm::search {

//! \brief Straight beams that the rest of a run needs beside an arm, about; each end of the arm
//! that sticks out counts a little besides. \param edges Of the run.
inline double beamsBeside(const layout::Beam& arm, int edges) {
  const auto beams = [](int left) {
    return left <= 0 ? 0 : (left + guide::kLongestBeam - 1) / guide::kLongestBeam;
  };
  const int past = (arm.solidStart() < 0 ? 1 : 0) + (arm.solidLast() > edges ? 1 : 0);
  return static_cast<double>(beams(arm.start) + beams(edges - arm.last())) +
         kTuning.moves.sticksOut * static_cast<double>(past);
}

//! \brief Whether an arm would share a node with one of these.
inline bool meetsAny(const layout::Beam& arm, const std::vector<layout::Beam>& others) {
  return std::any_of(others.begin(), others.end(), [&](const layout::Beam& other) {
    return arm.solidStart() <= other.solidLast() && arm.solidLast() >= other.solidStart();
  });
}

}  // namespace liftarm::search
