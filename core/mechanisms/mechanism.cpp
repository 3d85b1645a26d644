#include "mechanisms/mechanism.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>

#include "lattice/whole_cell.h"
#include "mechanisms/shape_key.h"

namespace liftarm::mechanisms {

namespace {

using lattice::Axis;
using lattice::Cell;
using lattice::Mat3;
using lattice::Vec3;
using parts::FeatureKind;

constexpr double kOnLattice = 1e-3;

std::optional<Cell> wholeCell(Vec3 p) {
  return lattice::wholeCell(p, kOnLattice);
}

std::optional<Axis> principalAxis(Vec3 v) {
  for (int i = 0; i < 3; ++i) {
    if (v[i] > 1.0 - kOnLattice || v[i] < -1.0 + kOnLattice) {
      return lattice::axisFromIndex(i);
    }
  }
  return std::nullopt;
}

//! \pre rotation is one of the lattice's: all its entries are whole.
Cell turned(const Mat3& rotation, Cell cell) {
  Cell result;
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(3 * i);
    for (int k = 0; k < 3; ++k) {
      const double entry = rotation.m[row + static_cast<std::size_t>(k)];
      result[i] += static_cast<int>(entry) * cell[k];
    }
  }
  return result;
}

Axis turned(const Mat3& rotation, Axis axis) {
  Cell unit;
  unit[lattice::index(axis)] = 1;
  const Cell image = turned(rotation, unit);
  return image.x != 0 ? Axis::kX : (image.y != 0 ? Axis::kY : Axis::kZ);
}

void sortHeadsFirst(std::vector<MechanismCell>* cells) {
  std::sort(cells->begin(), cells->end(), [](const MechanismCell& a, const MechanismCell& b) {
    return a.head != b.head ? a.head : a.at < b.at;
  });
}

//! A collar at the end of an axle stops what is on it; those of pins are in the pin's own shape.
void markCollar(const parts::Prism& collar, Vec3 origin, Mechanism* mechanism) {
  for (MechanismCell& cell : mechanism->cells) {
    const Vec3 outward = collar.from - origin - lattice::toVec3(cell.at);
    const double along = lattice::dot(outward, lattice::unitVector(cell.axis));
    const bool onAxis =
        lattice::length(outward - along * lattice::unitVector(cell.axis)) < kOnLattice;
    if (cell.head && cell.kind == FeatureKind::kAxle && onAxis && std::abs(along) < 0.5) {
      cell.collar = Cell{};
      cell.collar[lattice::index(cell.axis)] = along < 0.0 ? -1 : 1;
    }
  }
}

//! The part as a mechanism of one, its first slot at the origin; empty when it is not on the
//! lattice.
std::optional<Mechanism> fromPart(const parts::Part& part) {
  if (part.features.empty() || part.features.front().slots.empty()) {
    return std::nullopt;
  }
  const Vec3 origin = part.features.front().slots.front();
  Mechanism mechanism;
  for (const parts::Feature& feature : part.features) {
    const std::optional<Axis> axis = principalAxis(feature.axis);
    for (const Vec3& slot : feature.slots) {
      const std::optional<Cell> at = wholeCell(slot - origin);
      if (!axis || !at) {
        return std::nullopt;
      }
      const bool male = parts::isMale(feature.kind);
      mechanism.cells.push_back({*at, male, *axis, !male, feature.kind});
    }
  }
  for (const parts::Prism& prism : part.collars) {
    markCollar(prism, origin, &mechanism);
  }
  for (const parts::Prism& prism : part.solid) {
    // Every whole cell on the prism's middle line is body, unless a hole stands there already.
    const Vec3 span = prism.to - prism.from;
    const int steps = static_cast<int>(lattice::length(span) + 0.5);
    for (int step = 0; step <= steps; ++step) {
      const double t = steps == 0 ? 0.0 : static_cast<double>(step) / static_cast<double>(steps);
      const std::optional<Cell> at = wholeCell(prism.from + t * span - origin);
      if (!at) {
        return std::nullopt;
      }
      const bool known = std::any_of(mechanism.cells.begin(),
                                     mechanism.cells.end(),
                                     [&](const MechanismCell& c) { return c.at == *at; });
      if (!known) {
        mechanism.cells.push_back({*at, false, Axis::kX, false, FeatureKind::kPinHole});
      }
    }
  }
  mechanism.parts.push_back({part.id, {-origin, Mat3{}}});
  sortHeadsFirst(&mechanism.cells);
  return mechanism;
}

bool fits(const MechanismCell& male, const MechanismCell& female) {
  return male.head && female.openHole && male.axis == female.axis &&
         ((male.kind == FeatureKind::kPin && female.kind == FeatureKind::kPinHole) ||
          (male.kind == FeatureKind::kAxle && female.kind == FeatureKind::kAxleHole));
}

//! Puts `added` (already turned) at `offset` onto `base`; fails where cells meet that do not fit.
std::optional<Mechanism> joined(const Mechanism& base, const Mechanism& added, Cell offset) {
  Mechanism result = base;
  int joints = 0;
  for (MechanismCell cell : added.cells) {
    cell.at = cell.at + offset;
    auto meeting = std::find_if(result.cells.begin(),
                                result.cells.end(),
                                [&](const MechanismCell& c) { return c.at == cell.at; });
    if (meeting == result.cells.end()) {
      result.cells.push_back(cell);
      continue;
    }
    if (!fits(*meeting, cell) && !fits(cell, *meeting)) {
      return std::nullopt;
    }
    const bool axle = meeting->kind == FeatureKind::kAxle || cell.kind == FeatureKind::kAxle;
    meeting->stopped = meeting->stopped || axle;
    meeting->head = false;
    meeting->openHole = false;
    ++joints;
  }
  if (joints == 0) {
    return std::nullopt;
  }
  for (const MechanismPart& part : added.parts) {
    lattice::Pose pose = part.pose;
    pose.position = pose.position + lattice::toVec3(offset);
    result.parts.push_back({part.id, pose});
  }
  sortHeadsFirst(&result.cells);
  return result;
}

//! Whether something stops what is on the axle at this cell from sliding to this side.
bool stoppedTowards(const Mechanism& mechanism, const MechanismCell& from, int side) {
  Cell step{};
  step[lattice::index(from.axis)] = side;
  const MechanismCell* cell = &from;
  for (;;) {
    if (cell->collar == step) {
      return true;
    }
    const Cell next = cell->at + step;
    const auto found = std::find_if(mechanism.cells.begin(),
                                    mechanism.cells.end(),
                                    [&](const MechanismCell& c) { return c.at == next; });
    if (found == mechanism.cells.end() || found->axis != from.axis) {
      return false;
    }
    if (!found->head) {
      return found->stopped;
    }
    if (found->kind != FeatureKind::kAxle) {
      return false;
    }
    cell = &*found;
  }
}

//! Heads of axles as beams see them: between stops they hold like pins, elsewhere they are in the
//! way.
Mechanism withAxlesHeld(Mechanism mechanism) {
  const Mechanism before = mechanism;
  for (std::size_t i = 0; i < before.cells.size(); ++i) {
    const MechanismCell& cell = before.cells[i];
    if (!cell.head || cell.kind != FeatureKind::kAxle) {
      continue;
    }
    const bool held = stoppedTowards(before, cell, -1) && stoppedTowards(before, cell, 1);
    mechanism.cells[i].head = held;
    mechanism.cells[i].mustHold = held;
    mechanism.cells[i].kind = held ? FeatureKind::kPin : FeatureKind::kAxle;
  }
  sortHeadsFirst(&mechanism.cells);
  return mechanism;
}

bool usable(const Mechanism& mechanism) {
  return mechanism.headCount() >= 2 &&
         std::all_of(mechanism.cells.begin(), mechanism.cells.end(), [](const MechanismCell& c) {
           return !c.head || c.kind == FeatureKind::kPin;
         });
}

//! All ways to add a piece, turned in these ways, to `base` by one fitting pair of cells.
void extend(const Mechanism& base,
            const std::vector<Mechanism>& ways,
            int maxCells,
            std::set<ShapeKey>* seen,
            std::vector<Mechanism>* out) {
  for (const Mechanism& turnedPiece : ways) {
    for (const MechanismCell& onBase : base.cells) {
      for (const MechanismCell& onPiece : turnedPiece.cells) {
        if (!fits(onBase, onPiece) && !fits(onPiece, onBase)) {
          continue;
        }
        std::optional<Mechanism> whole = joined(base, turnedPiece, onBase.at - onPiece.at);
        if (whole && static_cast<int>(whole->cells.size()) <= maxCells &&
            seen->insert(canonicalKey(*whole)).second) {
          out->push_back(std::move(*whole));
        }
      }
    }
  }
}

//! Whether a mechanism, turned in one of these ways, has the heads of another and no body beyond
//! its own.
bool bodyContained(const std::vector<Mechanism>& ways, const Mechanism& large) {
  for (const Mechanism& candidate : ways) {
    for (const MechanismCell& anchor : large.cells) {
      if (!anchor.head) {
        break;
      }
      const Cell shift = anchor.at - candidate.cells.front().at;
      const bool inside =
          std::all_of(candidate.cells.begin(), candidate.cells.end(), [&](const MechanismCell& c) {
            return std::any_of(large.cells.begin(), large.cells.end(), [&](const MechanismCell& l) {
              return l.at == c.at + shift && l.head == c.head && (!c.head || l.axis == c.axis);
            });
          });
      if (inside) {
        return true;
      }
    }
  }
  return false;
}

std::vector<Mechanism> pruned(std::vector<Mechanism> all) {
  std::vector<Mechanism> kept;
  std::vector<std::vector<Mechanism>> ways;  // of those
  for (Mechanism& mechanism : all) {
    const bool dominated = std::any_of(ways.begin(), ways.end(), [&](const auto& smaller) {
      const Mechanism& k = smaller.front();
      return k.headCount() == mechanism.headCount() && k.parts.size() <= mechanism.parts.size() &&
             k.cells.size() <= mechanism.cells.size() && bodyContained(smaller, mechanism);
    });
    if (!dominated) {
      ways.push_back(turnedWays(mechanism));
      kept.push_back(std::move(mechanism));
    }
  }
  return kept;
}

}  // namespace

