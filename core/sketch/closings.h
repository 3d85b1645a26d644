#pragma once

#include <array>
#include <vector>

#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief Whole spans along two axes whose slanted line has a whole length, such as 9 by 12: 15.
struct Closing {
  std::array<int, 2> spans{};
  int length = 0;
};

//! \brief The spans nearest to those of a slanted line that close, at most two, nearest first.
//! \details Nearest by the modules that both spans change together. None for a line along an axis.
std::vector<Closing> nearestClosings(const Line& line);

//! \brief "; nearest that close: 9 by 12 (length 15) or 12 by 16 (length 20)", or nothing.
std::string closingsText(const Line& line);

}  // namespace liftarm::sketch
