#include "sketch/keep_json.h"

#include <algorithm>
#include <cmath>

#include "sketch/json_text.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

using nlohmann::json;

bool isPartLetter(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '-' || c == '.';
}

class KeepReader {
 public:
  KeepReader(FieldReader& fields, const Sketch& sketch) : fields_(fields), sketch_(sketch) {}

  bool readAll(const json& value, std::vector<Keep>& all) {
    if (!list(value, "keep", "objects", kMaxKeeps)) {
      return false;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string place = elementPlace("keep", i);
      Keep keep;
      if (!readOne(value[i], place, keep)) {
        return false;
      }
      const bool twice = std::any_of(
          all.begin(), all.end(), [&](const Keep& other) { return other.line == keep.line; });
      if (twice) {
        return fields_.fail(memberPlace(place, "line"),
                            "line " + std::to_string(keep.line) + " has an element already");
      }
      all.push_back(std::move(keep));
    }
    return true;
  }

 private:
  bool readOne(const json& value, const std::string& place, Keep& keep) {
    if (!fields_.object(value, place, {"line", "parts", "barred", "layers", "splits"})) {
      return false;
    }
    const json* const line = fields_.required(value, "line", place, "the number of a line");
    if (line == nullptr ||
        !fields_.lineIndex(*line, memberPlace(place, "line"), lineCount(), keep.line)) {
      return false;
    }
    if (value.size() < 2) {
      return fields_.fail(place, "says nothing; expected parts, barred, layers or splits");
    }
    return readParts(value, place, keep) && readBarred(value, place, keep) &&
           readLayers(value, place, keep) && readSplits(value, place, keep);
  }

  bool readParts(const json& value, const std::string& place, Keep& keep) {
    return each(value, place, "parts", "objects", [&](const json& item, const std::string& where) {
      KeptPart part;
      part.on.line = keep.line;
      if (!fields_.object(item, where, {"part", "from", "to", "layer", "holeAxis", "with"}) ||
          !readNumber(item, where, part.part) || !readStretch(item, where, part.on) ||
          !readPlace(item, where, part) || !readWith(item, where, part)) {
        return false;
      }
      keep.parts.push_back(std::move(part));
      return true;
    });
  }

  bool readPlace(const json& item, const std::string& where, KeptPart& part) {
    const json* const layer =
        fields_.required(item, "layer", where, "how many modules off its line the part lies");
    if (layer == nullptr ||
        !whole(*layer, memberPlace(where, "layer"), -kMaxKeptLayer, kMaxKeptLayer, part.layer)) {
      return false;
    }
    const json* const axis = fields_.required(item, "holeAxis", where, "\"x\", \"y\" or \"z\"");
    return axis != nullptr && fields_.axis(*axis, memberPlace(where, "holeAxis"), part.holeAxis);
  }

  bool readWith(const json& item, const std::string& where, KeptPart& part) {
    return each(item, where, "with", "objects", [&](const json& bar, const std::string& barPlace) {
      Stretch stretch;
      if (!fields_.object(bar, barPlace, {"line", "from", "to"})) {
        return false;
      }
      const json* const line = fields_.required(bar, "line", barPlace, "the number of a line");
      if (line == nullptr ||
          !fields_.lineIndex(*line, memberPlace(barPlace, "line"), lineCount(), stretch.line) ||
          !readStretch(bar, barPlace, stretch)) {
        return false;
      }
      part.with.push_back(stretch);
      return true;
    });
  }

  bool readBarred(const json& value, const std::string& place, Keep& keep) {
    return each(value, place, "barred", "objects", [&](const json& item, const std::string& where) {
      BarredPart part;
      part.on.line = keep.line;
      if (!fields_.object(item, where, {"part", "from", "to"}) ||
          !readNumber(item, where, part.part) || !readStretch(item, where, part.on)) {
        return false;
      }
      keep.barred.push_back(std::move(part));
      return true;
    });
  }

  bool readLayers(const json& value, const std::string& place, Keep& keep) {
    const bool read =
        each(value, place, "layers", "layers", [&](const json& item, const std::string& where) {
          int layer = 0;
          if (!whole(item, where, -kMaxKeptLayer, kMaxKeptLayer, layer)) {
            return false;
          }
          const bool known =
              std::find(keep.layers.begin(), keep.layers.end(), layer) != keep.layers.end();
          keep.layers.push_back(layer);
          return !known ||
                 fields_.fail(where, "layer " + std::to_string(layer) + " is named twice");
        });
    std::sort(keep.layers.begin(), keep.layers.end());
    return read;
  }

  bool readSplits(const json& value, const std::string& place, Keep& keep) {
    const int length = sketch_.lines[static_cast<std::size_t>(keep.line)].length;
    return each(value, place, "splits", "nodes", [&](const json& item, const std::string& where) {
      int node = 0;
      if (!whole(item, where, 0, length, node)) {
        return false;
      }
      keep.splits.push_back(node);
      return true;
    });
  }

  bool readNumber(const json& item, const std::string& where, std::string& part) {
    const json* const number = fields_.required(item, "part", where, "an LDraw part number");
    return number != nullptr && readPartNumber(*number, fields_, memberPlace(where, "part"), part);
  }

