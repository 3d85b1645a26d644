#include "gears/shaft_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/index.h"
#include "gears/gear_sizes.h"
#include "gears/line_nodes.h"
#include "gears/shaft_seats.h"
#include "gears/train_room.h"
#include "parts/catalogue.h"
#include "sketch/json_text.h"

namespace liftarm::gears {

namespace {

using base::at;
using lattice::Cell;
using lattice::Vec3;

constexpr double kHalfPart = 0.5;  // modules from a line to the side of the beam on it

std::string textOf(Cell cell) {
  return "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " +
         std::to_string(cell.z) + ")";
}

//! Two planes of bearings side by side, and what two shafts have between them.
struct Window {
  int low = 0;
  int high = 0;
};

class ShaftPlanner {
 public:
  ShaftPlanner(const sketch::Sketch& sketch, const sketch::Shafts& shafts)
      : drawn_(shafts), nodes_(sketch), sizes_(gearSizesOf(parts::Catalogue::builtIn().parts())) {
    plan_.sketch = sketch;
  }

  base::Result<ShaftPlan> plan() {
    for (int i = 0; i < static_cast<int>(drawn_.shafts.size()) && fault_.empty(); ++i) {
      addDrawn(i);
    }
    for (int i = 0; i < static_cast<int>(drawn_.drives.size()) && fault_.empty(); ++i) {
      addDrive(i);
    }
    for (std::size_t i = 0; i < plan_.shafts.size() && fault_.empty(); ++i) {
      hold(i);
    }
    if (!fault_.empty()) {
      return base::Error{base::Status::kInvalidInput, fault_};
    }
    setPhases(plan_.shafts, meshes_);
    for (const PlannedShaft& shaft : plan_.shafts) {
      makeRoom(shaft);
    }
    return std::move(plan_);
  }

 private:
  void refuse(const char* list, int index, const std::string& why) {
    fault_ = std::string(list) + "[" + std::to_string(index) + "]: " + why;
  }

  void addDrawn(int index) {
    const sketch::Shaft& drawn = drawn_.shafts[at(index)];
    PlannedShaft shaft;
    shaft.axis = drawn.axis();
    shaft.at = {drawn.from[(shaft.axis + 1) % 3], drawn.from[(shaft.axis + 2) % 3]};
    shaft.first = std::min(drawn.from[shaft.axis], drawn.to[shaft.axis]);
    shaft.last = std::max(drawn.from[shaft.axis], drawn.to[shaft.axis]);
    for (int slot = shaft.first; slot <= shaft.last; ++slot) {
      const Cell cell = cellOf(shaft.axis, shaft.at, slot);
      const std::vector<int> lines = nodes_.at(cell);
      if (const auto line = nodes_.passing(cell)) {
        return refuse(
            "shafts", index, "runs into lines[" + std::to_string(*line) + "] at " + textOf(cell));
      }
      if (lines.empty()) {
        continue;
      }
      if (lines.size() > 1) {
        return refuse("shafts",
                      index,
                      "lines[" + std::to_string(lines[0]) + "] and lines[" +
                          std::to_string(lines[1]) + "] meet at " + textOf(cell) +
                          "; a shaft needs a hole of one line");
      }
      if (!nodes_.bearingAt(cell, shaft.axis)) {
        return refuse(
            "shafts",
            index,
            "lines[" + std::to_string(lines[0]) + "] can have no hole along it at " + textOf(cell));
      }
      shaft.bearings.push_back(slot);
    }
    if (shaft.bearings.size() < 2) {
      return refuse("shafts",
                    index,
                    "runs in the holes of " + std::to_string(shaft.bearings.size()) +
                        " lines; it needs two at least, each at one of its nodes");
    }
    for (std::size_t other = 0; other < plan_.shafts.size(); ++other) {
      if (meet(shaft, plan_.shafts[other])) {
        return refuse("shafts", index, "meets shafts[" + std::to_string(other) + "]");
      }
    }
    const bool forward = drawn.from[shaft.axis] < drawn.to[shaft.axis];
    for (const int side : {-1, 1}) {
      const bool first = (side < 0) == forward;
      const std::string why = addEnd(shaft, side, first ? drawn.atFrom : drawn.atTo, nodes_);
      if (!why.empty()) {
        return refuse("shafts", index, why);
      }
    }
    group_.push_back(index);
    plan_.shafts.push_back(std::move(shaft));
  }

  static bool meet(const PlannedShaft& p, const PlannedShaft& q) {
    for (int i = p.first; i <= p.last; ++i) {
      for (int j = q.first; j <= q.last; ++j) {
        if (cellOf(p.axis, p.at, i) == cellOf(q.axis, q.at, j)) {
          return true;
        }
      }
    }
    return false;
  }

