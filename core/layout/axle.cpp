#include "layout/axle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>

#include "base/index.h"
#include "layout/part_list.h"

namespace liftarm::layout {

namespace {

using base::at;

// As those of mechanisms: a little for what sits in no beam, and for what does.
constexpr double kBodyCost = 0.15;
constexpr double kHeadCost = 0.02;
constexpr double kOnLattice = 1e-3;
constexpr std::size_t kFewestSlots = 3;  // shorter lines are bridged by connectors

std::optional<AxlePart> axlePartOf(const parts::Part& part) {
  if (part.partClass != parts::PartClass::kAxle || part.features.size() != 1 ||
      !part.solid.empty() || part.collars.size() > 1 ||
      part.features.front().slots.size() < kFewestSlots) {
    return std::nullopt;
  }
  const parts::Feature& feature = part.features.front();
  const auto slots = static_cast<double>(feature.slots.size());
  if (feature.kind != parts::FeatureKind::kAxle || std::abs(feature.length - slots) > kOnLattice) {
    return std::nullopt;
  }
  AxlePart axle{part.id, static_cast<int>(feature.slots.size()), false, feature.axis};
  for (const parts::Prism& collar : part.collars) {
    const double along = lattice::dot(collar.from - feature.center, feature.axis);
    if (std::abs(along) < 0.5 * feature.length - 0.5) {
      return std::nullopt;  // beams do not pass it
    }
    axle.stopped = true;
    axle.end = (along < 0.0 ? -1.0 : 1.0) * feature.axis;
  }
  return axle;
}

//! Where bushes must be, whatever the axle: between two beams, next to each. Those outside the
//! first and the last beam are the axle's own matter.
std::uint64_t innerBushes(std::uint64_t seats, int first, int last) {
  std::uint64_t bushes = 0;
  for (int i = first; i < last; ++i) {
    if (hasAxleBit(seats, i) != hasAxleBit(seats, i + 1)) {
      bushes |= std::uint64_t{1} << axleBit(hasAxleBit(seats, i) ? i + 1 : i);
    }
  }
  return bushes;
}

//! The axle of this part from this slot on, if it holds all beams between `first` and `last`.
std::optional<Axle> holding(const AxleSite& site, int first, int last, int part, Axle axle) {
  const int end = axle.start + axleParts()[at(part)].length - 1;
  const bool stopped = axleParts()[at(part)].stopped;
  const bool bushBefore = !stopped || !axle.turned || axle.start != first;
  const bool bushAfter = !stopped || axle.turned || end != last;
  if (axle.start > first - (bushBefore ? 1 : 0) || end < last + (bushAfter ? 1 : 0)) {
    return std::nullopt;
  }
  std::uint64_t bushes = innerBushes(site.seats, first, last);
  bushes |= bushBefore ? std::uint64_t{1} << axleBit(first - 1) : 0U;
  bushes |= bushAfter ? std::uint64_t{1} << axleBit(last + 1) : 0U;
  axle.part = part;
  axle.bushes = static_cast<std::uint32_t>(bushes >> axleBit(axle.start));
  axle.seats = static_cast<std::uint32_t>(site.seats >> axleBit(axle.start));
  return axle;
}

int forbiddenSlots(const AxleSite& site, int start, int length) {
  const std::uint64_t slots = ((std::uint64_t{1} << static_cast<unsigned>(length)) - 1)
                              << axleBit(start);
  return std::popcount(site.forbidden & slots);
}

}  // namespace

int Axle::length() const {
  return part < 0 ? 0 : axleParts()[at(part)].length;
}

int Axle::bushCount() const {
  return std::popcount(bushes);
}

int Axle::headCount() const {
  return std::popcount(seats);
}

double Axle::cost() const {
  return static_cast<double>(1 + bushCount()) +
         kBodyCost * static_cast<double>(length() - headCount()) +
         kHeadCost * static_cast<double>(headCount());
}

Axle layAxle(const AxleSite& site, const std::vector<int>& parts) {
  int first = site.edges + kAxleReach + 1;
  int last = -kAxleReach - 1;
  for (int i = -kAxleReach; i <= site.edges + kAxleReach; ++i) {
    first = hasAxleBit(site.seats, i) ? std::min(first, i) : first;
    last = hasAxleBit(site.seats, i) ? i : last;
  }
  Axle best;
  auto least = std::tuple(0, 0, 0.0);
  for (const int part : parts) {
    const int length = axleParts()[at(part)].length;
    const bool stopped = axleParts()[at(part)].stopped;
    const int highest = std::min(0, site.edges + kAxleReach - length + 1);
    for (int start = std::max(-kAxleReach, site.edges - length + 1); start <= highest; ++start) {
      for (int turned = 0; turned <= (stopped ? 1 : 0); ++turned) {
        Axle plain;
        plain.start = start;
        plain.turned = turned != 0;
        const std::optional<Axle> whole =
            last < first ? std::nullopt : holding(site, first, last, part, plain);
        plain.part = part;
        const Axle axle = whole.value_or(plain);
        const auto rank =
            std::tuple(whole ? 0 : 1, forbiddenSlots(site, start, length), axle.cost());
        if (!best.used() || rank < least) {
          least = rank;
          best = axle;
        }
      }
    }
  }
  return best;
}

std::uint64_t heldOn(const Axle& axle, std::uint64_t seats) {
  const bool stopped = axleParts()[at(axle.part)].stopped;
  const auto stops = [&](int index, int side) {
    return axle.hasBush(index + side) || (stopped && side == (axle.turned ? -1 : 1) &&
                                          index == (axle.turned ? axle.start : axle.last()));
  };
  std::uint64_t held = 0;
  for (int i = axle.start; i <= axle.last(); ++i) {
    bool both = hasAxleBit(seats, i) && !axle.hasBush(i);
    for (const int side : {-1, 1}) {
      int end = i;
      while (both && !stops(end, side)) {
        end += side;
        both = end >= axle.start && end <= axle.last() && hasAxleBit(seats, end);
      }
    }
    held |= both ? std::uint64_t{1} << axleBit(i) : 0U;
  }
  return held;
}

std::vector<AxlePart> axlePartsOf(const std::vector<parts::Part>& parts) {
  std::vector<AxlePart> axles;
  for (const parts::Part& part : parts) {
    if (std::optional<AxlePart> axle = axlePartOf(part)) {
      axles.push_back(std::move(*axle));
    }
  }
  std::sort(axles.begin(), axles.end(), [](const AxlePart& a, const AxlePart& b) {
    return std::tuple(a.length, a.stopped, a.part) < std::tuple(b.length, b.stopped, b.part);
  });
  return axles;
}

const std::vector<AxlePart>& axleParts() {
  static const std::vector<AxlePart> kAxles = axlePartsOf(parts::Catalogue::builtIn().parts());
  return kAxles;
}

int axlePartIndex(const std::string& part) {
  return indexOfPart(axleParts(), part);
}

std::vector<int> allAxleParts() {
  return indicesOf(axleParts());
}

}  // namespace liftarm::layout
