#pragma once

#include <array>
#include <vector>

#include "sketch/sketch.h"
#include "sketch/snap_solver.h"

namespace liftarm::sketch {

//! \brief What makes two points of a drawing belong together, strongest first.
enum class Contact {
  kStraight,  //!< two lines that go on straight through a shared end point
  kEndPoint,  //!< an end point at a node inside another line
  kCrossing,  //!< nodes inside two lines
};

struct ContactRow {
  Contact kind = Contact::kStraight;
  LinearRow row;
};

//! \brief The coordinates of a drawing with each shared one named once.
struct SketchVariables {
  std::vector<double> values;                           //!< modules
  std::vector<std::array<std::array<int, 3>, 2>> ends;  //!< line -> from, to -> x, y, z
  std::vector<LengthRow> lengths;                       //!< one for each distinct line
  std::vector<ContactRow> contacts;
};

//! \brief Finds shared end points, shared coordinates and contacts within `tolerance` modules.
SketchVariables findVariables(const std::vector<Line>& lines, double tolerance);

}  // namespace liftarm::sketch
