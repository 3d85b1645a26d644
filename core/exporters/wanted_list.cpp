#include "exporters/wanted_list.h"

#include "exporters/parts_list.h"

namespace liftarm::exporters {

namespace {

//! Part numbers come from files: only what a number can hold reaches the document.
std::string itemId(const std::string& part) {
  std::string id;
  for (const char c : part) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    id += plain || c == '-' || c == '.' ? c : '_';
  }
  return id;
}

}  // namespace

base::Result<std::string> writeWantedList(const model::Model& model) {
  std::string text = "<INVENTORY>\n";
  for (const PartCount& entry : countParts(model)) {
    const ColourIds* colour = findColourIds(entry.color);
    if (colour == nullptr) {
      return base::Error{base::Status::kInvalidInput,
                         "colour " + std::to_string(entry.color) + " of part " +
                             itemId(entry.part) + ": BrickLink's number for it is not known"};
    }
    text += "<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>" + itemId(entry.part) + "</ITEMID><COLOR>" +
            std::to_string(colour->brickLink) + "</COLOR><MINQTY>" + std::to_string(entry.count) +
            "</MINQTY></ITEM>\n";
  }
  return text + "</INVENTORY>\n";
}

}  // namespace liftarm::exporters
