#include "exporters/spreadsheet.h"

#include <string_view>

#include "exporters/parts_list.h"
#include "exporters/wanted_list.h"
#include "model/number_text.h"

namespace liftarm::exporters {

namespace {

constexpr int kMassDecimals = 2;

//! A quoted cell; one that starts like a formula gets an apostrophe in front.
std::string cell(std::string_view text) {
  constexpr std::string_view kFormulaStarts = "=+-@\t\r";
  std::string quoted = "\"";
  if (!text.empty() && kFormulaStarts.find(text.front()) != std::string_view::npos) {
    quoted += '\'';
  }
  for (const char c : text) {
    if (c == '"') {
      quoted += '"';
    }
    quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted + "\"";
}

std::string colourName(int code) {
  const ColourIds* ids = findColourIds(code);
  return ids != nullptr ? std::string(ids->name) : "Colour " + std::to_string(code);
}

}  // namespace

std::string writeSpreadsheet(const model::Model& model, const parts::Catalogue& catalogue) {
  std::string text = "Name,Number,Colour,Count,Mass each (g),Mass (g),Mass is an estimate\n";
  int bricks = 0;
  double sum = 0.0;
  bool estimated = false;
  for (const PartCount& entry : countParts(model)) {
    const parts::Part* part = catalogue.find(entry.part);
    const double mass = part != nullptr ? part->mass : 0.0;
    const bool guess = part == nullptr || part->massEstimated;
    text += cell(part != nullptr ? part->name : "Unknown part") + "," + cell(entry.part) + "," +
            cell(colourName(entry.color)) + "," + std::to_string(entry.count) + "," +
            model::numberText(mass, kMassDecimals) + "," +
            model::numberText(mass * entry.count, kMassDecimals) + "," + (guess ? "yes" : "no") +
            "\n";
    bricks += entry.count;
    sum += mass * entry.count;
    estimated = estimated || guess;
  }
  return text + "Sum,,," + std::to_string(bricks) + ",," + model::numberText(sum, kMassDecimals) +
         "," + (estimated ? "yes" : "no") + "\n";
}

}  // namespace liftarm::exporters