int Mechanism::headCount() const {
  return static_cast<int>(
      std::count_if(cells.begin(), cells.end(), [](const MechanismCell& c) { return c.head; }));
}

double Mechanism::pinHeadRatio() const {
  return static_cast<double>(headCount()) / static_cast<double>(cells.size());
}

Mechanism rotated(const Mechanism& mechanism, const Mat3& rotation) {
  Mechanism result = mechanism;
  for (MechanismCell& cell : result.cells) {
    cell.at = turned(rotation, cell.at);
    cell.axis = turned(rotation, cell.axis);
    cell.collar = turned(rotation, cell.collar);
  }
  for (MechanismPart& part : result.parts) {
    part.pose.position = rotation * part.pose.position;
    part.pose.rotation = rotation * part.pose.rotation;
  }
  sortHeadsFirst(&result.cells);
  return result;
}

std::vector<Mechanism> composeMechanisms(const parts::Catalogue& catalogue,
                                         const CompositionOptions& options) {
  std::vector<Mechanism> pieces;
  for (const std::string& id : options.partIds) {
    const parts::Part* part = catalogue.find(id);
    if (part != nullptr) {
      if (std::optional<Mechanism> piece = fromPart(*part)) {
        pieces.push_back(std::move(*piece));
      }
    }
  }
  std::set<ShapeKey> seen;
  std::vector<Mechanism> all;
  for (const Mechanism& piece : pieces) {
    if (seen.insert(canonicalKey(piece)).second) {
      all.push_back(piece);
    }
  }
  std::vector<std::vector<Mechanism>> ways;
  ways.reserve(pieces.size());
  std::transform(pieces.begin(), pieces.end(), std::back_inserter(ways), turnedWays);
  std::size_t levelBegin = 0;
  for (int parts = 2; parts <= options.maxParts; ++parts) {
    const std::size_t levelEnd = all.size();
    for (std::size_t i = levelBegin; i < levelEnd; ++i) {
      for (const std::vector<Mechanism>& piece : ways) {
        const Mechanism base = all[i];
        extend(base, piece, options.maxCells, &seen, &all);
      }
    }
    levelBegin = levelEnd;
  }
  std::transform(all.begin(), all.end(), all.begin(), withAxlesHeld);
  std::vector<Mechanism> useful;
  std::copy_if(all.begin(), all.end(), std::back_inserter(useful), usable);
  std::stable_sort(useful.begin(), useful.end(), [](const Mechanism& a, const Mechanism& b) {
    return a.parts.size() != b.parts.size() ? a.parts.size() < b.parts.size()
                                            : a.cells.size() < b.cells.size();
  });
  return pruned(std::move(useful));
}

}  // namespace liftarm::mechanisms
