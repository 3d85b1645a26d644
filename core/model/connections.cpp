#include "model/connections.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace liftarm::model {

namespace {

using lattice::Cell;
using lattice::Vec3;
using parts::FeatureKind;

struct Slot {
  int part = -1;
  int feature = -1;
  int slot = -1;
  FeatureKind kind = FeatureKind::kPin;
  double length = 1.0;
  Vec3 at;    // world
  Vec3 axis;  // world
  Vec3 wing;  // world; zero where the feature has none
};

// Slots whose middles are further apart than this along one axis cannot overlap.
constexpr double kReach = 1.0;

Cell cellOf(Vec3 p) {
  return {static_cast<int>(std::floor(p.x)),
          static_cast<int>(std::floor(p.y)),
          static_cast<int>(std::floor(p.z))};
}

void addSlots(const PlacedPart& placed,
              const parts::Part& part,
              int index,
              std::vector<Slot>& slots) {
  for (std::size_t f = 0; f < part.features.size(); ++f) {
    const parts::Feature& feature = part.features[f];
    for (std::size_t s = 0; s < feature.slots.size(); ++s) {
      Slot slot;
      slot.part = index;
      slot.feature = static_cast<int>(f);
      slot.slot = static_cast<int>(s);
      slot.kind = feature.kind;
      slot.length = feature.length / static_cast<double>(feature.slots.size());
      slot.at = placed.pose.apply(feature.slots[s]);
      slot.axis = placed.pose.rotation * feature.axis;
      slot.wing = placed.pose.rotation * feature.wing.value_or(Vec3{});
      slots.push_back(slot);
    }
  }
}

//! Both crosses look the same after a quarter turn.
bool crossesAgree(const Slot& male, const Slot& female) {
  constexpr double kSine = 0.035;  // 2 degrees
  const double c = std::abs(lattice::dot(male.wing, female.wing));
  const double s = lattice::length(lattice::cross(male.wing, female.wing));
  return std::min(c, s) <= kSine;
}

Fit fitOfKinds(const Slot& male, const Slot& female) {
  if (male.kind == FeatureKind::kPin) {
    return female.kind == FeatureKind::kPinHole ? Fit::kTurn : Fit::kWrongKind;
  }
  if (female.kind == FeatureKind::kPinHole) {
    return Fit::kSlide;
  }
  return crossesAgree(male, female) ? Fit::kRigid : Fit::kTwisted;
}

//! Whether the female slot lies where the male slot can hold it. `apart`: distance of the middles.
bool slotInSlot(const Slot& male, const Slot& female, double apart) {
  const double room = std::max(0.0, (male.length - female.length) / 2);
  // A thin beam lies at one end of a pin's slot: at the collar or at the tip. An axle takes it
  // anywhere.
  constexpr double kThin = 0.6;
  if (female.length > kThin) {
    return apart <= kCoaxialDistance;
  }
  return male.kind == FeatureKind::kAxle ? apart <= room + kCoaxialDistance
                                         : std::abs(apart - room) <= kCoaxialDistance;
}

//! Heads further off their hole's line than this, 0.16 mm, do not go in: a beam turned by 2 degrees
//! about one of its pins is 0.035 modules off at the next.
constexpr double kPlay = 0.02;

//! Fills in `fit` and `at`. \return False where the two have nothing to do with each other.
bool meet(const Slot& male, const Slot& female, Connection& connection) {
  if (std::abs(lattice::dot(male.axis, female.axis)) < kCoaxialCosine) {
    return false;
  }
  const Vec3 offset = male.at - female.at;
  const double along = lattice::dot(offset, female.axis);
  const double aside = lattice::length(offset - along * female.axis);
  if (aside > kCoaxialDistance) {
    return false;
  }
  const double apart = std::abs(along);
  if (apart >= (male.length + female.length) / 2 - kCoaxialDistance) {
    return false;
  }
  connection.fit = aside <= kPlay && slotInSlot(male, female, apart) ? fitOfKinds(male, female)
                                                                     : Fit::kMisplaced;
  connection.at = female.at;
  return true;
}

using SlotGrid = std::map<Cell, std::vector<Slot>>;

void addConnections(const Slot& male, const SlotGrid& grid, std::vector<Connection>& found) {
  const Cell low = cellOf(male.at - Vec3{kReach, kReach, kReach});
  const Cell high = cellOf(male.at + Vec3{kReach, kReach, kReach});
  for (int x = low.x; x <= high.x; ++x) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int z = low.z; z <= high.z; ++z) {
        const auto cell = grid.find({x, y, z});
        if (cell == grid.end()) {
          continue;
        }
        for (const Slot& female : cell->second) {
          Connection connection{male.part,
                                male.feature,
                                male.slot,
                                female.part,
                                female.feature,
                                female.slot,
                                Fit::kTurn,
                                {}};
          if (female.part != male.part && meet(male, female, connection)) {
            found.push_back(connection);
          }
        }
      }
    }
  }
}