  void addDrive(int index) {
    const sketch::Drive& drive = drawn_.drives[at(index)];
    const std::string both =
        "shafts[" + std::to_string(drive.from) + "] and shafts[" + std::to_string(drive.to) + "] ";
    const PlannedShaft& from = plan_.shafts[at(drive.from)];
    const PlannedShaft& to = plan_.shafts[at(drive.to)];
    if (group_[at(drive.from)] == group_[at(drive.to)]) {
      return refuse("drives", index, both + "are coupled already");
    }
    if (from.axis != to.axis || from.at == to.at) {
      return refuse("drives", index, both + "are not side by side; gears couple parallel shafts");
    }
    const std::optional<Window> window = windowOf(from, to);
    if (!window.has_value()) {
      return refuse("drives", index, both + "have no room for gears between two bearings of both");
    }
    const std::optional<Train> train = trainFor(drive, *window);
    if (!train.has_value()) {
      return refuse("drives",
                    index,
                    "no gears couple " + both + "with ratio " + sketch::shortNumber(drive.ratio) +
                        " within " + sketch::shortNumber(drive.tolerance) +
                        " %; more lines beside them give shafts in between their bearings");
    }
    std::replace(group_.begin(), group_.end(), group_[at(drive.to)], group_[at(drive.from)]);
    addTrain(drive, *train, *window);
  }

  //! The widest two bearings that follow on each other on both shafts, at the same places.
  static std::optional<Window> windowOf(const PlannedShaft& p, const PlannedShaft& q) {
    std::optional<Window> widest;
    for (std::size_t i = 1; i < p.bearings.size(); ++i) {
      const Window window{p.bearings[i - 1], p.bearings[i]};
      const auto other =
          std::adjacent_find(q.bearings.begin(), q.bearings.end(), [&](int low, int high) {
            return low == window.low && high == window.high;
          });
      const int width = window.high - window.low;
      if (other != q.bearings.end() && width > 1 &&
          (!widest.has_value() || width > widest->high - widest->low)) {
        widest = window;
      }
    }
    return widest;
  }

  [[nodiscard]] std::optional<Train> trainFor(const sketch::Drive& drive, Window window) const {
    const PlannedShaft& from = plan_.shafts[at(drive.from)];
    TrainRequest request;
    request.from = from.at;
    request.to = plan_.shafts[at(drive.to)].at;
    request.ratio = drive.ratio;
    request.tolerance = drive.tolerance / 100.0;
    request.planes = window.high - window.low - 1;
    for (const GearSize& size : sizes_) {
      request.teeth.push_back(size.teeth);
    }
    request.bears = [&](Place place) { return bears(from.axis, place, window); };
    const std::vector<Vec3> near = obstacles(from.axis, window);
    request.clear = [&, near](const Disc& disc) { return isClear(from.axis, disc, window, near); };
    for (const PlannedShaft& shaft : plan_.shafts) {
      addTaken(shaft, from.axis, window, request);
    }
    return findTrain(request);
  }

  static void addTaken(const PlannedShaft& shaft, int axis, Window window, TrainRequest& request) {
    if (shaft.axis != axis || shaft.last <= window.low || shaft.first >= window.high) {
      return;
    }
    if (!(shaft.at == request.from) && !(shaft.at == request.to)) {
      request.taken.push_back({shaft.at, std::nullopt, kAxleRadius});
    }
    for (const Seat& seat : shaft.seats) {
      request.taken.push_back({shaft.at, seat.slot - window.low - 1, seat.radius});
    }
  }

  //! Whether a shaft in between can turn there.
  [[nodiscard]] bool bears(int axis, Place place, Window window) const {
    const auto cell = [&](int slot) { return cellOf(axis, place, slot); };
    const bool taken =
        std::any_of(plan_.shafts.begin(), plan_.shafts.end(), [&](const PlannedShaft& shaft) {
          return shaft.axis == axis && shaft.at == place;
        });
    if (taken || !nodes_.bearingAt(cell(window.low), axis) ||
        !nodes_.bearingAt(cell(window.high), axis)) {
      return false;
    }
    for (int slot = window.low + 1; slot < window.high; ++slot) {
      if (!nodes_.at(cell(slot)).empty() || nodes_.passing(cell(slot))) {
        return false;
      }
    }
    return nodes_.at(cell(window.low - 1)).empty() || nodes_.at(cell(window.high + 1)).empty();
  }

  //! What stands in the slots of a window: lines, and shafts that go across.
  [[nodiscard]] std::vector<Vec3> obstacles(int axis, Window window) const {
    const auto within = [&](Vec3 p) {
      return p[axis] > window.low + kHalfPart && p[axis] < window.high - kHalfPart;
    };
    std::vector<Vec3> found;
    std::copy_if(nodes_.all().begin(), nodes_.all().end(), std::back_inserter(found), within);
    for (const PlannedShaft& shaft : plan_.shafts) {
      for (int slot = shaft.first; slot <= shaft.last && shaft.axis != axis; ++slot) {
        const Vec3 p = lattice::toVec3(cellOf(shaft.axis, shaft.at, slot));
        if (within(p)) {
          found.push_back(p);
        }
      }
    }
    return found;
  }

