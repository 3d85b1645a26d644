#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lattice/vec.h"
#include "parts/catalogue.h"

namespace liftarm::mechanisms {

//! \brief One unit cell of a mechanism: a head that sits in a beam, or body.
struct MechanismCell {
  lattice::Cell at;                        //!< relative to the mechanism's origin
  bool head = false;                       //!< a free pin head; else connector body
  lattice::Axis axis = lattice::Axis::kX;  //!< heads: the pin's axis; bodies with a hole: its axis
  bool openHole = false;                   //!< body with a hole that nothing fills yet
  parts::FeatureKind kind = parts::FeatureKind::kPin;
  bool mustHold = false;  //!< heads between stops: only when all of them hold a beam
  bool stopped = false;   //!< body that an axle sits in: what is next to it on the axle cannot pass
  lattice::Cell collar{};  //!< heads: side on which a collar ends the axle, a unit cell; else 0
};

//! \brief One real part of a mechanism, relative to its origin.
struct MechanismPart {
  std::string id;
  lattice::Pose pose;
};

//! \brief A small assembly of pins and connectors that joins beams (paper 4.1), on the unit
//! lattice.
struct Mechanism {
  std::vector<MechanismPart> parts;
  std::vector<MechanismCell> cells;  //!< heads first

  [[nodiscard]] int headCount() const;

  //! \brief Heads over all nodes (paper 4.1, "pin-head ratio").
  [[nodiscard]] double pinHeadRatio() const;
};

//! \brief What to compose from, and how far.
struct CompositionOptions {
  std::vector<std::string> partIds;  //!< connecting parts in use; order matters for ties only
  int maxParts = 2;
  int maxCells = 9;
};

//! \brief All assemblies of up to maxParts connecting parts with at least two free heads, all of
//! them pin heads or heads of an axle between stops (its collar, or parts with an axle hole), one
//! for each shape up to rotation; of two with the same heads only the one whose body is not
//! contained in the other's stays (paper 4.1 by program instead of by study).
std::vector<Mechanism> composeMechanisms(const parts::Catalogue& catalogue,
                                         const CompositionOptions& options);

//! \brief The mechanism turned by one of the 24 lattice rotations.
Mechanism rotated(const Mechanism& mechanism, const lattice::Mat3& rotation);

}  // namespace liftarm::mechanisms
