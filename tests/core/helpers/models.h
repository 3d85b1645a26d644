#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/model.h"

namespace liftarm::testing {

inline constexpr lattice::Vec3 kX{1, 0, 0};
inline constexpr lattice::Vec3 kY{0, 1, 0};
inline constexpr lattice::Vec3 kZ{0, 0, 1};

//! \brief A model of these parts, without a sketch.
inline model::Model modelOf(std::vector<model::PlacedPart> parts) {
  model::Model model;
  model.parts = std::move(parts);
  return model;
}

//! \brief A beam with its middle at `center` (the middle of its bounds along the beam), running
//! along `direction` from its first to its last hole, holes along `holeAxis`.
model::PlacedPart beamAt(const std::string& part,
                         lattice::Vec3 center,
                         lattice::Vec3 direction,
                         lattice::Vec3 holeAxis);

//! \brief A pin or axle (whose parts lie along their own x axis) with its origin at `center`.
model::PlacedPart pinAt(const std::string& part, lattice::Vec3 center, lattice::Vec3 axis);

//! \brief A part in its own orientation.
model::PlacedPart partAt(const std::string& part, lattice::Vec3 position);

//! \brief Turns a part about the world axis through its position by `degrees`.
void turn(model::PlacedPart& part, lattice::Vec3 axis, double degrees);

//! \brief A sketch of the given lines as JSON text; `more` is put in before the closing brace.
std::string sketchOf(const std::vector<std::pair<lattice::Vec3, lattice::Vec3>>& lines,
                     const std::string& more = "");

//! \brief A buildable square of 8 modules on the ground: beams along x in layer 0, along y in layer
//! 1, one friction pin in each corner. Parts 0, 1: along x at y = 0 and 8; 2, 3: along y at x = 0
//! and 8; 4 to 7: pins at (0,0), (8,0), (0,8), (8,8).
model::Model squareFrame();

//! \brief A buildable 3-4-5 triangle, doubled: its long side runs off the lattice.
model::Model pythagoreanTriangle();

//! \brief Two beams at right angles on one 55615; no sketch.
model::Model cornerOfTwoBeams();

//! \brief A line of 10 modules whose two middle edges a 48989 bridges.
model::Model bridgedLine();

//! \brief A 6-hole beam of two thin ones on a 5-hole beam; no sketch.
model::Model stackedThinBeams();

//! \brief A square with a 2-hole beam whose axle hole carries an axle with a bush at its end.
model::Model squareWithAxle();

//! \brief Two beams along x at y = 0 and 4 (parts 0, 1), and between them at x = 0 and 4 an axle of
//! seven with four bushes that stands for the line along y (parts 2 to 6, and 7 to 11).
model::Model frameOfAxles();

//! \brief All of these.
std::vector<model::Model> buildableModels();

}  // namespace liftarm::testing
