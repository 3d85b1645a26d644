#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gears/train.h"

namespace liftarm::gears {

//! \brief Rows of gears in one plane, each in mesh with the next, that end where they should.
//! \details A table over steps, gear and way that is left says which gears can be the last; it is
//! built backwards, as in dynamic programming, so a walk through it never comes to a dead end.
class ChainReach {
 public:
  //! \param width Ways are shorter than this on both axes, modules.
  ChainReach(const std::vector<int>& teeth, int width);

  //! \brief What a chain has to do: gears at its ends, its steps, and the way they go together.
  struct Task {
    int first = 0;  //!< index among the teeth
    int last = 0;
    int steps = 1;
    Place way;
  };

  struct Chain {
    std::vector<int> sizes;    //!< of its gears, one more than steps
    std::vector<Place> steps;  //!< along one axis each, never away from the end
  };

  //! \brief Calls `visit` with each chain, in a fixed order, until it returns true.
  void eachChain(const Task& task, const std::function<bool(const Chain&)>& visit) const;

 private:
  [[nodiscard]] std::size_t indexOf(int steps, int size, int du, int dv) const;
  bool walk(const Task& task, Chain& chain, const std::function<bool(const Chain&)>& visit) const;

  std::vector<int> teeth_;
  int width_;
  std::vector<std::uint32_t> ends_;  // bit i: gear i can be the last
};

}  // namespace liftarm::gears
