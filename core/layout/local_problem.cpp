#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "layout/connection_solver.h"

namespace liftarm::layout {

namespace {

//! Connectors on another lattice than the box's keep this far from its cells, on some axis.
constexpr double kApart = 0.95;

}  // namespace

void LocalProblem::clear() {
  for (const int cell : touched_) {
    content_[static_cast<std::size_t>(cell)] = 0;
  }
  touched_.clear();
  holes_.clear();
  terminals = 0;
  isJoint = false;
  frames = 0;
  group.fill(-1);
  for (std::size_t t = 0; t < cluster.size(); ++t) {
    cluster[t] = static_cast<std::int8_t>(t);
  }
}

void LocalProblem::touch(int cell) {
  if (content_[static_cast<std::size_t>(cell)] == 0) {
    touched_.push_back(cell);
  }
}

void LocalProblem::block(int cell) {
  touch(cell);
  content_[static_cast<std::size_t>(cell)] = -1;
}

void LocalProblem::blockAround(lattice::Vec3 middle) {
  const lattice::Cell low{static_cast<int>(std::floor(middle.x)),
                          static_cast<int>(std::floor(middle.y)),
                          static_cast<int>(std::floor(middle.z))};
  for (int corner = 0; corner < 8; ++corner) {
    const lattice::Cell c = low + lattice::Cell{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
    const lattice::Vec3 d = lattice::toVec3(c) - middle;
    if (inBox(c) && std::abs(d.x) < kApart && std::abs(d.y) < kApart && std::abs(d.z) < kApart) {
      block(boxIndex(c));
    }
  }
}

void LocalProblem::addHole(const LocalHole& hole) {
  const int cell = boxIndex(hole.at);
  touch(cell);
  std::int16_t& content = content_[static_cast<std::size_t>(cell)];
  if (content > 0) {
    content = -1;
    return;
  }
  holes_.push_back(hole);
  content = static_cast<std::int16_t>(holes_.size());
}

void LocalProblem::useHole(int cell) {
  const std::int16_t content = content_[static_cast<std::size_t>(cell)];
  if (content > 0) {
    holes_[static_cast<std::size_t>(content - 1)].used = true;
  } else {
    block(cell);
  }
}

void LocalProblem::join(int terminalA, int terminalB) {
  const std::int8_t from = cluster[static_cast<std::size_t>(terminalB)];
  const std::int8_t to = cluster[static_cast<std::size_t>(terminalA)];
  std::replace(cluster.begin(), cluster.end(), from, to);
}

const LocalHole* LocalProblem::holeAt(int cell) const {
  const std::int16_t content = content_[static_cast<std::size_t>(cell)];
  return content > 0 ? &holes_[static_cast<std::size_t>(content - 1)] : nullptr;
}

bool LocalProblem::blocked(int cell) const {
  return content_[static_cast<std::size_t>(cell)] < 0;
}

std::uint64_t LocalProblem::hash() const {
  std::uint64_t sum = 0;  // each cell was touched once, so a sum does not depend on the order
  for (const int cell : touched_) {
    const std::int16_t content = content_[static_cast<std::size_t>(cell)];
    std::uint64_t code = 0;
    if (content > 0) {
      const LocalHole& hole = holes_[static_cast<std::size_t>(content - 1)];
      code = 2U + static_cast<std::uint64_t>(hole.terminal + 1) * 8U +
             static_cast<std::uint64_t>(lattice::index(hole.axis)) * 2U + (hole.used ? 1U : 0U);
    }
    sum += base::mixHash(static_cast<std::uint64_t>(cell), code);
  }
  std::uint64_t hash = base::mixHash(sum, static_cast<std::uint64_t>(terminals));
  for (int t = 0; t < terminals; ++t) {
    const auto at = static_cast<std::size_t>(t);
    hash = base::mixHash(hash, static_cast<std::uint64_t>(cluster[at] * 64 + group[at] + 1));
  }
  if (frames != 0) {
    hash = base::mixHash(hash, frames);
  }
  return base::mixHash(hash,
                       isJoint ? 1U + static_cast<std::uint64_t>(lattice::index(jointAxis)) : 0U);
}

}  // namespace liftarm::layout
