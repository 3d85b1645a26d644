#pragma once

#include <atomic>

namespace liftarm::base {

//! \brief A request to stop, shared between the one who runs and the one who waits.
//! \details Passed down by pointer; null means that nobody watches. It never changes what a run
//! that is not stopped computes.
class RunControl {
 public:
  void requestStop() { stop_.store(true, std::memory_order_relaxed); }

  [[nodiscard]] bool stopRequested() const { return stop_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> stop_{false};
};

}  // namespace liftarm::base
