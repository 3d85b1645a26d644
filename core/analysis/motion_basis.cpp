#include "analysis/motion_basis.h"

#include <algorithm>
#include <array>
#include <map>

#include "analysis/rank_sparse.h"
#include "analysis/union_find.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;

//! Middle and half size of the lines of some links.
struct Extent {
  Vec3 middle;
  double unit = 1.0;
};

Extent extentOf(const Linkage& linkage, const std::vector<int>& links) {
  Extent extent;
  for (const int l : links) {
    extent.middle =
        extent.middle + (1.0 / static_cast<double>(links.size())) * linkage.links[at(l)].at;
  }
  for (const int l : links) {
    extent.unit = std::max(extent.unit, lattice::length(linkage.links[at(l)].at - extent.middle));
  }
  return extent;
}

}  // namespace

MotionBasis::MotionBasis(const Linkage& linkage, const std::vector<int>& lateness)
    : linkage_(linkage) {
  for (std::size_t l = 0; l < linkage.links.size(); ++l) {
    firstColumn_.push_back(columns_.size());
    for (const Twist& screw : screwsOf(linkage.links[l])) {
      columns_.push_back({static_cast<int>(l), screw});
    }
  }
  firstColumn_.push_back(columns_.size());
  growTree();
  for (const std::vector<int>& block : blocks()) {
    solveBlock(block, lateness);
  }
}

void MotionBasis::growTree() {
  const auto bodies = at(linkage_.bodies);
  std::vector<std::vector<int>> linksOf(bodies);
  for (std::size_t l = 0; l < linkage_.links.size(); ++l) {
    linksOf[at(linkage_.links[l].a)].push_back(static_cast<int>(l));
    linksOf[at(linkage_.links[l].b)].push_back(static_cast<int>(l));
  }
  steps_.resize(bodies);
  depths_.assign(bodies, 0);
  assemblies_.assign(bodies, -1);
  inTree_.assign(linkage_.links.size(), false);
  int assembly = 0;
  for (int root = 0; root < linkage_.bodies; ++root) {
    if (assemblies_[at(root)] >= 0) {
      continue;
    }
    assemblies_[at(root)] = assembly;
    std::size_t head = order_.size();
    order_.push_back(root);
    for (; head < order_.size(); ++head) {
      const int body = order_[head];
      for (const int l : linksOf[at(body)]) {
        const Link& link = linkage_.links[at(l)];
        const int next = link.a == body ? link.b : link.a;
        if (assemblies_[at(next)] < 0) {
          assemblies_[at(next)] = assembly;
          steps_[at(next)] = {body, l};
          depths_[at(next)] = depths_[at(body)] + 1;
          inTree_[at(l)] = true;
          order_.push_back(next);
        }
      }
    }
    ++assembly;
  }
}

double MotionBasis::signAlong(int link, int from) const {
  return linkage_.links[at(link)].a == from ? 1.0 : -1.0;
}

//! The links of the loop that a link outside the tree closes: itself, then the way back from its b
//! to its a. Empty for links of the tree.
std::vector<int> MotionBasis::loopOf(int link) const {
  if (inTree_[at(link)]) {
    return {};
  }
  int up = linkage_.links[at(link)].b;
  int down = linkage_.links[at(link)].a;
  std::vector<int> there{link};
  std::vector<int> back;
  while (up != down) {
    int& deeper = depths_[at(up)] >= depths_[at(down)] ? up : down;
    (&deeper == &up ? there : back).push_back(steps_[at(deeper)].link);
    deeper = steps_[at(deeper)].parent;
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  return there;
}

std::vector<std::vector<int>> MotionBasis::blocks() const {
  UnionFind sameBlock(linkage_.links.size());
  for (int l = 0; l < static_cast<int>(linkage_.links.size()); ++l) {
    for (const int other : loopOf(l)) {
      sameBlock.join(l, other);
    }
  }
  std::map<int, std::vector<int>> found;
  for (int l = 0; l < static_cast<int>(linkage_.links.size()); ++l) {
    found[sameBlock.find(l)].push_back(l);
  }
  std::vector<std::vector<int>> result;
  for (auto& [first, links] : found) {
    result.push_back(std::move(links));
  }
  return result;
}

void MotionBasis::solveBlock(const std::vector<int>& links, const std::vector<int>& lateness) {
  std::map<int, std::size_t> local;  // link -> first column of the block's matrix
  std::vector<std::size_t> global;
  std::vector<int> late;
  std::vector<int> loops;
  for (const int l : links) {
    local[l] = global.size();
    for (std::size_t c = firstColumn_[at(l)]; c < firstColumn_[at(l) + 1]; ++c) {
      global.push_back(c);
      late.push_back(lateness[at(l)]);
    }
    if (!inTree_[at(l)]) {
      loops.push_back(l);
    }
  }
  const Extent extent = extentOf(linkage_, links);
  ColumnMatrix matrix(6 * loops.size(), global.size());
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    int body = linkage_.links[at(loops[loop])].a;
    for (const int l : loopOf(loops[loop])) {
      const Link& link = linkage_.links[at(l)];
      const double sign = signAlong(l, body);
      body = link.a == body ? link.b : link.a;
      const std::size_t first = firstColumn_[at(l)];
      for (std::size_t c = first; c < firstColumn_[at(l) + 1]; ++c) {
        const std::array<double, 6> entry =
            scaled(sign * columns_[c].screw, extent.middle, extent.unit);
        std::copy(entry.begin(), entry.end(), matrix.column(local[l] + c - first) + 6 * loop);
      }
    }
  }
  const NullBasis basis = findNullBasisOfAny(matrix, late);
  for (const std::size_t column : basis.free) {
    const Column& free = columns_[global[column]];
    drivers_.push_back({free.link, free.screw.angular == Vec3{}});
  }
  for (const std::vector<double>& vector : basis.vectors) {
    rates_.emplace_back(columns_.size(), 0.0);
    for (std::size_t c = 0; c < vector.size(); ++c) {
      rates_.back()[global[c]] = vector[c];
    }
  }
  if (basis.vectors.empty()) {
    for (const int l : links) {
      locked_.emplace_back(linkage_.links[at(l)].a, linkage_.links[at(l)].b);
    }
  }
}

std::vector<Twist> MotionBasis::twists(std::size_t motion) const {
  std::vector<Twist> result(at(linkage_.bodies));
  for (const int body : order_) {
    const Step& step = steps_[at(body)];
    if (step.parent < 0) {
      continue;
    }
    Twist twist = result[at(step.parent)];
    const double sign = signAlong(step.link, step.parent);
    for (std::size_t c = firstColumn_[at(step.link)]; c < firstColumn_[at(step.link) + 1]; ++c) {
      twist = twist + (sign * rates_[motion][c]) * columns_[c].screw;
    }
    result[at(body)] = twist;
  }
  return result;
}

}  // namespace liftarm::analysis
