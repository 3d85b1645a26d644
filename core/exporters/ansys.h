#pragma once

#include <string>

#include "analysis/stress.h"

namespace liftarm::exporters {

//! \brief A solved frame as an ANSYS APDL script, in N, mm, MPa; nodes 1 to n are the frame's.
//! \details Bars are BEAM188 (cubic) with arbitrary sections and their transverse shear stiffness;
//! fits and the contacts that carry are MATRIX27 stiffnesses, to a fixed node where they are to the
//! ground. Written by ANSYS's reference; not run here. \pre state.stands.
std::string writeAnsys(const analysis::StressState& state, const std::string& title);

}  // namespace liftarm::exporters
