#include "mechanisms/mechanism_table.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace liftarm::mechanisms {
namespace {

using lattice::Axis;
using lattice::Cell;

const MechanismTable& table() {
  static const MechanismTable kTable(composeMechanisms(
      parts::Catalogue::builtIn(), {{"2780", "6558", "87082", "15100", "48989", "55615"}, 2, 9}));
  return kTable;
}

template <typename Visit>
void forAllBuckets(Visit visit) {
  const int reach = MechanismTable::kReach;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        for (int a = 0; a < 3; ++a) {
          for (int b = 0; b < 3; ++b) {
            visit(Cell{x, y, z}, lattice::axisFromIndex(a), lattice::axisFromIndex(b));
          }
        }
      }
    }
  }
}

using EntryKey = std::tuple<int, int, int>;

TEST(MechanismTable, LooksUpTheSameWaysFromEitherHole) {
  forAllBuckets([](Cell offset, Axis a, Axis b) {
    std::set<EntryKey> there;
    std::set<EntryKey> back;
    for (const TableEntry& entry : table().between(offset, a, b)) {
      there.insert({entry.mechanism, entry.headA, entry.headB});
    }
    for (const TableEntry& entry : table().between(Cell{} - offset, b, a)) {
      back.insert({entry.mechanism, entry.headB, entry.headA});
    }
    EXPECT_EQ(there, back);
  });
}

TEST(MechanismTable, EntriesHaveHeadsThatFitBothHoles) {
  forAllBuckets([](Cell offset, Axis a, Axis b) {
    for (const TableEntry& entry : table().between(offset, a, b)) {
      const OrientedMechanism& m = table().oriented(entry.mechanism);
      const MechanismCell& headA = m.shape.cells[static_cast<std::size_t>(entry.headA)];
      const MechanismCell& headB = m.shape.cells[static_cast<std::size_t>(entry.headB)];
      EXPECT_TRUE(headA.head && headB.head);
      EXPECT_EQ(headA.axis, a);
      EXPECT_EQ(headB.axis, b);
      EXPECT_EQ(headB.at - headA.at, offset);
    }
  });
}

TEST(MechanismTable, ListsTheCheapestFirst) {
  forAllBuckets([](Cell offset, Axis a, Axis b) {
    double last = 0.0;
    for (const TableEntry& entry : table().between(offset, a, b)) {
      EXPECT_GE(table().oriented(entry.mechanism).cost, last);
      last = table().oriented(entry.mechanism).cost;
    }
  });
}

TEST(MechanismTable, JoinsStackedHolesByTheShortPinFirst) {
  const std::vector<TableEntry>& ways = table().between({0, 0, 1}, Axis::kZ, Axis::kZ);
  ASSERT_FALSE(ways.empty());
  const Mechanism& shape = table().oriented(ways.front().mechanism).shape;
  ASSERT_EQ(shape.parts.size(), 1U);
  EXPECT_EQ(shape.parts.front().id, "2780");
}

TEST(MechanismTable, KnowsEachShapeInEachOrientationOnce) {
  std::set<std::set<std::tuple<int, int, int, bool, int>>> seen;
  for (std::size_t id = 0; id < table().size(); ++id) {
    const Mechanism& shape = table().oriented(static_cast<int>(id)).shape;
    std::set<std::tuple<int, int, int, bool, int>> key;
    const Cell base = shape.cells.front().at;
    for (const MechanismCell& cell : shape.cells) {
      const Cell p = cell.at - base;
      key.insert({p.x, p.y, p.z, cell.head, cell.head ? lattice::index(cell.axis) : 0});
    }
    EXPECT_TRUE(seen.insert(key).second) << id;
  }
}

TEST(MechanismTable, TurnsThePinInThreeWays) {
  const MechanismTable pins(composeMechanisms(parts::Catalogue::builtIn(), {{"2780"}, 1, 9}));
  EXPECT_EQ(pins.size(), 3U);
}

TEST(MechanismTable, HasNothingBeyondItsReach) {
  EXPECT_TRUE(table().between({MechanismTable::kReach + 1, 0, 0}, Axis::kX, Axis::kX).empty());
}

}  // namespace
}  // namespace liftarm::mechanisms
