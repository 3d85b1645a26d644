#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! Limits, checked before anything else is done with the input.
inline constexpr std::size_t kMaxSketchBytes = 8U << 20U;
inline constexpr std::size_t kMaxLines = 20000;
inline constexpr double kMaxCoordinate = 2000.0;  //!< modules, in magnitude
inline constexpr int kMaxTotalLength = 100000;    //!< modules over all lines
inline constexpr std::size_t kMaxJoints = 1000;
inline constexpr std::size_t kMaxSymmetries = 500;
inline constexpr std::size_t kMaxKeepOuts = 10000;
inline constexpr std::size_t kMaxJointBodies = 16;    //!< that share one joint
inline constexpr std::size_t kMaxJointLines = 20000;  //!< lines named by all joints together
inline constexpr std::size_t kMaxNameBytes = 200;
inline constexpr double kLengthTolerance = 0.05;  //!< modules off a whole length that are snapped

//! \brief Whether so many modules are snapped away: 0.95 is 0.05 off 1, though not in binary.
inline bool isSnapped(double off) {
  constexpr double kRounding = 1e-9;
  return std::abs(off) <= kLengthTolerance + kRounding;
}

//! \brief Reads a sketch (DESIGN 3) and snaps its lines to whole lengths (snap.h).
//! \details Strict: a key that the format does not know is refused, because it is most likely
//! misspelt. Lines that overlap or stand twice are legal. A joint lies at a node of its lines, and
//! is moved with that node when snapping moves it; so is a ground on which the lowest end point
//! stood. \param text The file's text, at most kMaxSketchBytes. \return The sketch, or
//! kInvalidInput with one message that names the place and what would be right,
//!         such as `lines[3]: length 4.5 is not a whole number of modules; nearest: 4 or 5`.
base::Result<Sketch> readSketch(std::string_view text);

//! \brief A sketch with its lines as they stood in the file, before they were snapped.
struct Reading {
  Sketch sketch;
  std::vector<Line> drawn;
};

//! \brief readSketch for those who want to tell what it changed (sketch_notes.h).
base::Result<Reading> readDrawing(std::string_view text);

//! \brief Writes a sketch so that reading it gives the same sketch.
std::string writeSketch(const Sketch& sketch);

}  // namespace liftarm::sketch
