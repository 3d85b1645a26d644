#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace liftarm::testing {

//! \brief Unpacks one raw LZMA2 stream (no .xz container).
//! \details After the format notes of the public-domain LZMA specification (Igor Pavlov). For test
//! data only: broken input gives a short or empty answer, never a crash.
std::vector<std::uint8_t> unpackLzma2(std::span<const std::uint8_t> packed);

//! \brief Unpacks the first block of an .xz file; checksums are not looked at.
std::vector<std::uint8_t> unpackXz(std::span<const std::uint8_t> file);

}  // namespace liftarm::testing
