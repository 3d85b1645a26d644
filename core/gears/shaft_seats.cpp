#include "gears/shaft_seats.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/det_math.h"
#include "gears/gear_sizes.h"
#include "gears/train_room.h"
#include "parts/catalogue.h"
#include "parts/gear_teeth.h"

namespace liftarm::gears {

namespace {

using lattice::Cell;

constexpr const char* kBush = "3713";
constexpr double kBushRadius = 0.45;
constexpr double kCrankRadius = 1.45;  // modules
constexpr double kWheelRadius = 2.335;
constexpr double kHalfBeam = 0.5;
constexpr double kPi = 3.14159265358979323846;
constexpr double kPriceOfSlot = 0.5;  // in bushes: of a longer axle

//! Bushes beside one bearing, and what they cost.
struct Hold {
  std::vector<int> bushes;
  int first = 0;
  int last = 0;
  double cost = 0.0;
};

bool takes(const PlannedShaft& shaft, int slot) {
  return std::any_of(shaft.seats.begin(), shaft.seats.end(), [slot](const Seat& seat) {
    return seat.slot == slot;
  });
}

//! Whether a bush has room in a slot: no line, no gear of another shaft.
bool hasRoom(const PlannedShaft& shaft,
             int slot,
             const std::vector<PlannedShaft>& others,
             const LineNodes& nodes) {
  const Cell cell = cellOf(shaft.axis, shaft.at, slot);
  if (!nodes.at(cell).empty() || nodes.passing(cell).has_value()) {
    return false;
  }
  const Disc bush{shaft.at, slot, kBushRadius};
  return std::all_of(others.begin(), others.end(), [&](const PlannedShaft& other) {
    if (other.axis != shaft.axis || other.at == shaft.at) {
      return true;
    }
    return std::all_of(other.seats.begin(), other.seats.end(), [&](const Seat& seat) {
      return keepApart(bush, {other.at, seat.slot, seat.radius});
    });
  });
}

std::optional<Hold> holdAt(const PlannedShaft& shaft,
                           int bearing,
                           const std::vector<PlannedShaft>& others,
                           const LineNodes& nodes) {
  Hold hold{{}, shaft.first, shaft.last, 0.0};
  for (const int slot : {bearing - 1, bearing + 1}) {
    if (takes(shaft, slot)) {
      continue;
    }
    const bool isBearing = std::count(shaft.bearings.begin(), shaft.bearings.end(), slot) > 0;
    if (isBearing || !hasRoom(shaft, slot, others, nodes)) {
      return std::nullopt;
    }
    hold.bushes.push_back(slot);
    hold.cost += 1.0;
    if (slot < hold.first || slot > hold.last) {
      hold.cost += kPriceOfSlot;
      hold.first = std::min(hold.first, slot);
      hold.last = std::max(hold.last, slot);
    }
  }
  return axleOf(hold.last - hold.first + 1).has_value() ? std::optional(hold) : std::nullopt;
}

//! Whether a line is in the way of what a seat sweeps.
bool meetsLine(const PlannedShaft& shaft, const Seat& seat, const LineNodes& nodes) {
  const lattice::Vec3 middle = lattice::toVec3(cellOf(shaft.axis, shaft.at, seat.slot));
  return std::any_of(nodes.all().begin(), nodes.all().end(), [&](lattice::Vec3 node) {
    lattice::Vec3 across = node - middle;
    const double along = std::abs(across[shaft.axis]);
    across[shaft.axis] = 0.0;
    return along < 1.0 && lattice::length(across) < seat.radius + kHalfBeam;
  });
}

}  // namespace

std::string addEnd(PlannedShaft& shaft, int side, sketch::ShaftEnd what, const LineNodes& nodes) {
  if (what == sketch::ShaftEnd::kNothing) {
    return "";
  }
  int& end = side > 0 ? shaft.last : shaft.first;
  end += end == (side > 0 ? shaft.bearings.back() : shaft.bearings.front()) ? side : 0;
  if (what == sketch::ShaftEnd::kWheel) {
    shaft.seats.push_back({end, parts::kWheel, 0, kWheelRadius});
  } else {
    shaft.seats.push_back({end, parts::kCrankArm, 0, kCrankRadius});
    shaft.seats.push_back({end + side, "", 0, kCrankRadius});
    shaft.handles.push_back({end, side});
  }
  for (const Seat& seat : shaft.seats) {
    if (meetsLine(shaft, seat, nodes)) {
      return "a line is in the way of what turns at its end";
    }
  }
  return axleOf(shaft.last - shaft.first + 1).has_value()
             ? ""
             : "no axle is long enough for what turns at its ends";
}

bool holdShaft(PlannedShaft& shaft,
               const std::vector<PlannedShaft>& others,
               const LineNodes& nodes) {
  std::optional<Hold> best;
  for (const int bearing : shaft.bearings) {
    const std::optional<Hold> hold = holdAt(shaft, bearing, others, nodes);
    if (hold.has_value() && (!best.has_value() || hold->cost < best->cost)) {
      best = hold;
    }
  }
  if (!best.has_value()) {
    return false;
  }
  shaft.first = best->first;
  shaft.last = best->last;
  for (const int slot : best->bushes) {
    shaft.seats.push_back({slot, kBush, 0, kBushRadius});
  }
  std::sort(shaft.seats.begin(), shaft.seats.end(), [](const Seat& a, const Seat& b) {
    return a.slot < b.slot;
  });
  shaft.axle = *axleOf(shaft.last - shaft.first + 1);
  return true;
}

std::optional<std::string> axleOf(int slots) {
  for (const parts::Part& part : parts::Catalogue::builtIn().parts()) {
    if (part.partClass == parts::PartClass::kAxle && part.features.size() == 1 &&
        part.collars.empty() &&
        part.features.front().slots.size() == static_cast<std::size_t>(slots)) {
      return part.id;
    }
  }
  return std::nullopt;
}

void setPhases(std::vector<PlannedShaft>& shafts, const std::vector<PlannedMesh>& meshes) {
  std::vector<bool> known(shafts.size(), false);
  for (std::size_t root = 0; root < shafts.size(); ++root) {
    if (known[root]) {
      continue;
    }
    known[root] = true;
    for (bool changed = true; changed;) {
      changed = false;
      for (const PlannedMesh& mesh : meshes) {
        const bool forward = known[static_cast<std::size_t>(mesh.a)];
        const auto a = static_cast<std::size_t>(forward ? mesh.a : mesh.b);
        const auto b = static_cast<std::size_t>(forward ? mesh.b : mesh.a);
        if (!known[a] || known[b]) {
          continue;
        }
        const double teethA = forward ? mesh.teethA : mesh.teethB;
        const double teethB = forward ? mesh.teethB : mesh.teethA;
        const Place way = shafts[b].at - shafts[a].at;
        const double towards =
            base::detAtan2(static_cast<double>(way.v), static_cast<double>(way.u));
        // A tooth has its middle where its shaft's cross has a wing. Going round the one is going
        // back round the other, and a tooth of one asks for a gap of the other.
        const double share = (towards - shafts[a].phase) * teethA / (2.0 * kPi);
        shafts[b].phase = towards + kPi - 2.0 * kPi * (0.5 - share) / teethB;
        known[b] = true;
        changed = true;
      }
    }
  }
}

std::vector<int> rowsOf(double radius) {
  std::vector<int> rows;
  const auto off = [](int i) { return std::max(0.0, static_cast<double>(i) - 0.5); };
  for (int row = 0; off(row) < radius; ++row) {
    int reach = 0;
    while (off(reach + 1) * off(reach + 1) + off(row) * off(row) < radius * radius) {
      ++reach;
    }
    rows.push_back(reach);
  }
  return rows;
}

std::vector<sketch::KeepOut> roomOf(const PlannedShaft& shaft) {
  std::vector<sketch::KeepOut> boxes;
  const auto add = [&](int slot, Place low, Place high) {
    boxes.push_back({lattice::toVec3(cellOf(shaft.axis, shaft.at + low, slot)),
                     lattice::toVec3(cellOf(shaft.axis, shaft.at + high, slot))});
  };
  for (int slot = shaft.first; slot <= shaft.last; ++slot) {
    if (std::count(shaft.bearings.begin(), shaft.bearings.end(), slot) == 0) {
      add(slot, {0, 0}, {0, 0});
    }
  }
  for (const Seat& seat : shaft.seats) {
    const std::vector<int> rows = rowsOf(seat.radius);
    for (int row = 0; row < static_cast<int>(rows.size()) && seat.radius > kBushRadius; ++row) {
      const int reach = rows[static_cast<std::size_t>(row)];
      add(seat.slot, {-reach, row}, {reach, row});
      if (row > 0) {
        add(seat.slot, {-reach, -row}, {reach, -row});
      }
    }
  }
  return boxes;
}

}  // namespace liftarm::gears
