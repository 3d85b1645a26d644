#include "sketch/shaft_json.h"

#include <array>
#include <cmath>
#include <utility>

#include "sketch/json_text.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

using nlohmann::json;

constexpr std::array<std::pair<ShaftEnd, const char*>, 2> kEndWords{
    {{ShaftEnd::kCrank, "crank"}, {ShaftEnd::kWheel, "wheel"}}};

std::string endText(const char* key, ShaftEnd end) {
  for (const auto& [what, word] : kEndWords) {
    if (what == end) {
      return ", \"" + std::string(key) + "\": \"" + word + "\"";
    }
  }
  return "";
}

class ShaftReader {
 public:
  ShaftReader(const json& document, FieldReader& fields) : document_(document), fields_(fields) {}

  bool read(Shafts& all) {
    const bool shafts =
        each("shafts", kMaxShafts, [&](const json& value, const std::string& place) {
          return readShaft(value, place, all.shafts.emplace_back());
        });
    return shafts && each("drives", kMaxDrives, [&](const json& value, const std::string& place) {
             return readDrive(value, place, all);
           });
  }

 private:
  template <typename Read>
  bool each(const char* key, std::size_t most, Read read) {
    const auto list = document_.find(key);
    if (list == document_.end()) {
      return true;
    }
    if (!fields_.array(*list, key, "objects")) {
      return false;
    }
    if (list->size() > most) {
      return fields_.fail(key,
                          std::to_string(list->size()) + " elements; at most " +
                              std::to_string(most) + " are read");
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
      if (!read((*list)[i], elementPlace(key, i))) {
        return false;
      }
    }
    return true;
  }

  bool readShaft(const json& value, const std::string& place, Shaft& shaft) {
    if (!fields_.object(value, place, {"from", "to", "atFrom", "atTo"}) ||
        !readEnd(value, place, "from", shaft.from) || !readEnd(value, place, "to", shaft.to) ||
        !readWord(value, place, "atFrom", shaft.atFrom) ||
        !readWord(value, place, "atTo", shaft.atTo)) {
      return false;
    }
    int along = 0;
    for (int k = 0; k < 3; ++k) {
      along += shaft.from[k] != shaft.to[k] ? 1 : 0;
    }
    if (along != 1) {
      return fields_.fail(place,
                          along == 0 ? "the ends are the same point; a shaft is at least 1 module "
                                       "long"
                                     : "a shaft is parallel to x, y or z");
    }
    return shaft.slots() <= kMaxShaftSlots ||
           fields_.fail(place,
                        std::to_string(shaft.slots() - 1) +
                            " modules long; the longest axle reaches over " +
                            std::to_string(kMaxShaftSlots - 1));
  }

  bool readEnd(const json& value, const std::string& place, const char* key, lattice::Cell& end) {
    const json* const point = fields_.required(value, key, place, "three numbers [x, y, z]");
    lattice::Vec3 read;
    if (point == nullptr ||
        !fields_.vector(*point, memberPlace(place, key), kMaxCoordinate, read)) {
      return false;
    }
    for (int k = 0; k < 3; ++k) {
      end[k] = static_cast<int>(std::lround(read[k]));
      if (static_cast<double>(end[k]) != read[k]) {
        return fields_.fail(
            memberPlace(place, key),
            shortNumber(read[k]) + " is not on the lattice; shafts lie on whole modules");
      }
    }
    return true;
  }

  //! What sits at an end; nothing where the key is left out.
  bool readWord(const json& value, const std::string& place, const char* key, ShaftEnd& end) {
    const auto found = value.find(key);
    if (found == value.end()) {
      return true;
    }
    for (const auto& [what, word] : kEndWords) {
      if (*found == word) {
        end = what;
        return true;
      }
    }
    return fields_.fail(memberPlace(place, key), "expected \"crank\" or \"wheel\"");
  }

