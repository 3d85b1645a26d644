#include "layout/stack.h"

#include <algorithm>
#include <array>

namespace liftarm::layout {

namespace {

constexpr int kMostInStack = 4;  // an axle of five modules, with stop and bush, holds no more

constexpr StackFaults faultsOf(unsigned layers) {
  int low = -1;
  int high = -1;
  int count = 0;
  for (int l = 0; l < kLayerCount; ++l) {
    if ((layers >> static_cast<unsigned>(l) & 1U) != 0U) {
      low = low < 0 ? l : low;
      high = l;
      ++count;
    }
  }
  if (count == 0) {
    return {};
  }
  const int gaps = high - low + 1 - count;
  return {gaps, std::max(0, count - kMostInStack), count + gaps <= kMostInStack ? gaps : 0};
}

using FaultTable = std::array<StackFaults, 1U << static_cast<unsigned>(kLayerCount)>;

constexpr FaultTable countAll() {
  FaultTable all{};
  for (unsigned layers = 0; layers < all.size(); ++layers) {
    all[layers] = faultsOf(layers);
  }
  return all;
}

constexpr FaultTable kFaults = countAll();  // asked for each node of each cover

}  // namespace

StackFaults stackFaults(unsigned layers) {
  return kFaults[layers];
}

}  // namespace liftarm::layout