  bool readStretch(const json& item, const std::string& where, Stretch& stretch) {
    const json* const from = fields_.required(item, "from", where, "a node of the line");
    const json* const to = fields_.required(item, "to", where, "a node of the line");
    const int length = sketch_.lines[static_cast<std::size_t>(stretch.line)].length;
    if (from == nullptr || to == nullptr ||
        !whole(*from, memberPlace(where, "from"), -kMaxKeptReach, length, stretch.from) ||
        !whole(*to, memberPlace(where, "to"), 0, length + kMaxKeptReach, stretch.to)) {
      return false;
    }
    return stretch.from <= stretch.to ||
           fields_.fail(memberPlace(where, "from"),
                        std::to_string(stretch.from) + " is above to, which is " +
                            std::to_string(stretch.to));
  }

  bool whole(const json& value, const std::string& place, int least, int most, int& out) {
    double number = 0.0;
    if (!fields_.number(value, place, 1e9, number)) {
      return false;
    }
    if (number != std::floor(number) || number < least || number > most) {
      return fields_.fail(place,
                          shortNumber(number) + " is not a whole number from " +
                              std::to_string(least) + " to " + std::to_string(most));
    }
    out = static_cast<int>(number);
    return true;
  }

  bool list(const json& value, const std::string& place, const char* holds, std::size_t most) {
    if (!fields_.array(value, place, holds)) {
      return false;
    }
    if (value.empty()) {
      return fields_.fail(place, "empty; leave it out");
    }
    return value.size() <= most ||
           fields_.fail(place,
                        std::to_string(value.size()) + " elements; at most " +
                            std::to_string(most) + " are read");
  }

  //! Every element of the list `key`, if it is there.
  template <typename Read>
  bool each(
      const json& value, const std::string& place, const char* key, const char* holds, Read read) {
    const auto found = value.find(key);
    if (found == value.end()) {
      return true;
    }
    const std::string where = memberPlace(place, key);
    if (!list(*found, where, holds, kMaxKeptParts)) {
      return false;
    }
    for (std::size_t i = 0; i < found->size(); ++i) {
      if (!read((*found)[i], elementPlace(where, i))) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] int lineCount() const { return static_cast<int>(sketch_.lines.size()); }

  FieldReader& fields_;
  const Sketch& sketch_;
};

std::string stretchText(const Stretch& on) {
  return R"("from": )" + std::to_string(on.from) + R"(, "to": )" + std::to_string(on.to);
}

std::string numbersText(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) {
    text += (text.empty() ? "" : ", ") + std::to_string(number);
  }
  return "[" + text + "]";
}

template <typename T, typename ToText>
std::string memberText(const char* key, const std::vector<T>& list, ToText toText) {
  std::string text;
  for (const T& element : list) {
    text += (text.empty() ? "" : ", ") + toText(element);
  }
  return list.empty() ? "" : ", \"" + std::string(key) + "\": [" + text + "]";
}

}  // namespace

bool readKeeps(const json& document, FieldReader& fields, const Sketch& sketch, Keeps& keeps) {
  const auto member = document.find("keep");
  return member == document.end() || KeepReader(fields, sketch).readAll(*member, keeps);
}

Keeps keepsOf(std::string_view text, const Sketch& sketch) {
  Keeps keeps;
  const json document = json::parse(text.begin(), text.end(), nullptr, false);
  FieldReader fields;
  if (!document.is_object() || !readKeeps(document, fields, sketch, keeps)) {
    return {};
  }
  return keeps;
}

bool readPartNumber(const json& value,
                    FieldReader& fields,
                    const std::string& place,
                    std::string& part) {
  if (!fields.text(value, place, part)) {
    return false;
  }
  const bool sound = !part.empty() && part.size() <= kMaxPartNumber &&
                     std::all_of(part.begin(), part.end(), isPartLetter);
  return sound || fields.fail(place, "expected an LDraw part number, such as \"32524\"");
}

std::string keptPartText(const KeptPart& part) {
  return R"({"part": ")" + part.part + R"(", )" + stretchText(part.on) + R"(, "layer": )" +
         std::to_string(part.layer) + R"(, "holeAxis": ")" + std::string(axisName(part.holeAxis)) +
         "\"" +
         memberText("with",
                    part.with,
                    [](const Stretch& bar) {
                      return R"({"line": )" + std::to_string(bar.line) + ", " + stretchText(bar) +
                             "}";
                    }) +
         "}";
}

namespace {

std::string keepText(const Keep& keep) {
  std::string text = R"({"line": )" + std::to_string(keep.line);
  text += memberText("parts", keep.parts, keptPartText);
  text += memberText("barred", keep.barred, [](const BarredPart& part) {
    return R"({"part": ")" + part.part + R"(", )" + stretchText(part.on) + "}";
  });
  text += keep.layers.empty() ? "" : R"(, "layers": )" + numbersText(keep.layers);
  text += keep.splits.empty() ? "" : R"(, "splits": )" + numbersText(keep.splits);
  return text + "}";
}

}  // namespace

std::string keepsText(const Keeps& keeps) {
  std::string text;
  for (const Keep& keep : keeps) {
    text += (text.empty() ? "\n    " : ",\n    ") + keepText(keep);
  }
  return keeps.empty() ? "" : ",\n  \"keep\": [" + text + "\n  ]";
}

}  // namespace liftarm::sketch
