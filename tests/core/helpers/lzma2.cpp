#include "core/helpers/lzma2.h"

#include <array>

#include <lzma.h>

namespace liftarm::testing {

namespace {

constexpr std::uint64_t kMemoryLimit = std::uint64_t{1} << 30U;

}  // namespace

std::vector<std::uint8_t> unpackLzma2(std::span<const std::uint8_t> packed, std::size_t size) {
  lzma_options_lzma options{};
  lzma_lzma_preset(&options, 9);  // the largest dictionary: it reads what smaller ones have written
  const std::array<lzma_filter, 2> filters{
      {{LZMA_FILTER_LZMA2, &options}, {LZMA_VLI_UNKNOWN, nullptr}}};
  std::vector<std::uint8_t> out(size);
  std::size_t read = 0;
  std::size_t written = 0;
  lzma_raw_buffer_decode(
      filters.data(), nullptr, packed.data(), &read, packed.size(), out.data(), &written, size);
  out.resize(written);
  return out;
}

std::vector<std::uint8_t> unpackXz(std::span<const std::uint8_t> file) {
  std::vector<std::uint8_t> out;
  lzma_stream stream = LZMA_STREAM_INIT;
  if (lzma_stream_decoder(&stream, kMemoryLimit, 0) != LZMA_OK) {
    return out;
  }
  std::array<std::uint8_t, 1U << 16U> chunk{};
  stream.next_in = file.data();
  stream.avail_in = file.size();
  lzma_ret result = LZMA_OK;
  while (result == LZMA_OK) {
    stream.next_out = chunk.data();
    stream.avail_out = chunk.size();
    result = lzma_code(&stream, LZMA_FINISH);
    out.insert(out.end(), chunk.data(), stream.next_out);
  }
  lzma_end(&stream);
  return result == LZMA_STREAM_END ? out : std::vector<std::uint8_t>{};
}

}  // namespace liftarm::testing
