#include <algorithm>
#include <array>

#include "exporters/wanted_list.h"

namespace liftarm::exporters {

namespace {

//! Ascending by LDraw code. All colours that the page offers (web/src/model/colours.ts).
constexpr std::array<ColourIds, 35> kColours{{
    {0, 11, 0, "Black"},
    {1, 7, 1, "Blue"},
    {2, 6, 2, "Green"},
    {4, 5, 4, "Red"},
    {5, 47, 5, "Dark Pink"},
    {7, 9, 7, "Light Gray"},
    {8, 10, 8, "Dark Gray"},
    {10, 36, 10, "Bright Green"},
    {14, 3, 14, "Yellow"},
    {15, 1, 15, "White"},
    {19, 2, 19, "Tan"},
    {22, 24, 22, "Purple"},
    {25, 4, 25, "Orange"},
    {26, 71, 26, "Magenta"},
    {27, 34, 27, "Lime"},
    {28, 69, 28, "Dark Tan"},
    {70, 88, 70, "Reddish Brown"},
    {71, 86, 71, "Light Bluish Gray"},
    {72, 85, 72, "Dark Bluish Gray"},
    {73, 42, 73, "Medium Blue"},
    {84, 150, 84, "Medium Nougat"},
    {85, 89, 85, "Dark Purple"},
    {179, 95, 179, "Flat Silver"},
    {191, 110, 191, "Bright Light Orange"},
    {226, 103, 226, "Bright Light Yellow"},
    {272, 63, 272, "Dark Blue"},
    {288, 80, 288, "Dark Green"},
    {308, 120, 308, "Dark Brown"},
    {320, 59, 320, "Dark Red"},
    {321, 153, 321, "Dark Azure"},
    {322, 156, 322, "Medium Azure"},
    {330, 155, 326, "Olive Green"},
    {378, 48, 378, "Sand Green"},
    {379, 55, 379, "Sand Blue"},
    {484, 68, 484, "Dark Orange"},
}};

}  // namespace

const ColourIds* findColourIds(int ldrawColour) {
  const auto* found = std::lower_bound(
      kColours.begin(), kColours.end(), ldrawColour, [](const ColourIds& ids, int code) {
        return ids.ldraw < code;
      });
  return found != kColours.end() && found->ldraw == ldrawColour ? found : nullptr;
}

}  // namespace liftarm::exporters
