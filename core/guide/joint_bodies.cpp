#include "guide/joint_bodies.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace liftarm::guide {

void partBodies(std::vector<std::vector<int>>& bodies,
                const std::vector<std::vector<int>>& groups) {
  const auto isIn = [](const std::vector<int>& group, int run) {
    return std::find(group.begin(), group.end(), run) != group.end();
  };
  std::vector<std::vector<int>> parts;
  for (std::vector<int> body : bodies) {
    for (const std::vector<int>& group : groups) {
      const auto rest = std::stable_partition(
          body.begin(), body.end(), [&](int run) { return isIn(group, run); });
      parts.emplace_back(body.begin(), rest);
      body.erase(body.begin(), rest);
    }
    parts.push_back(std::move(body));
  }
  for (const std::vector<int>& group : groups) {
    parts.emplace_back();
    std::copy_if(group.begin(), group.end(), std::back_inserter(parts.back()), [&](int run) {
      return std::none_of(
          bodies.begin(), bodies.end(), [&](const auto& body) { return isIn(body, run); });
    });
  }
  parts.erase(
      std::remove_if(parts.begin(), parts.end(), [](const auto& runs) { return runs.empty(); }),
      parts.end());
  bodies = std::move(parts);
}

}  // namespace liftarm::guide
