#include "gears/chain_reach.h"

#include <cstdlib>

#include "base/check.h"
#include "base/index.h"
#include "gears/gear_sizes.h"

namespace liftarm::gears {

namespace {

using base::at;

}  // namespace

ChainReach::ChainReach(const std::vector<int>& teeth, int width) : teeth_(teeth), width_(width) {
  const int sizes = static_cast<int>(teeth.size());
  LIFTARM_CHECK(sizes > 0 && sizes <= 16, "a mask holds every size of gears");
  ends_.assign(at(kMostShafts) * at(sizes) * at(width) * at(width), 0);
  for (int i = 0; i < sizes; ++i) {
    ends_[indexOf(0, i, 0, 0)] = 1U << static_cast<unsigned>(i);
  }
  for (int steps = 1; steps < kMostShafts; ++steps) {
    for (int i = 0; i < sizes; ++i) {
      for (int next = 0; next < sizes; ++next) {
        if (!meshOnLattice(teeth[at(i)], teeth[at(next)])) {
          continue;
        }
        const int d = meshDistance(teeth[at(i)], teeth[at(next)]);
        for (int du = 0; du < width; ++du) {
          for (int dv = 0; dv < width; ++dv) {
            std::uint32_t& ends = ends_[indexOf(steps, i, du, dv)];
            ends |= du >= d ? ends_[indexOf(steps - 1, next, du - d, dv)] : 0U;
            ends |= dv >= d ? ends_[indexOf(steps - 1, next, du, dv - d)] : 0U;
          }
        }
      }
    }
  }
}

std::size_t ChainReach::indexOf(int steps, int size, int du, int dv) const {
  return ((at(steps) * teeth_.size() + at(size)) * at(width_) + at(du)) * at(width_) + at(dv);
}

void ChainReach::eachChain(const Task& task, const std::function<bool(const Chain&)>& visit) const {
  if (std::abs(task.way.u) < width_ && std::abs(task.way.v) < width_) {
    Chain chain{{task.first}, {}};
    walk(task, chain, visit);
  }
}

//! \param task What is left of it. \return True when `visit` has had enough.
bool ChainReach::walk(const Task& task,
                      Chain& chain,
                      const std::function<bool(const Chain&)>& visit) const {
  const int du = std::abs(task.way.u);
  const int dv = std::abs(task.way.v);
  const unsigned ends = ends_[indexOf(task.steps, task.first, du, dv)];
  if ((ends >> static_cast<unsigned>(task.last) & 1U) == 0U) {
    return false;
  }
  if (task.steps == 0) {
    return visit(chain);
  }
  for (int next = 0; next < static_cast<int>(teeth_.size()); ++next) {
    if (!meshOnLattice(teeth_[at(task.first)], teeth_[at(next)])) {
      continue;
    }
    const int d = meshDistance(teeth_[at(task.first)], teeth_[at(next)]);
    for (const Place step :
         {Place{task.way.u < 0 ? -d : d, 0}, Place{0, task.way.v < 0 ? -d : d}}) {
      if (std::abs(step.u) > du || std::abs(step.v) > dv) {
        continue;
      }
      chain.sizes.push_back(next);
      chain.steps.push_back(step);
      const bool enough = walk({next, task.last, task.steps - 1, task.way - step}, chain, visit);
      chain.sizes.pop_back();
      chain.steps.pop_back();
      if (enough) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace liftarm::gears
