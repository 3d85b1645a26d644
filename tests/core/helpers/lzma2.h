#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace liftarm::testing {

//! \brief Unpacks one raw LZMA2 stream (no .xz container).
//! \param size Bytes of what is packed; broken input gives fewer.
std::vector<std::uint8_t> unpackLzma2(std::span<const std::uint8_t> packed, std::size_t size);

//! \brief Unpacks an .xz file; empty when it is broken.
std::vector<std::uint8_t> unpackXz(std::span<const std::uint8_t> file);

}  // namespace liftarm::testing
