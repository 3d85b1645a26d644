#pragma once

#include <vector>

#include "sketch/arrangement.h"

namespace liftarm::sketch {

//! More than this many are not listed: a drawing with so many has no use for the rest.
inline constexpr std::size_t kMaxCrossings = 10000;

//! \brief Finds runs that meet within kSamePoint where not both have a node, or that overlap out of
//! step. \details Each pair of runs once, ordered by their numbers. Only unit edges in one cell of
//! the lattice are compared, so that the time grows with the length of the lines. \pre nodes and
//! runs of the arrangement are complete.
std::vector<OffNodeCrossing> findOffNodeCrossings(const Arrangement& arrangement);

//! Lines this near to each other that do not touch were most likely meant to.
inline constexpr double kNearMiss = 0.1;

//! \brief Two runs without a common node that come near each other and do not touch.
struct NearMiss {
  int runA = -1;
  int runB = -1;
  int edgeA = -1;  //!< of run A
  int edgeB = -1;
  lattice::Vec3 pointA;  //!< the nearest points
  lattice::Vec3 pointB;

  [[nodiscard]] double gap() const { return lattice::length(pointB - pointA); }
};

//! \brief Finds runs that miss each other by more than kSamePoint and at most kNearMiss.
//! \details Each pair of runs once, where they are nearest, ordered by their numbers.
std::vector<NearMiss> findNearMisses(const Arrangement& arrangement);

}  // namespace liftarm::sketch
