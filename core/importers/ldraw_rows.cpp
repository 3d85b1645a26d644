#include "importers/ldraw_rows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace liftarm::importers {

namespace {

constexpr std::size_t kMaxFiles = 20000;
constexpr std::size_t kNumbers = 12;
constexpr int kFallbackColor = 71;
constexpr std::string_view kSpace = " \t\v\f\r\n";

struct Color {
  int code = 0;
  unsigned rgb = 0;
};

//! Colours in which parts are sold; as in web/src/model/colours.ts.
constexpr std::array<Color, 35> kColors{
    {{0, 0x1d1f22},   {1, 0x1e5aa8},   {2, 0x00852b},   {4, 0xb40000},   {5, 0xd3359d},
     {7, 0x8a928d},   {8, 0x545955},   {10, 0x58ab41},  {14, 0xfac80a},  {15, 0xf4f4f4},
     {19, 0xd7ba8c},  {22, 0x671f81},  {25, 0xd67923},  {26, 0x901f76},  {27, 0xa5ca18},
     {28, 0x897d62},  {70, 0x5f3109},  {71, 0x969696},  {72, 0x646464},  {73, 0x7396c8},
     {84, 0xaa7d55},  {85, 0x441a91},  {179, 0x898788}, {191, 0xfcac00}, {226, 0xffec6c},
     {272, 0x19325a}, {288, 0x00451a}, {308, 0x352100}, {320, 0x720012}, {321, 0x469bc3},
     {322, 0x68c3e2}, {330, 0x77774e}, {378, 0x708e7c}, {379, 0x70819a}, {484, 0x91501c}}};

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool isHex(char c) {
  return std::isxdigit(static_cast<unsigned char>(c)) != 0;
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kSpace, end);
  }
  return fields;
}

std::string singleSpaced(std::string_view name) {
  std::string text;
  for (const std::string_view word : fieldsOf(name)) {
    text += text.empty() ? "" : " ";
    text += word;
  }
  return text;
}

//! Names are told apart without regard to case and to how much white space they hold.
std::string keyOf(std::string_view name) {
  std::string key = singleSpaced(name);
  std::transform(key.begin(), key.end(), key.begin(), lower);
  return key;
}

