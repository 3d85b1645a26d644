#include "exporters/parts_list.h"

#include <algorithm>
#include <map>
#include <utility>

#include "exporters/wanted_list.h"

namespace liftarm::exporters {

std::vector<PartCount> countParts(const model::Model& model) {
  std::map<std::pair<std::string, int>, int> counts;
  for (const model::PlacedPart& part : model.parts) {
    ++counts[{part.part, part.color}];
  }
  std::vector<PartCount> list;
  for (const auto& [key, count] : counts) {
    list.push_back({key.first, key.second, count});
  }
  std::stable_sort(list.begin(), list.end(), [](const PartCount& a, const PartCount& b) {
    return a.count > b.count;
  });
  return list;
}

std::string writePartsCsv(const model::Model& model) {
  std::string text = "Part,Color,Quantity\n";
  for (const PartCount& entry : countParts(model)) {
    // Part numbers come from files: keep what could break a row of the table out of it.
    std::string part;
    for (const char c : entry.part) {
      part += c == ',' || c == '"' || static_cast<unsigned char>(c) < 0x20 ? '_' : c;
    }
    const ColourIds* ids = findColourIds(entry.color);
    const int colour = ids != nullptr ? ids->rebrickable : entry.color;
    text += part + "," + std::to_string(colour) + "," + std::to_string(entry.count) + "\n";
  }
  return text;
}

}  // namespace liftarm::exporters
