#include "rivals/schedules.h"

#include <algorithm>
#include <cmath>

#include "base/det_math.h"

namespace liftarm::rivals {

namespace {

using search::CooledMove;
using search::Cooling;
using search::CoolingPlan;

constexpr double kLog2 = 0.69314718055994530942;
constexpr std::uint64_t kBlocks = 400;  // of the optimum schedule
// Of one block: the exponential schedule falls by ln(2e7) = 16.8 over all of them. A block at which
// the energy hardly varies tells nothing, so it may not fall by more than half.
constexpr double kSpeed = 0.25;
constexpr double kFastest = 0.7;

class Linear final : public Cooling {
 public:
  explicit Linear(const CoolingPlan& plan) : plan_(plan) {}

  double next(const CooledMove& /*move*/) override {
    ++moves_;
    const double left = 1.0 - static_cast<double>(moves_) / static_cast<double>(plan_.moves);
    return plan_.end + (plan_.start - plan_.end) * std::max(0.0, left);
  }

 private:
  CoolingPlan plan_;
  std::uint64_t moves_ = 0;
};

class Logarithmic final : public Cooling {
 public:
  explicit Logarithmic(const CoolingPlan& plan) : start_(plan.start) {}

  double next(const CooledMove& /*move*/) override {
    moves_ += 1.0;
    return start_ * kLog2 / base::detLog(moves_ + 2.0);
  }

 private:
  double start_;
  double moves_ = 0.0;
};

class Optimum final : public Cooling {
 public:
  explicit Optimum(const CoolingPlan& plan)
      : plan_(plan), length_(std::max<std::uint64_t>(2, plan.moves / kBlocks)) {}

  double next(const CooledMove& move) override {
    ++count_;
    sum_ += move.energy;
    squares_ += move.energy * move.energy;
    if (count_ < length_) {
      return move.temperature;
    }
    const double n = static_cast<double>(count_);
    const double variance = std::max(0.0, squares_ / n - (sum_ / n) * (sum_ / n));
    const double deviation = std::sqrt(variance);
    count_ = 0;
    sum_ = squares_ = 0.0;
    const double step = deviation > 0.0 ? kSpeed * move.temperature / deviation : kFastest;
    return std::max(plan_.end, move.temperature * base::detExp(-std::min(step, kFastest)));
  }

 private:
  CoolingPlan plan_;
  std::uint64_t length_;
  std::uint64_t count_ = 0;
  double sum_ = 0.0;
  double squares_ = 0.0;
};

class Thermodynamic final : public Cooling {
 public:
  explicit Thermodynamic(const CoolingPlan& plan) : plan_(plan) {}

  double next(const CooledMove& move) override {
    change_ += move.change;
    entropy_ -= move.change > 0.0 ? move.change / move.temperature : 0.0;
    if (change_ >= 0.0 || entropy_ >= 0.0) {
      return plan_.start;
    }
    return std::max(plan_.end, change_ / entropy_);
  }

 private:
  CoolingPlan plan_;
  double change_ = 0.0;
  double entropy_ = 0.0;
};

}  // namespace

std::unique_ptr<Cooling> makeLinear(const CoolingPlan& plan) {
  return std::make_unique<Linear>(plan);
}

std::unique_ptr<Cooling> makeLogarithmic(const CoolingPlan& plan) {
  return std::make_unique<Logarithmic>(plan);
}

std::unique_ptr<Cooling> makeOptimum(const CoolingPlan& plan) {
  return std::make_unique<Optimum>(plan);
}

std::unique_ptr<Cooling> makeThermodynamic(const CoolingPlan& plan) {
  return std::make_unique<Thermodynamic>(plan);
}

}  // namespace liftarm::rivals
