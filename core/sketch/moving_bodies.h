#pragma once

#include <utility>
#include <vector>

#include "lattice/vec.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief Two bodies of a sketch that turn against each other about a point of a plane.
struct PlanePin {
  int a = -1;
  int b = -1;
  double u = 0.0;
  double v = 0.0;
};

//! \brief Where a body of a plane is: p -> turn by `angle` about the plane's origin, then shift.
struct PlanePose {
  double u = 0.0;
  double v = 0.0;
  double angle = 0.0;
};

//! \brief Which lines of a sketch move as one: lines that share a node, unless a joint there sets
//! them apart.
//! \return A body for each line, numbered from 0 in the order of the lines.
std::vector<int> bodiesOfLines(const Sketch& sketch);

//! \brief The two axes of the plane across a joint's axis: (u, v, axis) is right-handed.
//! \pre axis is a principal axis or its reverse.
std::pair<lattice::Axis, lattice::Axis> planeAcross(lattice::Vec3 axis);

//! \brief A linkage of bodies in one plane that a joint drives: closed chains are kept closed by
//! Gauss-Newton steps on the pins' distances, from the drawn pose on (as in the kinematics of
//! planar mechanisms with reference-point coordinates \cite haug_1989_kinematics).
class PlaneLinkage {
 public:
  //! \param pins   Of all joints about parallel axes. \param bodies How many there are.
  //! \param driver Place in `pins`: its body b is turned against its body a, which stands still.
  PlaneLinkage(std::vector<PlanePin> pins, int bodies, int driver);

  //! \brief Turns the driver to an angle (radians, from the drawn pose), near the present one.
  //! \return False where the chain cannot close there: a dead point.
  bool turnTo(double angle);

  void reset();

  //! \brief By body; those that nothing joins to the driver stay as drawn.
  [[nodiscard]] const std::vector<PlanePose>& poses() const { return poses_; }

 private:
  void addEquations(double angle);
  [[nodiscard]] double error() const;
  [[nodiscard]] bool solveStep(std::vector<double>* step);

  std::vector<PlanePin> pins_;
  int driver_ = 0;
  std::vector<int> places_;  // of each body's unknowns, or -1
  std::size_t unknowns_ = 0;
  std::vector<PlanePose> poses_;
  std::vector<double> rows_;    // Jacobian, row by row
  std::vector<double> misses_;  // by row
};

}  // namespace liftarm::sketch
