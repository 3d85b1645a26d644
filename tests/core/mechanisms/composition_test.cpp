#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "mechanisms/mechanism.h"

namespace liftarm::mechanisms {
namespace {

using lattice::Cell;
using lattice::Vec3;
using parts::FeatureKind;

const std::vector<std::string> kParts{"2780", "6558", "87082", "15100", "48989", "55615"};

std::vector<Mechanism> compose(int maxParts, const std::vector<std::string>& ids = kParts) {
  return composeMechanisms(parts::Catalogue::builtIn(), {ids, maxParts, 9});
}

std::string namesOf(const Mechanism& mechanism) {
  std::vector<std::string> ids;
  for (const MechanismPart& part : mechanism.parts) {
    ids.push_back(part.id);
  }
  std::sort(ids.begin(), ids.end());
  std::string text;
  for (const std::string& id : ids) {
    text += (text.empty() ? "" : "+") + id;
  }
  return text;
}

//! How often each (parts, heads, nodes) occurs, as "2780+87082 3/4".
std::map<std::string, int> inventory(const std::vector<Mechanism>& mechanisms) {
  std::map<std::string, int> counts;
  for (const Mechanism& m : mechanisms) {
    ++counts[namesOf(m) + " " + std::to_string(m.headCount()) + "/" +
             std::to_string(m.cells.size())];
  }
  return counts;
}

bool at(Vec3 p, Cell cell) {
  return lattice::length(p - lattice::toVec3(cell)) < 1e-3;
}

bool along(Vec3 v, lattice::Axis axis) {
  return std::abs(v[lattice::index(axis)]) > 0.999;
}

//! The slots of one gender that have their middle in the cell, with the world axis of each.
std::vector<Vec3> slotAxesIn(const Mechanism& mechanism, Cell cell, bool male) {
  std::vector<Vec3> axes;
  for (const MechanismPart& member : mechanism.parts) {
    for (const parts::Feature& feature : parts::Catalogue::builtIn().find(member.id)->features) {
      for (const Vec3& slot : feature.slots) {
        if (parts::isMale(feature.kind) == male && at(member.pose.apply(slot), cell)) {
          axes.push_back(member.pose.rotation * feature.axis);
        }
      }
    }
  }
  return axes;
}

TEST(Composition, FindsTheFiveSinglePartsOfTheFindings) {
  std::set<std::string> names;
  for (const Mechanism& m : compose(1)) {
    names.insert(namesOf(m));
  }
  EXPECT_EQ(names, (std::set<std::string>{"2780", "6558", "87082", "48989", "55615"}));
}

TEST(Composition, SinglePartsHaveThePinHeadRatiosOfTheFindings) {
  const std::map<std::string, int> counts = inventory(compose(1));
  EXPECT_EQ(
      counts,
      (std::map<std::string, int>{
          {"2780 2/2", 1}, {"6558 3/3", 1}, {"87082 2/3", 1}, {"48989 4/7", 1}, {"55615 4/9", 1}}));
}

TEST(Composition, FindsThePapersTeeAndEll) {
  const std::map<std::string, int> counts = inventory(compose(2));
  EXPECT_EQ(counts.count("2780+87082 3/4"), 1U);
  EXPECT_EQ(counts.count("15100+2780 2/3"), 1U);
}

TEST(Composition, FindsTheTwoUniversalCrossesOfLongPinAndPinWithHole) {
  const std::map<std::string, int> counts = inventory(compose(2));
  ASSERT_EQ(counts.count("6558+87082 4/5"), 1U);
  EXPECT_EQ(counts.at("6558+87082 4/5"), 2);
}

TEST(Composition, FindsTheTwentyTwoMechanismsThatWereFoundByHand) {
  // An enumeration apart from this code counts 22 of at most two parts and seven cells; 87082 in
  // the hole of 48989 has more cells.
  std::map<std::string, int> counts = inventory(compose(2));
  EXPECT_EQ(counts["87082+48989 5/9"] + counts["48989+87082 5/9"], 4);
  counts.erase("87082+48989 5/9");
  counts.erase("48989+87082 5/9");
  EXPECT_EQ(counts,
            (std::map<std::string, int>{{"2780 2/2", 1},
                                        {"6558 3/3", 1},
                                        {"87082 2/3", 1},
                                        {"48989 4/7", 1},
                                        {"55615 4/9", 1},
                                        {"6558+87082 4/5", 2},
                                        {"2780+87082 3/4", 1},
                                        {"15100+6558 3/4", 1},
                                        {"15100+2780 2/3", 1},
                                        {"2780+48989 5/8", 2},
                                        {"48989+6558 6/9", 4},
                                        {"87082+87082 3/5", 1},
                                        {"15100+48989 4/8", 4},
                                        {"15100+87082 2/4", 1}}));
}

TEST(Composition, OfThreePartsContainsThatOfTwo) {
  const std::map<std::string, int> two = inventory(compose(2));
  const std::map<std::string, int> three = inventory(compose(3));
  for (const auto& [name, count] : two) {
    ASSERT_EQ(three.count(name), 1U) << name;
    EXPECT_EQ(three.at(name), count) << name;
  }
  EXPECT_GT(three.size(), two.size());
}

TEST(Composition, KeepsEachCellOnce) {
  for (const Mechanism& m : compose(2)) {
    std::set<Cell> cells;
    for (const MechanismCell& cell : m.cells) {
      EXPECT_TRUE(cells.insert(cell.at).second) << namesOf(m);
    }
  }
}

TEST(Composition, PutsEveryRealSlotIntoACell) {
  for (const Mechanism& m : compose(2)) {
    for (const MechanismPart& member : m.parts) {
      for (const parts::Feature& feature : parts::Catalogue::builtIn().find(member.id)->features) {
        for (const Vec3& slot : feature.slots) {
          const Vec3 p = member.pose.apply(slot);
          EXPECT_TRUE(std::any_of(m.cells.begin(), m.cells.end(), [&](const MechanismCell& c) {
            return at(p, c.at);
          })) << namesOf(m);
        }
      }
    }
  }
}

TEST(Composition, HeadsAreFreeMaleSlotsAlongTheirAxis) {
  for (const Mechanism& m : compose(2)) {
    for (const MechanismCell& cell : m.cells) {
      if (cell.head) {
        const std::vector<Vec3> male = slotAxesIn(m, cell.at, true);
        ASSERT_EQ(male.size(), 1U) << namesOf(m);
        EXPECT_TRUE(along(male.front(), cell.axis)) << namesOf(m);
        EXPECT_TRUE(slotAxesIn(m, cell.at, false).empty()) << namesOf(m);
      }
    }
  }
}

TEST(Composition, FillsHolesOnlyWithHeadsThatFit) {
  for (const Mechanism& m : compose(2)) {
    for (const MechanismCell& cell : m.cells) {
      const std::vector<Vec3> male = slotAxesIn(m, cell.at, true);
      const std::vector<Vec3> female = slotAxesIn(m, cell.at, false);
      EXPECT_LE(male.size(), 1U) << namesOf(m);
      if (!male.empty() && !female.empty()) {
        EXPECT_TRUE(std::any_of(female.begin(), female.end(), [&](Vec3 axis) {
          return std::abs(lattice::dot(axis, male.front())) > 0.999;
        })) << namesOf(m);
        EXPECT_FALSE(cell.head) << namesOf(m);
      }
    }
  }
}

TEST(Composition, KeepsHeadsFirst) {
  for (const Mechanism& m : compose(2)) {
    const auto heads = m.cells.begin() + m.headCount();
    EXPECT_TRUE(std::all_of(m.cells.begin(), heads, [](const MechanismCell& c) { return c.head; }));
  }
}

TEST(Composition, HoldsEachMechanismTogether) {
  // Of n parts each but the first fills a hole or has one filled: at least n - 1 filled cells.
  for (const Mechanism& m : compose(2)) {
    std::size_t filled = 0;
    for (const MechanismCell& cell : m.cells) {
      filled += !slotAxesIn(m, cell.at, true).empty() && !slotAxesIn(m, cell.at, false).empty();
    }
    EXPECT_GE(filled, m.parts.size() - 1) << namesOf(m);
  }
}

TEST(Composition, KeepsItsCountsUnderEveryRotation) {
  for (const Mechanism& m : compose(2)) {
    for (const lattice::Mat3& rotation : lattice::latticeRotations()) {
      const Mechanism turned = rotated(m, rotation);
      EXPECT_EQ(turned.headCount(), m.headCount());
      EXPECT_EQ(turned.cells.size(), m.cells.size());
      EXPECT_EQ(turned.parts.size(), m.parts.size());
    }
  }
}

TEST(Composition, TurnsRealSlotsWithTheCells) {
  for (const Mechanism& m : compose(2)) {
    for (const lattice::Mat3& rotation : lattice::latticeRotations()) {
      const Mechanism turned = rotated(m, rotation);
      for (const MechanismCell& cell : turned.cells) {
        if (cell.head) {
          const std::vector<Vec3> male = slotAxesIn(turned, cell.at, true);
          ASSERT_EQ(male.size(), 1U) << namesOf(m);
          EXPECT_TRUE(along(male.front(), cell.axis)) << namesOf(m);
        }
      }
    }
  }
}

TEST(Composition, UsesOnlyThePartsThatAreSwitchedOn) {
  for (const Mechanism& m : compose(2, {"2780", "87082"})) {
    for (const MechanismPart& part : m.parts) {
      EXPECT_TRUE(part.id == "2780" || part.id == "87082") << part.id;
    }
  }
}

TEST(Composition, PassesOverPartsThatDoNotExist) {
  EXPECT_EQ(compose(1, {"2780", "no such part"}).size(), 1U);
}

TEST(Composition, StaysWithinTheLargestSize) {
  for (const Mechanism& m : composeMechanisms(parts::Catalogue::builtIn(), {kParts, 2, 5})) {
    EXPECT_TRUE(m.parts.size() == 1U || m.cells.size() <= 5U) << namesOf(m);
  }
}

TEST(Composition, AnAxleWithStopAndBushHoldsFourBeams) {
  const std::vector<Mechanism> mechanisms = compose(2, {"15462", "3713"});
  const auto longest = std::max_element(
      mechanisms.begin(), mechanisms.end(), [](const Mechanism& a, const Mechanism& b) {
        return a.headCount() < b.headCount();
      });
  ASSERT_NE(longest, mechanisms.end());
  EXPECT_EQ(longest->headCount(), 4);
  EXPECT_EQ(namesOf(*longest), "15462+3713");
}

TEST(Composition, AnAxleWithoutStopsHoldsNothing) {
  EXPECT_TRUE(compose(2, {"32073", "3713"}).empty());  // one bush stops one side only
}

TEST(Composition, HeadsBetweenStopsMustAllHoldABeam) {
  for (const Mechanism& m : compose(2, {"15462", "3713"})) {
    for (const MechanismCell& cell : m.cells) {
      EXPECT_EQ(cell.head, cell.mustHold);
    }
  }
}

}  // namespace
}  // namespace liftarm::mechanisms