std::optional<double> numberOf(std::string_view field) {
  const std::string text(field);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole = !text.empty() && end == text.c_str() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

int nearestColor(unsigned rgb) {
  const auto away = [&](const Color& color) {
    int sum = 0;
    for (const unsigned at : {16U, 8U, 0U}) {
      const int off =
          static_cast<int>((rgb >> at) & 255U) - static_cast<int>((color.rgb >> at) & 255U);
      sum += off * off;
    }
    return sum;
  };
  return std::min_element(kColors.begin(),
                          kColors.end(),
                          [&](const Color& a, const Color& b) { return away(a) < away(b); })
      ->code;
}

//! Red, green and blue of a colour that is written as such: `0x2RRGGBB` or `#2RRGGBB`.
std::optional<unsigned> directColor(std::string_view field) {
  const std::size_t mark = field.substr(0, 1) == "#" ? 1 : 2;
  const bool marked = mark == 1 || (field.size() > 2 && field[0] == '0' && lower(field[1]) == 'x');
  const std::string digits(marked ? field.substr(mark) : std::string_view());
  if ((digits.size() != 6 && digits.size() != 7) ||
      !std::all_of(digits.begin(), digits.end(), isHex)) {
    return std::nullopt;
  }
  return static_cast<unsigned>(std::strtoul(digits.substr(digits.size() - 6).c_str(), nullptr, 16));
}

//! The code of a colour; the usual one for one that is not known. Nothing where it is none.
std::optional<int> colorOf(std::string_view field) {
  if (const std::optional<unsigned> rgb = directColor(field)) {
    return nearestColor(*rgb);
  }
  const std::optional<double> code = numberOf(field);
  if (!code) {
    return std::nullopt;
  }
  const bool known = std::any_of(
      kColors.begin(), kColors.end(), [&](const Color& color) { return color.code == *code; });
  const bool inherited = *code == 16.0 || *code == 24.0;
  return known || inherited ? static_cast<int>(*code) : kFallbackColor;
}

std::optional<LdrawRow> rowOf(std::string_view line) {
  const std::vector<std::string_view> fields = fieldsOf(line);
  if (fields.size() < kNumbers + 3) {
    return std::nullopt;
  }
  std::array<double, kNumbers> numbers{};
  for (std::size_t i = 0; i < kNumbers; ++i) {
    const std::optional<double> number = numberOf(fields[i + 2]);
    if (!number) {
      return std::nullopt;
    }
    numbers[i] = *number;
  }
  const std::optional<int> color = colorOf(fields[1]);
  if (!color) {
    return std::nullopt;
  }
  LdrawRow row;
  row.color = *color;
  row.position = {numbers[0], numbers[1], numbers[2]};
  std::copy(numbers.begin() + 3, numbers.end(), row.rotation.m.begin());
  const std::string_view from = fields[kNumbers + 2];
  row.file = keyOf(line.substr(static_cast<std::size_t>(from.data() - line.data())));
  return row;
}

//! The rest of a line `0 WORD ...`; nothing for any other line.
std::optional<std::string_view> meta(std::string_view line, std::string_view word) {
  const std::vector<std::string_view> fields = fieldsOf(line);
  if (fields.size() < 2 || fields[0] != "0" || fields[1].size() != word.size() ||
      !std::equal(word.begin(), word.end(), fields[1].begin(), [](char a, char b) {
        return lower(a) == lower(b);
      })) {
    return std::nullopt;
  }
  return trimmed(
      line.substr(static_cast<std::size_t>(fields[1].data() - line.data()) + word.size()));
}

//! A row of type 2, 3 or 4.
bool drawsSomething(std::string_view line) {
  const std::string_view row = trimmed(line);
  return row.size() > 1 && row[0] >= '2' && row[0] <= '4' &&
         kSpace.find(row[1]) != std::string_view::npos;
}

//! Takes files in their order. Of two with one name the first counts, as everywhere in LDraw.
class FileTaker {
 public:
  void begin(std::string_view written) {
    std::string name = keyOf(written);
    if (files_.names.empty()) {
      files_.title = singleSpaced(written);
    }
    const bool known = files_.rows.count(name) > 0;
    if (known) {
      files_.notes.push_back(name + " stands there more than once; the first counts");
      rows_ = nullptr;
      return;
    }
    files_.names.push_back(name);
    open_ = name;
    rows_ = &files_.rows[std::move(name)];
  }

  void end() { rows_ = nullptr; }

  //! The file that is open draws something itself.
  void draw() {
    if (rows_ != nullptr) {
      files_.drawn.insert(open_);
    }
  }

  void add(LdrawRow row) {
    if (rows_ != nullptr) {
      rows_->push_back(std::move(row));
    }
  }

  [[nodiscard]] std::size_t count() const { return files_.names.size(); }

  LdrawFiles take() && { return std::move(files_); }

 private:
  LdrawFiles files_;
  std::vector<LdrawRow>* rows_ = nullptr;
  std::string open_;
};

}  // namespace

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  std::size_t from = 0;
  while (true) {
    const std::size_t end = text.find_first_of("\r\n", from);
    lines.push_back(text.substr(from, end - from));
    if (end == std::string_view::npos) {
      return lines;
    }
    from = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
}

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(kSpace);
  return from == std::string_view::npos
             ? std::string_view()
             : text.substr(from, text.find_last_not_of(kSpace) - from + 1);
}

base::Result<LdrawFiles> readRows(std::string_view text) {
  FileTaker taker;
  bool leading = true;
  bool outside = false;
  std::size_t number = 0;
  for (const std::string_view line : linesOf(text)) {
    ++number;
    const std::optional<std::string_view> named = meta(line, "FILE");
    if (named && !named->empty()) {
      leading = outside = false;
      taker.begin(*named);
      if (taker.count() > kMaxFiles) {
        return base::Error{
            base::Status::kInvalidInput,
            "more than " + std::to_string(kMaxFiles) + " submodels, which is the limit"};
      }
    } else if (meta(line, "NOFILE")) {
      outside = true;
      taker.end();
    } else if (const auto fields = fieldsOf(line.substr(0, 64));
               !outside && fields.size() > 0 && fields[0] == "1" && trimmed(line).size() > 1) {
      std::optional<LdrawRow> row = rowOf(line);
      if (!row) {
        return base::Error{base::Status::kInvalidInput,
                           "line " + std::to_string(number) +
                               ": a part needs a colour, twelve numbers and a file name"};
      }
      if (leading) {
        // Rows before the first FILE are a file of their own.
        leading = false;
        taker.begin("model.ldr");
      }
      taker.add(*std::move(row));
    } else if (drawsSomething(line)) {
      taker.draw();
    }
  }
  return std::move(taker).take();
}

bool looksLikeRow(std::string_view line) {
  const std::vector<std::string_view> fields = fieldsOf(line);
  const auto isPlain = [](std::string_view field) {
    return std::all_of(field.begin(), field.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '+' ||
             c == '#' || c == '.';
    });
  };
  return fields.size() >= kNumbers + 3 && fields[0] == "1" &&
         std::all_of(fields.begin() + 1, fields.begin() + kNumbers + 2, isPlain);
}

bool isInherited(int color) {
  return color == 16 || color == 24;
}

}  // namespace liftarm::importers
