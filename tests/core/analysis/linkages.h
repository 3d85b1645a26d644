#pragma once

#include <string>
#include <vector>

#include "analysis/freedoms.h"

namespace liftarm::testing {

//! \brief A linkage whose internal freedoms textbooks tell.
struct Mechanism {
  std::string name;
  analysis::Linkage linkage;
  int freedoms = 0;
};

//! \brief A hinge between two bodies about the line through `at`.
analysis::Link hinge(int a, int b, lattice::Vec3 at, lattice::Vec3 axis);

//! \brief Four bars of a 4-bar linkage (a rectangle of the given sides) in the plane z = 0.
analysis::Linkage fourBar(double width, double height);

std::vector<Mechanism> knownMechanisms();

//! \brief All bodies are frame bodies of equal weight; no joints.
analysis::FreedomsQuery queryOf(const analysis::Linkage& linkage);

//! \brief Internal freedoms counted the plain way: all six velocities of every body, all constraint
//! rows, dense Householder factors; less six for each connected assembly.
int nullityByReflections(const analysis::Linkage& linkage);

//! \brief The largest violation of a constraint row by velocities of the bodies.
double violation(const analysis::Linkage& linkage, const std::vector<analysis::Twist>& twists);

}  // namespace liftarm::testing
