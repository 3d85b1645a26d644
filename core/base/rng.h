#pragma once

#include <array>
#include <cstdint>

namespace liftarm::base {

//! \brief xoshiro256** seeded by splitmix64: the same stream on every platform (DESIGN 2).
//! \details Blackman and Vigna, "Scrambled linear pseudorandom number generators", 2021. The
//! standard library's distributions differ between platforms, so the few that we need are members
//! here.
class Rng {
 public:
  explicit Rng(std::uint64_t seed);

  std::uint64_t next();

  //! \return A whole number in [0, bound), unbiased. \pre bound > 0.
  std::uint32_t below(std::uint32_t bound);

  //! \return A real number in [0, 1) with 53 random bits.
  double unit();

 private:
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace liftarm::base