  [[nodiscard]] bool isClear(int axis,
                             const Disc& disc,
                             Window window,
                             const std::vector<Vec3>& near) const {
    const int slot = window.low + 1 + disc.plane.value_or(0);
    const Vec3 middle = lattice::toVec3(cellOf(axis, disc.at, slot));
    const bool apart = std::all_of(near.begin(), near.end(), [&](Vec3 p) {
      Vec3 across = p - middle;
      const double along = std::abs(across[axis]);
      across[axis] = 0.0;
      return along >= 1.0 || lattice::length(across) >= disc.radius + kHalfPart;
    });
    const bool grounded = axis == 2 || !plan_.sketch.ground.has_value() ||
                          middle.z - disc.radius >= *plan_.sketch.ground;
    return apart && grounded && entersNoBox(axis, disc, slot);
  }

  [[nodiscard]] bool entersNoBox(int axis, const Disc& disc, int slot) const {
    const std::vector<int> rows = rowsOf(disc.radius);
    const int most = static_cast<int>(rows.size()) - 1;
    for (int v = -most; v <= most; ++v) {
      const int reach = rows[at(std::abs(v))];
      for (int u = -reach; u <= reach; ++u) {
        const Vec3 p = lattice::toVec3(cellOf(axis, disc.at + Place{u, v}, slot));
        for (const sketch::KeepOut& box : plan_.sketch.keepOut) {
          if (p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x <= box.max.x &&
              p.y <= box.max.y && p.z <= box.max.z) {
            return false;
          }
        }
      }
    }
    return true;
  }

  void addTrain(const sketch::Drive& drive, const Train& train, Window window) {
    std::vector<int> indices;
    const int axis = plan_.shafts[at(drive.from)].axis;
    for (std::size_t s = 0; s < train.shafts.size(); ++s) {
      if (s == 0 || s + 1 == train.shafts.size()) {
        indices.push_back(s == 0 ? drive.from : drive.to);
        continue;
      }
      indices.push_back(static_cast<int>(plan_.shafts.size()));
      PlannedShaft between;
      between.axis = axis;
      between.at = train.shafts[s];
      between.first = window.low;
      between.last = window.high;
      between.bearings = {window.low, window.high};
      plan_.shafts.push_back(between);
    }
    for (std::size_t g = 0; g < train.gears.size(); ++g) {
      const TrainGear& gear = train.gears[g];
      const auto size = std::find_if(sizes_.begin(), sizes_.end(), [&](const GearSize& known) {
        return known.teeth == gear.teeth;
      });
      const int shaft = indices[at(gear.shaft)];
      plan_.shafts[at(shaft)].seats.push_back(
          {window.low + 1 + gear.plane, size->part, gear.teeth, tipRadius(gear.teeth)});
      if (g > 0 && train.gears[g - 1].shaft != gear.shaft) {
        const TrainGear& before = train.gears[g - 1];
        meshes_.push_back({indices[at(before.shaft)], shaft, before.teeth, gear.teeth});
      }
    }
  }

  void hold(std::size_t index) {
    const std::size_t drawn = std::min(index, drawn_.shafts.size());
    if (holdShaft(plan_.shafts[index], plan_.shafts, nodes_)) {
      return;
    }
    if (drawn == index) {
      return refuse("shafts",
                    static_cast<int>(index),
                    "nothing can keep it from sliding: it needs a free module on either side of "
                    "one of its lines");
    }
    fault_ = "a shaft between others at " +
             textOf(cellOf(
                 plan_.shafts[index].axis, plan_.shafts[index].at, plan_.shafts[index].first)) +
             " cannot be kept from sliding: it needs a free module on either side of its line";
  }

  void makeRoom(const PlannedShaft& shaft) {
    for (const int slot : shaft.bearings) {
      const auto line = nodes_.bearingAt(cellOf(shaft.axis, shaft.at, slot), shaft.axis);
      plan_.sketch.lines[at(*line)].exact = true;
      plan_.sketch.lines[at(*line)].holeAxis = lattice::axisFromIndex(shaft.axis);
    }
    const std::vector<sketch::KeepOut> room = roomOf(shaft);
    plan_.sketch.keepOut.insert(plan_.sketch.keepOut.end(), room.begin(), room.end());
  }

  const sketch::Shafts& drawn_;
  LineNodes nodes_;
  std::vector<GearSize> sizes_;
  ShaftPlan plan_;
  std::vector<PlannedMesh> meshes_;
  std::vector<int> group_;  // per drawn shaft: those with one number are coupled
  std::string fault_;
};

}  // namespace

lattice::Cell cellOf(int axis, Place at, int slot) {
  Cell cell;
  cell[axis] = slot;
  cell[(axis + 1) % 3] = at.u;
  cell[(axis + 2) % 3] = at.v;
  return cell;
}

base::Result<ShaftPlan> planShafts(const sketch::Sketch& sketch, const sketch::Shafts& shafts) {
  return ShaftPlanner(sketch, shafts).plan();
}

}  // namespace liftarm::gears
