#include "importers/part_numbers.h"

#include <array>
#include <cctype>
#include <utility>

namespace liftarm::importers {

namespace {

//! Other numbers of parts that do the same; as in web/src/model/part-synonyms.ts, where their
//! sources are named.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kSame{{
    {"64289", "40490"},
    {"64290", "32525"},
    {"64871", "32278"},
    {"4459", "2780"},
    {"61332", "2780"},
    {"42924", "6558"},
    {"6590", "3713"},
    {"32123", "32123b"},
    {"3648", "3648b"},
}};

constexpr std::array<std::string_view, 4> kPrints{"pr", "pb", "pat", "ps"};

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::size_t digitsFrom(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && isDigit(text[end])) {
    ++end;
  }
  return end;
}

//! Where the mark of a mould or of a print that begins at a place ends: `a`, `pr0001b`. Npos where
//! none begins.
std::size_t markEnd(std::string_view text, std::size_t at) {
  for (const std::string_view print : kPrints) {
    if (text.substr(at, print.size()) == print) {
      const std::size_t from = at + print.size();
      const std::size_t end = digitsFrom(text, from);
      if (end > from) {
        const bool letter = end < text.size() && text[end] >= 'a' && text[end] <= 'z';
        return letter ? end + 1 : end;
      }
    }
  }
  return text[at] >= 'a' && text[at] <= 'f' ? at + 1 : std::string_view::npos;
}

//! `32316pr0001` -> `32316`; the number itself where it has no such mark.
std::string_view baseNumber(std::string_view number) {
  const std::size_t digits = digitsFrom(number, 0);
  std::size_t at = digits;
  while (at < number.size() && at != std::string_view::npos) {
    at = markEnd(number, at);
  }
  return digits > 0 && digits < number.size() && at == number.size() ? number.substr(0, digits)
                                                                     : number;
}

const parts::Part* sameAs(std::string_view number, const parts::Catalogue& catalogue) {
  for (const auto& [other, ours] : kSame) {
    if (number == other) {
      return catalogue.find(ours);
    }
  }
  return nullptr;
}

}  // namespace

std::string plainNumber(std::string_view name) {
  const std::size_t folder = name.find_last_of("\\/");
  if (folder != std::string_view::npos) {
    name.remove_prefix(folder + 1);
  }
  for (const std::string_view ending : {".dat", ".ldr"}) {
    if (name.size() >= ending.size() && name.substr(name.size() - ending.size()) == ending) {
      name.remove_suffix(ending.size());
      break;
    }
  }
  return std::string(name);
}

const parts::Part* knownPart(std::string_view name, const parts::Catalogue& catalogue) {
  const std::string plain = plainNumber(name);
  const std::string_view base = baseNumber(plain);
  for (const std::string_view number : {std::string_view(plain), base}) {
    if (const parts::Part* part = catalogue.find(number)) {
      return part;
    }
    if (const parts::Part* part = sameAs(number, catalogue)) {
      return part;
    }
  }
  return nullptr;
}

}  // namespace liftarm::importers
