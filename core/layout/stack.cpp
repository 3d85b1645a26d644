#include "layout/stack.h"

#include <algorithm>

namespace liftarm::layout {

namespace {

constexpr int kMostInStack = 4;  // an axle of five modules, with stop and bush, holds no more

}  // namespace

StackFaults stackFaults(unsigned layers) {
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
  return {high - low + 1 - count, std::max(0, count - kMostInStack)};
}

}  // namespace liftarm::layout
