#pragma once

#include <vector>

#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief What snapping did, in modules.
struct SnapReport {
  double residual = 0.0;  //!< largest | |to - from| - length | that is left
  double moved = 0.0;     //!< largest change of a coordinate, at most
  int worstLine = -1;     //!< where the residual is; -1 when there is none
};

//! \brief Moves end points as little as possible so that every line has exactly its whole length.
//! \details Drawings round the corners of 60-degree and other structures off the lattice, and draw
//! some lines up to kLengthTolerance too long or too short. End points within that tolerance become
//! one point; coordinates that a line shares at both ends stay shared, so that lines keep their
//! principal plane or axis; whole coordinates stay where they are unless a line cannot have its
//! length otherwise; end points and crossings at nodes of other lines stay there (dropped last
//! where it contradicts the lengths). Sketches on the lattice come out bit for bit as they went in.
//! \param lines In: lengths whole and set, each at most kLengthTolerance off. Out: snapped.
//! \return residual is above 1e-9 only where the lengths contradict each other; those lines keep
//! the
//!         best that was found.
SnapReport snapToWholeLengths(std::vector<Line>& lines);

//! \brief The node at `index` modules from the line's start.
lattice::Vec3 nodeOfLine(const Line& line, int index);

}  // namespace liftarm::sketch