//! What stands at one slot of an axle.
enum class AxlePlace : std::uint8_t { kEmpty, kSliding, kStop };

//! What stands at each slot of an axle's head, its collars included: one place more on either side.
std::vector<AxlePlace> placesOn(const parts::Part& part,
                                const parts::Feature& feature,
                                const std::vector<const Connection*>& connections) {
  const std::size_t slots = feature.slots.size();
  std::vector<AxlePlace> places(slots + 2, AxlePlace::kEmpty);
  for (const Connection* c : connections) {
    AxlePlace& place = places[static_cast<std::size_t>(c->maleSlot) + 1];
    place = c->fit == Fit::kRigid ? AxlePlace::kStop : std::max(place, AxlePlace::kSliding);
  }
  for (const parts::Prism& collar : part.collars) {
    // A collar is a thin ring at an end: it stops what lies in the slot next to it.
    const Vec3 inward = feature.slots.back() - feature.slots.front();
    const double along = lattice::dot(collar.from - feature.center, inward);
    (along < 0.0 ? places.front() : places.back()) = AxlePlace::kStop;
  }
  return places;
}

//! Whether what lies at a place can slide neither way: only parts side by side up to a stop.
bool isHeld(const std::vector<AxlePlace>& places, std::size_t at) {
  std::size_t low = at;
  std::size_t high = at;
  while (low > 0 && places[low] == AxlePlace::kSliding) {
    --low;
  }
  while (high + 1 < places.size() && places[high] == AxlePlace::kSliding) {
    ++high;
  }
  return places[low] == AxlePlace::kStop && places[high] == AxlePlace::kStop;
}

//! Turns kSlide into kTurn where stops hold what is on an axle.
void holdBetweenStops(const Model& model,
                      const parts::Catalogue& catalogue,
                      std::vector<Connection>& connections) {
  std::map<std::pair<int, int>, std::vector<Connection*>> byHead;
  for (Connection& c : connections) {
    const parts::Part& part = *catalogue.find(model.parts[static_cast<std::size_t>(c.male)].part);
    const parts::Feature& feature = part.features[static_cast<std::size_t>(c.maleFeature)];
    if (feature.kind == FeatureKind::kAxle && feature.slots.size() > 1) {
      byHead[{c.male, c.maleFeature}].push_back(&c);
    }
  }
  for (const auto& [head, list] : byHead) {
    const parts::Part& part =
        *catalogue.find(model.parts[static_cast<std::size_t>(head.first)].part);
    const std::vector<AxlePlace> places =
        placesOn(part,
                 part.features[static_cast<std::size_t>(head.second)],
                 std::vector<const Connection*>(list.begin(), list.end()));
    for (Connection* c : list) {
      if (c->fit == Fit::kSlide && isHeld(places, static_cast<std::size_t>(c->maleSlot) + 1)) {
        c->fit = Fit::kTurn;
      }
    }
  }
}

}  // namespace

std::vector<Connection> findConnections(const Model& model, const parts::Catalogue& catalogue) {
  std::vector<Slot> males;
  SlotGrid females;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const parts::Part* part = catalogue.find(model.parts[i].part);
    if (part == nullptr) {
      continue;
    }
    std::vector<Slot> slots;
    addSlots(model.parts[i], *part, static_cast<int>(i), slots);
    for (const Slot& slot : slots) {
      if (parts::isMale(slot.kind)) {
        males.push_back(slot);
      } else {
        females[cellOf(slot.at)].push_back(slot);
      }
    }
  }
  std::vector<Connection> found;
  for (const Slot& male : males) {
    addConnections(male, females, found);
  }
  holdBetweenStops(model, catalogue, found);
  const auto key = [](const Connection& c) {
    return std::tie(c.male, c.maleFeature, c.maleSlot, c.female, c.femaleFeature, c.femaleSlot);
  };
  std::sort(found.begin(), found.end(), [&](const Connection& a, const Connection& b) {
    return key(a) < key(b);
  });
  return found;
}

}  // namespace liftarm::model
