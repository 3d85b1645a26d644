#include "mechanisms/mechanism_table.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace liftarm::mechanisms {

namespace {

using lattice::Axis;
using lattice::Cell;

constexpr int kSide = 2 * MechanismTable::kReach + 1;
constexpr double kBodyCost = 0.15;  // per body cell, in parts: prefers high pin-head ratios
constexpr double kHeadCost = 0.02;  // per head: of two equals the smaller one

bool inReach(Cell c) {
  const int reach = MechanismTable::kReach;
  return c.x >= -reach && c.x <= reach && c.y >= -reach && c.y <= reach && c.z >= -reach &&
         c.z <= reach;
}

std::size_t bucketIndex(Cell offset, Axis a, Axis b) {
  const int reach = MechanismTable::kReach;
  const int place = ((offset.x + reach) * kSide + offset.y + reach) * kSide + offset.z + reach;
  return static_cast<std::size_t>((place * 3 + lattice::index(a)) * 3 + lattice::index(b));
}

using OrientedKey = std::vector<std::tuple<int, int, int, bool, int>>;

//! Mechanisms that are the same up to a shift are one; the axis of a plain body does not matter.
OrientedKey orientedKey(const Mechanism& m) {
  OrientedKey key;
  const Cell base = m.cells.front().at;
  for (const MechanismCell& c : m.cells) {
    const Cell at = c.at - base;
    key.emplace_back(at.x, at.y, at.z, c.head, c.head ? lattice::index(c.axis) : 0);
  }
  std::sort(key.begin(), key.end());
  return key;
}

}  // namespace

MechanismTable::MechanismTable(const std::vector<Mechanism>& mechanisms)
    : buckets_(static_cast<std::size_t>(kSide * kSide * kSide * 9)) {
  for (const Mechanism& mechanism : mechanisms) {
    std::set<OrientedKey> seen;
    for (const lattice::Mat3& rotation : lattice::latticeRotations()) {
      Mechanism shape = rotated(mechanism, rotation);
      if (!seen.insert(orientedKey(shape)).second) {
        continue;
      }
      const int heads = shape.headCount();
      const int bodies = static_cast<int>(shape.cells.size()) - heads;
      const double cost = static_cast<double>(shape.parts.size()) +
                          kBodyCost * static_cast<double>(bodies) +
                          kHeadCost * static_cast<double>(heads);
      oriented_.push_back({std::move(shape), heads, cost});
    }
  }
  for (std::size_t id = 0; id < oriented_.size(); ++id) {
    const OrientedMechanism& o = oriented_[id];
    for (int a = 0; a < o.heads; ++a) {
      for (int b = 0; b < o.heads; ++b) {
        const MechanismCell& headA = o.shape.cells[static_cast<std::size_t>(a)];
        const MechanismCell& headB = o.shape.cells[static_cast<std::size_t>(b)];
        if (a != b && inReach(headB.at - headA.at)) {
          buckets_[bucketIndex(headB.at - headA.at, headA.axis, headB.axis)].push_back(
              {static_cast<std::int32_t>(id), a, b});
        }
      }
    }
  }
  for (std::vector<TableEntry>& bucket : buckets_) {
    std::stable_sort(bucket.begin(), bucket.end(), [&](const TableEntry& x, const TableEntry& y) {
      return oriented(x.mechanism).cost < oriented(y.mechanism).cost;
    });
  }
}

const std::vector<TableEntry>& MechanismTable::between(Cell offset, Axis axisA, Axis axisB) const {
  static const std::vector<TableEntry> kNone;
  return inReach(offset) ? buckets_[bucketIndex(offset, axisA, axisB)] : kNone;
}

}  // namespace liftarm::mechanisms
