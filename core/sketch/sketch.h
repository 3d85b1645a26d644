#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::sketch {

//! \brief One straight line of whole length. After reading, |to - from| equals `length` up to
//! rounding.
struct Line {
  lattice::Vec3 from;
  lattice::Vec3 to;
  int length = 0;                         //!< modules, at least 1
  bool exact = false;                     //!< beams must lie on the line (layer 0)
  std::optional<lattice::Axis> holeAxis;  //!< fixed by the user
};

//! \brief A point with an axis about which two or more groups of lines must turn.
struct Joint {
  lattice::Vec3 at;
  lattice::Vec3 axis;  //!< unit length
  std::vector<std::vector<int>>
      between;  //!< groups of line indices, one a body; empty where just two lines meet
  //! Degrees from the drawn pose, the lower first, through which it must turn with nothing in the
  //! way; -180 to 180 is a full turn. None: as far as it goes.
  std::optional<std::array<double, 2>> range = std::nullopt;
};

//! \brief Lines mapped onto lines: by a mirror plane {p : normal.p = offset} or by a shift.
struct Symmetry {
  //! A rotation is no part of the format: only what a search wishes for has it.
  enum class Kind { kReflection, kTranslation, kRotation };

  Kind kind = Kind::kReflection;
  lattice::Vec3 normal;                    //!< reflection: unit length; rotation: its axis
  double offset = 0.0;                     //!< reflection: modules along the normal
  std::vector<int> lines;                  //!< reflection: empty means all
  lattice::Vec3 vector;                    //!< translation: modules; rotation: a point on the axis
  std::vector<std::pair<int, int>> pairs;  //!< translation: line, image
  int order = 2;                           //!< rotation: 2 or 4, by 360 / order degrees
};

//! \brief An axis-aligned box of cells (by their centres, inclusive) that no part may enter.
struct KeepOut {
  lattice::Vec3 min;
  lattice::Vec3 max;
};

//! \brief The input (DESIGN 3).
struct Sketch {
  std::string name;
  std::vector<Line> lines;
  std::vector<Joint> joints;
  std::vector<Symmetry> symmetries;
  std::vector<KeepOut> keepOut;
  std::optional<double> ground;

  //! What snapping could not mend: the largest | |to - from| - length | in modules. Not part of the
  //! file.
  double residual = 0.0;
};

}  // namespace liftarm::sketch
