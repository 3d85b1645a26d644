#include "sketch/json_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "base/plain_text.h"

namespace liftarm::sketch {

namespace {

using nlohmann::json;

struct LineColumn {
  std::size_t line = 1;
  std::size_t column = 1;
};

//! The place of the byte at `offset` (from 0), both counted from 1 as editors do.
LineColumn placeOf(std::string_view text, std::size_t offset) {
  LineColumn place;
  const std::size_t end = std::min(offset, text.size());
  for (std::size_t i = 0; i < end; ++i) {
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    } else {
      ++place.column;
    }
  }
  return place;
}

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.' ||
         c == '_';
}

//! The word around a byte, so that a message shows `NaN` and not only its first letter.
//! Bytes outside ASCII, which may be no valid text, show as `?`.
std::string wordAt(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) {
    return {};
  }
  if (static_cast<unsigned char>(text[offset]) >= 0x80U) {
    return "?";
  }
  std::size_t begin = offset;
  while (begin > 0 && isWordCharacter(text[begin]) && isWordCharacter(text[begin - 1])) {
    --begin;
  }
  std::size_t end = offset + 1;
  while (isWordCharacter(text[offset]) && end < text.size() && isWordCharacter(text[end])) {
    ++end;
  }
  return std::string(text.substr(begin, end - begin));
}

bool namesNoNumber(std::string_view word) {
  while (!word.empty() && (word.front() == '-' || word.front() == '+')) {
    word.remove_prefix(1);
  }
  return word == "NaN" || word == "nan" || word == "Infinity" || word == "inf" || word == "Inf";
}

//! The library's sentence without its number and position: "unexpected ']'; expected ...".
std::string explanation(std::string_view what) {
  const std::size_t dash = what.find(" - ");
  const std::size_t semicolon = what.find("; last read");
  if (dash == std::string_view::npos) {
    return "unexpected text";
  }
  std::string_view core = what.substr(dash + 3);
  if (semicolon != std::string_view::npos && semicolon > dash) {
    core = what.substr(dash + 3, semicolon - dash - 3);
  }
  std::string plain;
  for (const char c : core) {
    plain += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : ' ';
  }
  constexpr std::string_view kAnyValue = "'[', '{', or a literal";
  const std::size_t anyValue = plain.find(kAnyValue);
  if (anyValue != std::string::npos) {
    plain.replace(anyValue, kAnyValue.size(), "a value");
  }
  return plain;
}

//! Builds the document value by value and knows at each moment where it is.
class DocumentBuilder {
 public:
  using number_integer_t = json::number_integer_t;
  using number_unsigned_t = json::number_unsigned_t;
  using number_float_t = json::number_float_t;
  using string_t = json::string_t;
  using binary_t = json::binary_t;

  DocumentBuilder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

  // NOLINTBEGIN(readability-identifier-naming): the library's names.
  bool null() { return put(nullptr) != nullptr; }

  bool boolean(bool value) { return put(value) != nullptr; }

  bool number_integer(number_integer_t value) { return put(value) != nullptr; }

  bool number_unsigned(number_unsigned_t value) { return put(value) != nullptr; }

  bool number_float(number_float_t value, const string_t& spelled) {
    if (!std::isfinite(value)) {
      return fail(here() + "the number " + inQuotes(spelled) + " is not finite");
    }
    return put(value) != nullptr;
  }

  bool string(string_t& value) { return put(std::move(value)) != nullptr; }

  bool binary(binary_t& /*value*/) { return fail("binary values are not JSON"); }

  bool start_object(std::size_t /*size*/) { return open(json::object()); }

  bool start_array(std::size_t /*size*/) { return open(json::array()); }

  bool end_object() { return close(); }

  bool end_array() { return close(); }

  bool key(string_t& name) {
    if (stack_.back()->contains(name)) {
      keys_.back().clear();
      return fail(here() + "the key " + inQuotes(name) + " stands twice in this object");
    }
    keys_.back() = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const json::exception& error) {
    if (error.id == kNumberOverflow) {
      return fail(here() + "the number " + inQuotes(token) +
                  " is not finite: it is too large for a computer's numbers");
    }
    const std::size_t offset = position == 0 ? 0 : position - 1;
    const LineColumn place = placeOf(text_, offset);
    const std::string where = "line " + std::to_string(place.line) + ", column " +
                              std::to_string(place.column) + ": not valid JSON: ";
    if (offset >= text_.size()) {
      return fail(where + "the text ends too early");
    }
    const std::string word = wordAt(text_, offset);
    if (namesNoNumber(word)) {
      return fail(where + word + " is not a JSON number; coordinates must be finite numbers");
    }
    return fail(where + explanation(error.what()) + ", near " + inQuotes(word));
  }

