#include "analysis/blocking.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

// Parts whose shadows share less than this touch at most.
constexpr double kMeet = 0.03;

//! Two unit vectors across a third.
std::pair<Vec3, Vec3> across(Vec3 axis) {
  const Vec3 helper = std::abs(axis.z) > 0.5 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 first = lattice::normalized(lattice::cross(axis, helper));
  return {first, lattice::cross(axis, first)};
}

struct Reach {
  Sweep::Extent u;
  Sweep::Extent v;
  Sweep::Extent along;
};

bool apart(const Sweep::Extent& a, const Sweep::Extent& b) {
  return std::min(a.max, b.max) - std::max(a.min, b.min) <= kMeet;
}

}  // namespace

std::vector<Vec3> usefulAxes(const Scene& scene) {
  std::vector<Vec3> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<int> counts(3, 0);
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (scene.parts[i].part == nullptr) {
      continue;
    }
    for (const parts::Feature& feature : scene.parts[i].part->features) {
      const Vec3 axis = lattice::normalized(scene.model->parts[i].pose.rotation * feature.axis);
      const auto same = std::find_if(axes.begin(), axes.end(), [&](Vec3 known) {
        return std::abs(lattice::dot(axis, known)) >= model::kCoaxialCosine;
      });
      if (same == axes.end()) {
        axes.push_back(axis);
        counts.push_back(1);
      } else {
        ++counts[static_cast<std::size_t>(same - axes.begin())];
      }
    }
  }
  std::vector<std::size_t> order(axes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin() + 3, order.end(), [&](std::size_t a, std::size_t b) {
    return counts[a] > counts[b];
  });
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < order.size() && i < kMaxAxes; ++i) {
    result.push_back(axes[order[i]]);
  }
  return result;
}

BlockingGraph::BlockingGraph(const Scene& scene, const Sweep& sweep) {
  for (const Vec3 axis : usefulAxes(scene)) {
    addAxis(axis, scene.parts.size(), sweep);
  }
}

void BlockingGraph::addAxis(Vec3 axis, std::size_t parts, const Sweep& sweep) {
  directions_.push_back(axis);
  directions_.push_back(-axis);
  std::vector<std::vector<int>> forward(parts);
  std::vector<std::vector<int>> backward(parts);
  const auto [u, v] = across(axis);
  std::vector<Reach> reach;
  for (std::size_t i = 0; i < parts; ++i) {
    const int part = static_cast<int>(i);
    reach.push_back({sweep.extent(part, u), sweep.extent(part, v), sweep.extent(part, axis)});
  }
  std::vector<std::size_t> order(parts);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(reach[a].u.min, a) < std::pair(reach[b].u.min, b);
  });
  // Whether `fixed` is in the way of `mover` along the axis.
  const auto test = [&](std::size_t mover, std::size_t fixed) {
    const double distance = reach[fixed].along.max - reach[mover].along.min;
    const int a = static_cast<int>(mover);
    const int b = static_cast<int>(fixed);
    if (distance > kMeet && sweep.blocks(a, b, {axis, distance, {}}) &&
        !sweep.overlapInPlace(a, b)) {
      forward[mover].push_back(b);
      backward[fixed].push_back(a);
    }
  };
  std::vector<std::size_t> active;
  for (const std::size_t i : order) {
    active.erase(std::remove_if(active.begin(),
                                active.end(),
                                [&](std::size_t j) { return reach[j].u.max <= reach[i].u.min; }),
                 active.end());
    for (const std::size_t j : active) {
      if (!apart(reach[i].u, reach[j].u) && !apart(reach[i].v, reach[j].v)) {
        test(i, j);
        test(j, i);
      }
    }
    active.push_back(i);
  }
  for (auto* lists : {&forward, &backward}) {
    for (std::vector<int>& list : *lists) {
      std::sort(list.begin(), list.end());
    }
    blockers_.push_back(std::move(*lists));
  }
}

}  // namespace liftarm::analysis
