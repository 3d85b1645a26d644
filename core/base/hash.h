#pragma once

#include <cstdint>

namespace liftarm::base {

//! \brief Mixes one word into a running 64-bit hash; the order of the words matters.
constexpr std::uint64_t mixHash(std::uint64_t hash, std::uint64_t word) {
  std::uint64_t z = hash ^ (word + 0x9e3779b97f4a7c15ULL + (hash << 6U) + (hash >> 2U));
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

}  // namespace liftarm::base
