#pragma once

#include <string>

#include "analysis/stress.h"

namespace liftarm::exporters {

//! Each bar becomes so many pairs of elements: CalculiX's own come within 0.4 % of a bar then.
inline constexpr int kCalculixPieces = 16;

//! \brief A solved frame as a CalculiX deck (.inp), in N, mm, MPa; nodes 1 to n are the frame's.
//! \details Its B31 and B32 become solids of a rectangle or circle, which no beam with holes is;
//! its user element U1 takes a general section. Of U1 (version 2.20) only one plane of bending is
//! right, and only when divided, and its torsion constant is always Iy + Iz. So each bar is two
//! rows of U1 with half the area each, one for each plane, and a scalar spring between its ends
//! makes up the torsion, negative where U1 is too stiff. Fits and contacts are SPRING1 on auxiliary
//! nodes whose displacements an EQUATION ties to the relative ones. Contacts that carry are linear,
//! the others left out. \pre state.stands.
std::string writeCalculix(const analysis::StressState& state, const std::string& title);

}  // namespace liftarm::exporters
