#include "core/helpers/lzma2.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace liftarm::testing {

namespace {

using Bit = std::uint16_t;
constexpr Bit kHalf = 1024;  // probability one half, of 2048

template <std::size_t N>
struct Bits {
  std::array<Bit, N> p;

  Bits() { p.fill(kHalf); }
};

class RangeDecoder {
 public:
  void start(std::span<const std::uint8_t> data) {
    data_ = data;
    at_ = 1;  // the first byte of a chunk is always 0
    range_ = 0xffffffffU;
    code_ = 0;
    for (int i = 0; i < 4; ++i) {
      code_ = (code_ << 8U) | byte();
    }
  }

  unsigned bit(Bit& p) {
    const std::uint32_t bound = (range_ >> 11U) * p;
    unsigned symbol = 0;
    if (code_ < bound) {
      range_ = bound;
      p = static_cast<Bit>(p + ((2048 - p) >> 5));
    } else {
      range_ -= bound;
      code_ -= bound;
      p = static_cast<Bit>(p - (p >> 5));
      symbol = 1;
    }
    normalize();
    return symbol;
  }

  unsigned direct(unsigned count) {
    unsigned result = 0;
    for (; count > 0; --count) {
      range_ >>= 1U;
      const unsigned symbol = code_ >= range_ ? 1U : 0U;
      code_ -= symbol * range_;
      result = (result << 1U) | symbol;
      normalize();
    }
    return result;
  }

  unsigned tree(Bit* p, unsigned bits) {
    unsigned m = 1;
    for (unsigned i = 0; i < bits; ++i) {
      m = (m << 1U) | bit(p[m]);
    }
    return m - (1U << bits);
  }

  unsigned reverseTree(Bit* p, unsigned bits) {
    unsigned m = 1;
    unsigned result = 0;
    for (unsigned i = 0; i < bits; ++i) {
      const unsigned b = bit(p[m]);
      m = (m << 1U) | b;
      result |= b << i;
    }
    return result;
  }

 private:
  std::uint32_t byte() { return at_ < data_.size() ? data_[at_++] : 0U; }

  void normalize() {
    if (range_ < (1U << 24U)) {
      range_ <<= 8U;
      code_ = (code_ << 8U) | byte();
    }
  }

  std::span<const std::uint8_t> data_;
  std::size_t at_ = 0;
  std::uint32_t range_ = 0;
  std::uint32_t code_ = 0;
};

struct LengthModel {
  Bits<2> choice;
  Bits<16 * 8> low;
  Bits<16 * 8> middle;
  Bits<256> high;

  unsigned decode(RangeDecoder& range, unsigned posState) {
    if (range.bit(choice.p[0]) == 0) {
      return 2 + range.tree(&low.p[posState * 8U], 3);
    }
    if (range.bit(choice.p[1]) == 0) {
      return 10 + range.tree(&middle.p[posState * 8U], 3);
    }
    return 18 + range.tree(high.p.data(), 8);
  }
};

//! Everything that a state reset throws away.
struct Model {
  std::vector<Bit> literal = std::vector<Bit>(0x300U << 4U, kHalf);
  Bits<12 * 16> isMatch;
  Bits<12> isRep;
  Bits<12> isRep0;
  Bits<12> isRep1;
  Bits<12> isRep2;
  Bits<12 * 16> isRep0Long;
  Bits<4 * 64> slot;
  Bits<128> special;
  Bits<16> align;
  LengthModel matchLength;
  LengthModel repLength;
  std::array<unsigned, 4> rep{};
  unsigned state = 0;
};

class Decoder {
 public:
  explicit Decoder(std::vector<std::uint8_t>& out) : out_(out) {}

  void resetState() { model_ = Model(); }

  void setProperties(unsigned value) {
    lc_ = value % 9;
    lp_ = value / 9 % 5;
    pb_ = value / 45;
  }

  void run(std::span<const std::uint8_t> packed, std::size_t count) {
    range_.start(packed);
    const std::size_t end = out_.size() + count;
    while (out_.size() < end) {
      const unsigned posState = static_cast<unsigned>(out_.size()) & ((1U << pb_) - 1U);
      if (range_.bit(model_.isMatch.p[model_.state * 16 + posState]) == 0) {
        literal();
        continue;
      }
      const unsigned length = match(posState);
      for (unsigned i = 0; i < length && out_.size() < end; ++i) {
        out_.push_back(back(model_.rep[0]));
      }
    }
  }

 private:
  std::uint8_t back(unsigned distance) const {
    return distance < out_.size() ? out_[out_.size() - 1 - distance] : std::uint8_t{0};
  }

