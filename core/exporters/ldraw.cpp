#include "exporters/ldraw.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "model/number_text.h"

namespace liftarm::exporters {

namespace {

using lattice::Mat3;
using lattice::Vec3;
using model::numberText;

constexpr double kLduPerModule = 20.0;

//! Z up to -Y up.
const Mat3 kToLdraw{{1, 0, 0, 0, 0, -1, 0, 1, 0}};

//! A text that is safe on one line of the file and as the name of a part of it.
std::string oneLine(const std::string& text, const std::string& otherwise) {
  std::string result;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) {
      result += c;
    }
  }
  const std::size_t first = result.find_first_not_of(' ');
  return first == std::string::npos ? otherwise : result.substr(first);
}

std::string partLine(const model::PlacedPart& part) {
  const Vec3 at = kToLdraw * part.pose.position;
  const Mat3 turned = kToLdraw * part.pose.rotation * lattice::transposed(kToLdraw);
  std::string line = "1 " + std::to_string(part.color);
  for (int i = 0; i < 3; ++i) {
    line += " " + numberText(kLduPerModule * at[i]);
  }
  for (const double value : turned.m) {
    line += " " + numberText(value);
  }
  return line + " " + part.part + ".dat\n";
}

//! Height of the part's underside, modules, rounded to half modules so that one floor makes one
//! step.
double heightOf(const model::PlacedPart& placed, const parts::Catalogue& catalogue) {
  const parts::Part* part = catalogue.find(placed.part);
  if (part == nullptr) {
    return placed.pose.position.z;
  }
  const Vec3 middle = placed.pose.apply(0.5 * (part->boundsMin + part->boundsMax));
  const Vec3 half = 0.5 * (part->boundsMax - part->boundsMin);
  double reach = 0.0;
  for (int i = 0; i < 3; ++i) {
    reach += std::abs(placed.pose.rotation.m[6 + static_cast<std::size_t>(i)]) * half[i];
  }
  return std::floor(2.0 * (middle.z - reach) + 0.5) / 2.0;
}

}  // namespace

std::string writeLdraw(const model::Model& model, const parts::Catalogue& catalogue) {
  const std::string name = oneLine(model.name, "Model");
  std::string text =
      "0 FILE " + name + ".ldr\n0 " + name + "\n0 Name: " + name + ".ldr\n0 BFC CERTIFY CCW\n";
  std::vector<double> heights;
  for (const model::PlacedPart& part : model.parts) {
    heights.push_back(heightOf(part, catalogue));
  }
  std::vector<std::size_t> order(model.parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return heights[a] < heights[b];
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && heights[order[i]] > heights[order[i - 1]]) {
      text += "0 STEP\n";
    }
    text += partLine(model.parts[order[i]]);
  }
  return text + "0 STEP\n0 NOFILE\n";
}

}  // namespace liftarm::exporters
