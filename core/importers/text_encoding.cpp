#include "importers/text_encoding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace liftarm::importers {

namespace {

//! Share of zero bytes at even or odd places from which text is taken for UTF-16.
constexpr double kWide = 0.3;
constexpr std::size_t kFirstBytes = 512;
constexpr char32_t kUnknown = 0xFFFD;

//! What Windows has between 0x80 and 0x9F.
constexpr std::array<char32_t, 32> kWindows{
    0x20AC, 0x81,   0x201A, 0x192,  0x201E, 0x2026, 0x2020, 0x2021, 0x2C6,  0x2030, 0x160,
    0x2039, 0x152,  0x8D,   0x17D,  0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x2DC,  0x2122, 0x161,  0x203A, 0x153,  0x9D,   0x17E,  0x178};

void append(std::string& text, char32_t c) {
  const auto byte = [&](char32_t value) { text += static_cast<char>(value); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | (c >> 6U));
    byte(0x80 | (c & 0x3FU));
  } else if (c < 0x10000) {
    byte(0xE0 | (c >> 12U));
    byte(0x80 | ((c >> 6U) & 0x3FU));
    byte(0x80 | (c & 0x3FU));
  } else {
    byte(0xF0 | (c >> 18U));
    byte(0x80 | ((c >> 12U) & 0x3FU));
    byte(0x80 | ((c >> 6U) & 0x3FU));
    byte(0x80 | (c & 0x3FU));
  }
}

std::uint8_t byteAt(std::string_view bytes, std::size_t i) {
  return static_cast<std::uint8_t>(bytes[i]);
}

//! 0 where the low byte of each letter comes first, 1 where the high one does; nothing where text
//! is not wide.
std::optional<std::size_t> highFirst(std::string_view bytes) {
  if (bytes.size() >= 2 && byteAt(bytes, 0) == 0xFF && byteAt(bytes, 1) == 0xFE) {
    return 0;
  }
  if (bytes.size() >= 2 && byteAt(bytes, 0) == 0xFE && byteAt(bytes, 1) == 0xFF) {
    return 1;
  }
  const std::size_t size = std::min(kFirstBytes, bytes.size());
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < size; ++i) {
    zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
  }
  const double enough = kWide * static_cast<double>(size) / 2;
  if (size > 3 && static_cast<double>(zeros[1]) > enough) {
    return 0;
  }
  return size > 3 && static_cast<double>(zeros[0]) > enough ? std::optional<std::size_t>(1)
                                                            : std::nullopt;
}

std::string fromWide(std::string_view bytes, std::size_t high) {
  std::string text;
  const auto unit = [&](std::size_t i) -> char32_t {
    return static_cast<char32_t>(byteAt(bytes, i + (1 - high))) << 8U | byteAt(bytes, i + high);
  };
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const char32_t first = unit(i);
    const bool pair = first >= 0xD800 && first < 0xDC00 && i + 3 < bytes.size();
    const char32_t second = pair ? unit(i + 2) : 0;
    if (second >= 0xDC00 && second < 0xE000) {
      append(text, 0x10000 + ((first - 0xD800) << 10U) + (second - 0xDC00));
      i += 2;
    } else {
      append(text, first >= 0xD800 && first < 0xE000 ? kUnknown : first);
    }
  }
  return text;
}

//! How many bytes a letter of UTF-8 takes that begins here; 0 where none begins.
std::size_t letterSize(std::string_view bytes, std::size_t at) {
  const std::uint8_t lead = byteAt(bytes, at);
  if (lead < 0x80) {
    return 1;
  }
  const std::size_t size = lead >= 0xC2 && lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (lead < 0xC2 || size == 0 || at + size > bytes.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < size; ++i) {
    if ((byteAt(bytes, at + i) & 0xC0U) != 0x80) {
      return 0;
    }
  }
  const std::uint8_t next = byteAt(bytes, at + 1);
  const bool overlong = (lead == 0xE0 && next < 0xA0) || (lead == 0xF0 && next < 0x90);
  const bool none = (lead == 0xED && next >= 0xA0) || (lead == 0xF4 && next >= 0x90);
  return overlong || none ? 0 : size;
}

bool isUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t size = letterSize(bytes, i);
    if (size == 0) {
      return false;
    }
    i += size;
  }
  return true;
}

std::string fromWindows(std::string_view bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint8_t byte = byteAt(bytes, i);
    append(text, byte >= 0x80 && byte < 0xA0 ? kWindows[byte - 0x80U] : byte);
  }
  return text;
}

}  // namespace

std::string decodedText(std::string_view bytes) {
  const std::optional<std::size_t> high = highFirst(bytes);
  std::string text = high            ? fromWide(bytes, *high)
                     : isUtf8(bytes) ? std::string(bytes)
                                     : fromWindows(bytes);
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.compare(0, kMark.size(), kMark) == 0) {
    text.erase(0, kMark.size());
  }
  return text;
}

}  // namespace liftarm::importers
