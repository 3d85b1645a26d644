#include "layout/frame_beam.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "layout/part_list.h"

namespace liftarm::layout {

namespace {

using lattice::Vec3;
using parts::Feature;
using parts::FeatureKind;

constexpr std::size_t kFewestBars = 3;
constexpr int kMostNodes = 32;

bool parallel(Vec3 a, Vec3 b) {
  return std::abs(lattice::dot(a, b)) > 1.0 - kSamePlace;
}

//! Each bar of the solid must be one that covers, or something would stand where no run is.
bool hasOnlyBars(const parts::Part& part) {
  return part.solid.size() == part.stretches.size() &&
         std::all_of(part.solid.begin(), part.solid.end(), [&](const parts::Prism& prism) {
           return std::any_of(
               part.stretches.begin(), part.stretches.end(), [&](const parts::Stretch& stretch) {
                 return (isSamePlace(prism.from, stretch.from) &&
                         isSamePlace(prism.to, stretch.to)) ||
                        (isSamePlace(prism.from, stretch.to) &&
                         isSamePlace(prism.to, stretch.from));
               });
         });
}

//! A stretch as a bar; none where a node has no round hole, or one that goes along the bar.
std::optional<FrameBar> barOf(const parts::Part& part, const parts::Stretch& stretch, Vec3 normal) {
  const double length = lattice::length(stretch.to - stretch.from);
  FrameBar bar{stretch.from,
               (1.0 / length) * (stretch.to - stretch.from),
               static_cast<int>(std::lround(length)) + 1,
               0};
  if (bar.nodes > kMostNodes || !(std::abs(lattice::dot(bar.direction, normal)) < kSamePlace)) {
    return std::nullopt;
  }
  for (int i = 0; i < bar.nodes; ++i) {
    const Vec3 at = bar.from + static_cast<double>(i) * bar.direction;
    const auto hole =
        std::find_if(part.features.begin(), part.features.end(), [&](const Feature& feature) {
          return feature.kind == FeatureKind::kPinHole && isSamePlace(feature.center, at);
        });
    if (hole == part.features.end() || parallel(hole->axis, bar.direction)) {
      return std::nullopt;
    }
    bar.crossed |= parallel(hole->axis, normal) ? 0U : 1U << static_cast<unsigned>(i);
  }
  return bar;
}

std::vector<FrameCrossing> crossingsOf(const std::vector<FrameBar>& bars) {
  std::vector<FrameCrossing> crossings;
  for (std::size_t a = 0; a < bars.size(); ++a) {
    for (std::size_t b = a + 1; b < bars.size(); ++b) {
      for (int i = 0; i < bars[a].nodes; ++i) {
        const Vec3 at = bars[a].from + static_cast<double>(i) * bars[a].direction;
        const Vec3 offset = at - bars[b].from;
        const auto j = static_cast<int>(std::lround(lattice::dot(offset, bars[b].direction)));
        if (j >= 0 && j < bars[b].nodes &&
            isSamePlace(offset, static_cast<double>(j) * bars[b].direction)) {
          crossings.push_back({static_cast<int>(a), i, static_cast<int>(b), j});
        }
      }
    }
  }
  return crossings;
}

std::optional<FrameBeam> frameFrom(const parts::Part& part) {
  if (part.partClass != parts::PartClass::kBeam || part.thickness != 1.0 ||
      part.stretches.size() < kFewestBars || !hasOnlyBars(part)) {
    return std::nullopt;
  }
  FrameBeam frame;
  frame.part = part.id;
  for (const parts::Stretch& stretch : part.stretches) {
    const std::optional<FrameBar> bar = barOf(part, stretch, part.solid.front().axis);
    const bool square =
        bar && (frame.bars.empty() || parallel(bar->direction, frame.bars.front().direction) ||
                std::abs(lattice::dot(bar->direction, frame.bars.front().direction)) < kSamePlace);
    if (!square) {
      return std::nullopt;
    }
    frame.bars.push_back(*bar);
  }
  frame.crossings = crossingsOf(frame.bars);
  const bool crossed =
      !frame.crossings.empty() &&
      std::all_of(
          frame.crossings.begin(), frame.crossings.end(), [&](const FrameCrossing& crossing) {
            const auto a = static_cast<std::size_t>(crossing.barA);
            const auto b = static_cast<std::size_t>(crossing.barB);
            return !parallel(frame.bars[a].direction, frame.bars[b].direction);
          });
  return crossed ? std::optional<FrameBeam>(std::move(frame)) : std::nullopt;
}

}  // namespace

std::vector<FrameBeam> frameBeamsOf(const std::vector<parts::Part>& parts) {
  std::vector<FrameBeam> all;
  for (const parts::Part& part : parts) {
    if (auto frame = frameFrom(part)) {
      all.push_back(std::move(*frame));
    }
  }
  std::sort(all.begin(), all.end(), [](const FrameBeam& a, const FrameBeam& b) {
    return a.part < b.part;
  });
  return all;
}

const std::vector<FrameBeam>& frameBeams() {
  static const std::vector<FrameBeam> all = frameBeamsOf(parts::Catalogue::builtIn().parts());
  return all;
}

int frameBeamIndex(const std::string& part) {
  return indexOfPart(frameBeams(), part);
}

std::vector<int> allFrameBeams() {
  return indicesOf(frameBeams());
}

}  // namespace liftarm::layout