  // NOLINTEND(readability-identifier-naming)

  json takeDocument() { return std::move(document_); }

  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  static constexpr int kNumberOverflow = 406;

  bool fail(std::string message) {
    message_ = std::move(message);
    return false;
  }

  //! The path of the value that comes next, such as `lines[3].from[1]: `.
  [[nodiscard]] std::string here() const {
    std::string path;
    for (std::size_t i = 0; i < stack_.size(); ++i) {
      if (stack_[i]->is_array()) {
        path += "[" + std::to_string(stack_[i]->size() - (i + 1 < stack_.size() ? 1 : 0)) + "]";
      } else if (!keys_[i].empty()) {
        const std::string name = inQuotes(keys_[i]);
        path += (path.empty() ? "" : ".") + name.substr(1, name.size() - 2);
      }
    }
    return path.empty() ? path : path + ": ";
  }

  template <typename T>
  json* put(T&& value) {
    if (++values_ > limits_.maxValues) {
      fail("the file holds more than " + std::to_string(limits_.maxValues) + " values");
      return nullptr;
    }
    if (stack_.empty()) {
      document_ = std::forward<T>(value);
      return &document_;
    }
    json& parent = *stack_.back();
    if (parent.is_object()) {
      return &(parent[keys_.back()] = std::forward<T>(value));
    }
    if (stack_.size() == 2 && parent.size() >= limits_.maxCounted &&
        keys_.front() == limits_.countedKey) {
      fail(std::string(limits_.countedKey) + ": more than " + std::to_string(limits_.maxCounted) +
           " elements; at most " + std::to_string(limits_.maxCounted) + " are read");
      return nullptr;
    }
    parent.push_back(std::forward<T>(value));
    return &parent.back();
  }

  bool open(json container) {
    if (stack_.size() >= limits_.maxDepth) {
      return fail(here() + "arrays and objects lie more than " + std::to_string(limits_.maxDepth) +
                  " deep inside each other");
    }
    json* const place = put(std::move(container));
    if (place == nullptr) {
      return false;
    }
    stack_.push_back(place);
    keys_.emplace_back();
    return true;
  }

  bool close() {
    stack_.pop_back();
    keys_.pop_back();
    return true;
  }

  std::string_view text_;
  const JsonLimits& limits_;
  json document_;
  std::vector<json*> stack_;  //!< open containers; a parent does not grow while a child is open
  std::vector<std::string> keys_;  //!< for each open object the key read last
  std::size_t values_ = 0;
  std::string message_;
};

}  // namespace

base::Result<nlohmann::json> parseJsonText(std::string_view text, const JsonLimits& limits) {
  DocumentBuilder builder(text, limits);
  if (!json::sax_parse(text.begin(), text.end(), &builder)) {
    return base::Error{base::Status::kInvalidInput, builder.message()};
  }
  return builder.takeDocument();
}

std::string shortNumber(double value) {
  const double scaled = value * 1e4;
  // Beyond 2^53 there are no digits after the point to cut.
  const double rounded = std::abs(scaled) < 9e15 ? std::round(scaled) / 1e4 : value;
  std::string text = json(rounded).dump();
  if (text.size() > 2 && text.compare(text.size() - 2, 2, ".0") == 0) {
    text.resize(text.size() - 2);
  }
  return text == "-0" ? "0" : text;
}

std::string pointText(const lattice::Vec3& point) {
  return "[" + shortNumber(point.x) + ", " + shortNumber(point.y) + ", " + shortNumber(point.z) +
         "]";
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kMaxBytes = 40;
  std::size_t end = std::min(text.size(), kMaxBytes);
  // Do not cut a UTF-8 character: its further bytes begin with the bits 10.
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  return "\"" + base::plainText(text.substr(0, end)) + (end < text.size() ? "...\"" : "\"");
}

}  // namespace liftarm::sketch
