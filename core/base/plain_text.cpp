#include "base/plain_text.h"

#include <cstddef>

namespace liftarm::base {

namespace {

//! A character and how many bytes spell it; no bytes where the text is no UTF-8.
struct Character {
  char32_t value = 0;
  std::size_t bytes = 0;
};

unsigned byteAt(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

Character characterAt(std::string_view text, std::size_t i) {
  const unsigned first = byteAt(text, i);
  if (first < 0x80U) {
    return {first, 1};
  }
  const std::size_t bytes = first >= 0xF0U ? 4 : (first >= 0xE0U ? 3 : 2);
  if (first < 0xC2U || first > 0xF4U || i + bytes > text.size()) {
    return {};
  }
  char32_t value = first & (0xFFU >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    const unsigned next = byteAt(text, i + k);
    if ((next & 0xC0U) != 0x80U) {
      return {};
    }
    value = (value << 6U) | (next & 0x3FU);
  }
  return {value, bytes};
}

bool steers(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x200E || c == 0x200F ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

}  // namespace

std::string plainText(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Character character = characterAt(text, i);
    if (character.bytes == 0) {
      result += '?';
      ++i;
      continue;
    }
    if (steers(character.value)) {
      result += ' ';
    } else {
      result += text.substr(i, character.bytes);
    }
    i += character.bytes;
  }
  return result;
}

}  // namespace liftarm::base