  void literal() {
    const unsigned low = static_cast<unsigned>(out_.size()) & ((1U << lp_) - 1U);
    const unsigned context = (low << lc_) + (back(0) >> (8U - lc_));
    Bit* p = &model_.literal[0x300U * std::min(context, 15U)];
    unsigned symbol = 1;
    if (model_.state >= 7) {
      unsigned matched = back(model_.rep[0]);
      while (symbol < 0x100) {
        const unsigned matchBit = (matched >> 7U) & 1U;
        matched <<= 1U;
        const unsigned b = range_.bit(p[((1U + matchBit) << 8U) + symbol]);
        symbol = (symbol << 1U) | b;
        if (matchBit != b) {
          break;
        }
      }
    }
    while (symbol < 0x100) {
      symbol = (symbol << 1U) | range_.bit(p[symbol]);
    }
    out_.push_back(static_cast<std::uint8_t>(symbol));
    const unsigned s = model_.state;
    model_.state = s < 4 ? 0 : (s < 10 ? s - 3 : s - 6);
  }

  //! Reads a match, leaves its distance in rep[0] and returns its length.
  unsigned match(unsigned posState) {
    unsigned& s = model_.state;
    auto& rep = model_.rep;
    if (range_.bit(model_.isRep.p[s]) == 0) {
      rep = {rep[0], rep[0], rep[1], rep[2]};
      const unsigned length = model_.matchLength.decode(range_, posState);
      rep[0] = distance(length);
      s = s < 7 ? 7 : 10;
      return length;
    }
    if (range_.bit(model_.isRep0.p[s]) == 0) {
      if (range_.bit(model_.isRep0Long.p[s * 16 + posState]) == 0) {
        s = s < 7 ? 9 : 11;
        return 1;
      }
    } else if (range_.bit(model_.isRep1.p[s]) == 0) {
      rep = {rep[1], rep[0], rep[2], rep[3]};
    } else if (range_.bit(model_.isRep2.p[s]) == 0) {
      rep = {rep[2], rep[0], rep[1], rep[3]};
    } else {
      rep = {rep[3], rep[0], rep[1], rep[2]};
    }
    s = s < 7 ? 8 : 11;
    return model_.repLength.decode(range_, posState);
  }

  unsigned distance(unsigned length) {
    const unsigned group = std::min(length - 2, 3U);
    const unsigned slot = range_.tree(&model_.slot.p[group * 64U], 6);
    if (slot < 4) {
      return slot;
    }
    const unsigned directBits = (slot >> 1U) - 1U;
    const unsigned base = (2U | (slot & 1U)) << directBits;
    if (slot < 14) {
      return base + range_.reverseTree(&model_.special.p[base - slot], directBits);
    }
    const unsigned upper = range_.direct(directBits - 4) << 4U;
    return base + upper + range_.reverseTree(model_.align.p.data(), 4);
  }

  std::vector<std::uint8_t>& out_;
  RangeDecoder range_;
  Model model_;
  unsigned lc_ = 3;
  unsigned lp_ = 0;
  unsigned pb_ = 2;
};

}  // namespace

std::vector<std::uint8_t> unpackLzma2(std::span<const std::uint8_t> packed) {
  std::vector<std::uint8_t> out;
  Decoder decoder(out);
  std::size_t at = 0;
  const auto word = [&](std::size_t i) {
    return (static_cast<std::size_t>(packed[i]) << 8U) + packed[i + 1] + 1U;
  };
  while (at + 6 < packed.size() && packed[at] != 0) {
    const unsigned control = packed[at];
    if (control < 0x80) {  // stored
      const std::size_t count = std::min(word(at + 1), packed.size() - at - 3);
      out.insert(out.end(),
                 packed.begin() + static_cast<std::ptrdiff_t>(at + 3),
                 packed.begin() + static_cast<std::ptrdiff_t>(at + 3 + count));
      at += 3 + count;
      continue;
    }
    const std::size_t unpackedSize = ((control & 0x1fU) << 16U) + word(at + 1);
    const std::size_t packedSize = word(at + 3);
    std::size_t header = 5;
    if (control >= 0xa0) {
      decoder.resetState();
    }
    if (control >= 0xc0) {
      decoder.setProperties(packed[at + 5]);
      header = 6;
    }
    if (at + header + packedSize > packed.size()) {
      break;
    }
    decoder.run(packed.subspan(at + header, packedSize), unpackedSize);
    at += header + packedSize;
  }
  return out;
}

std::vector<std::uint8_t> unpackXz(std::span<const std::uint8_t> file) {
  constexpr std::size_t kStreamHeader = 12;
  if (file.size() < kStreamHeader + 8) {
    return {};
  }
  const std::size_t blockHeader = (file[kStreamHeader] + 1U) * 4U;
  if (file.size() < kStreamHeader + blockHeader) {
    return {};
  }
  return unpackLzma2(file.subspan(kStreamHeader + blockHeader));
}

}  // namespace liftarm::testing