  bool readDrive(const json& value, const std::string& place, Shafts& all) {
    Drive drive;
    if (!fields_.object(value, place, {"from", "to", "ratio", "tolerance"}) ||
        !readIndex(value, place, "from", all, drive.from) ||
        !readIndex(value, place, "to", all, drive.to) || !readNumbers(value, place, drive)) {
      return false;
    }
    if (drive.from == drive.to) {
      return fields_.fail(place, "couples a shaft with itself");
    }
    all.drives.push_back(drive);
    return true;
  }

  bool readIndex(
      const json& value, const std::string& place, const char* key, const Shafts& all, int& out) {
    const json* const index = fields_.required(value, key, place, "the number of a shaft");
    const int count = static_cast<int>(all.shafts.size());
    if (index == nullptr) {
      return false;
    }
    if (!index->is_number() || index->get<double>() < 0.0 || index->get<double>() >= count ||
        std::floor(index->get<double>()) != index->get<double>()) {
      return fields_.fail(
          memberPlace(place, key),
          "expected the number of a shaft; there are " + std::to_string(count) + ", from 0");
    }
    out = static_cast<int>(index->get<double>());
    return true;
  }

  bool readNumbers(const json& value, const std::string& place, Drive& drive) {
    const json* const ratio =
        fields_.required(value, "ratio", place, "turns of the first shaft for one of the second");
    if (ratio == nullptr ||
        !fields_.number(*ratio, memberPlace(place, "ratio"), kMaxRatio, drive.ratio)) {
      return false;
    }
    if (drive.ratio < 1.0 / kMaxRatio) {
      return fields_.fail(memberPlace(place, "ratio"),
                          shortNumber(drive.ratio) + "; expected 0.001 to 1000");
    }
    const auto tolerance = value.find("tolerance");
    if (tolerance == value.end()) {
      return true;
    }
    const std::string where = memberPlace(place, "tolerance");
    return fields_.number(*tolerance, where, kMaxRatioTolerance, drive.tolerance) &&
           (drive.tolerance >= 0.0 ||
            fields_.fail(where, shortNumber(drive.tolerance) + "; expected 0 to 50 per cent"));
  }

  const json& document_;
  FieldReader& fields_;
};

std::string cellText(lattice::Cell cell) {
  return "[" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " +
         std::to_string(cell.z) + "]";
}

template <typename T, typename ToText>
std::string listText(const char* key, const std::vector<T>& list, ToText toText) {
  std::string text;
  for (const T& element : list) {
    text += (text.empty() ? "\n    " : ",\n    ") + toText(element);
  }
  return list.empty() ? "" : ",\n  \"" + std::string(key) + "\": [" + text + "\n  ]";
}

std::string driveText(const Drive& drive) {
  std::string text = R"({"from": )" + std::to_string(drive.from) + R"(, "to": )" +
                     std::to_string(drive.to) + R"(, "ratio": )" + json(drive.ratio).dump();
  if (drive.tolerance != Drive{}.tolerance) {
    text += R"(, "tolerance": )" + json(drive.tolerance).dump();
  }
  return text + "}";
}

}  // namespace

bool readShafts(const json& document, FieldReader& fields, Shafts& shafts) {
  return ShaftReader(document, fields).read(shafts);
}

Shafts shaftsOf(std::string_view text) {
  Shafts shafts;
  const json document = json::parse(text.begin(), text.end(), nullptr, false);
  FieldReader fields;
  if (!document.is_object() || !readShafts(document, fields, shafts)) {
    return {};
  }
  return shafts;
}

std::string shaftsText(const Shafts& shafts) {
  return listText("shafts",
                  shafts.shafts,
                  [](const Shaft& shaft) {
                    return R"({"from": )" + cellText(shaft.from) + R"(, "to": )" +
                           cellText(shaft.to) + endText("atFrom", shaft.atFrom) +
                           endText("atTo", shaft.atTo) + "}";
                  }) +
         listText("drives", shafts.drives, driveText);
}

}  // namespace liftarm::sketch
