#pragma once

#include "sketch/json_fields.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief Checks one line's ends and sets its whole length; message with the nearest ones
//! otherwise. \return False when `fields` has noted what is wrong. The same holds for the other
//! checks.
bool checkLine(Line& line, std::string_view place, FieldReader& fields);

//! \brief The fixed hole axis must be perpendicular to its line.
bool checkHoleAxis(const Line& line, std::string_view place, FieldReader& fields);

//! \brief For each joint a node that carries it, as a line and the distance from its start.
struct JointNodes {
  std::vector<int> line;
  std::vector<int> index;
};

//! \brief Joints lie at nodes of the lines that they name. \pre lines as drawn, not yet snapped.
bool checkJoints(const Sketch& sketch, FieldReader& fields, JointNodes& nodes);

//! \brief No unit edge may be told two hole axes by two lines. \pre lines are snapped.
bool checkHoleAxesAgree(const Sketch& sketch, FieldReader& fields);

}  // namespace liftarm::sketch
