#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "layout/layout.h"
#include "objective/hinge_graph.h"
#include "objective/place_index.h"

namespace liftarm::objective {

//! \brief How many degrees of freedom a layout has beyond its joints with every pin turning, at the
//! first order: what analysis/freedoms says of the model, in a hundredth of the time, since
//! mechanisms are reduced to hinges once and no part is placed. \details Beams and connecting parts
//! are the bodies of a HingeGraph. Pins hold along their axis. An axle is a pin to what is on it.
class Mobility {
 public:
  //! \pre Both outlive this.
  Mobility(const layout::LayoutProblem& problem, const mechanisms::MechanismTable& table);

  //! \param covers One for each run. \param junctions One for each junction, settled.
  int count(const std::vector<layout::Cover>& covers,
            const std::vector<layout::JunctionState>& junctions);

  //! \brief After count(): which rigid body each beam is of, by run, by beam.
  [[nodiscard]] std::vector<std::vector<int>> bodies() const;

  //! \brief After count(): runs with a beam that may move against the largest rigid body.
  [[nodiscard]] std::vector<int> looseRuns() const;

 private:
  struct LocalHinge {
    int a = -1;
    int b = -1;
    lattice::Axis axis = lattice::Axis::kX;
    lattice::Vec3 at;
  };

  struct Head {
    int body = -1;
    lattice::Axis axis = lattice::Axis::kX;
    lattice::Vec3 at;
  };

  struct Seat {
    int line = -1;
    int body = -1;
    double along = 0.0;  //!< where on the line
  };

  //! \brief An oriented mechanism as bodies, hinges between them, and heads that beams may be on.
  struct Reduced {
    int bodies = 0;
    std::vector<LocalHinge> hinges;
    std::vector<Head> heads;
  };

  void addBeams(const std::vector<layout::Cover>& covers);
  void addArm(int run, const layout::Beam& beam, int body);
  void addAxle(int run, const layout::Cover& cover);
  void addMechanism(const layout::PlacedMechanism& placed, lattice::Vec3 origin);
  void addHinge(lattice::Axis axis, lattice::Vec3 at, int a, int b);
  [[nodiscard]] int twinOf(int body) const;
  void lockJoints();
  [[nodiscard]] const Reduced& reduced(int oriented);
  [[nodiscard]] Reduced reduce(const mechanisms::Mechanism& shape) const;

  const layout::LayoutProblem* problem_;
  const mechanisms::MechanismTable* table_;
  std::vector<Reduced> reduced_;  // by oriented mechanism, made when first asked for
  std::vector<std::uint8_t> isReduced_;
  HingeGraph graph_;
  PlaceIndex holes_;
  PlaceIndex lines_;
  std::vector<std::pair<lattice::Axis, lattice::Vec3>> linePlaces_;
  std::vector<Seat> lineBodies_;            // for joints
  std::vector<std::vector<int>> bodiesOf_;  // by run, by beam
  std::vector<std::array<int, 4>> arms_;    // site or -1, lower run, upper run, body
  std::vector<std::pair<int, int>> twins_;  // halves of one beam
};

}  // namespace liftarm::objective
