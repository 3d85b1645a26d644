#pragma once

#include <vector>

#include "model/connections.h"

namespace liftarm::model {

//! Heads that are further from their holes' lines than this are not seated: that is no rounding.
inline constexpr double kRoundedGap = 0.018;  //!< modules
inline constexpr double kRoundedTurn = 4e-3;  //!< radians

//! \brief Takes the rounding of a file out of its poses: rotations become orthonormal, and heads
//! come to lie exactly in their holes.
//! \details Programs write poses with three to six decimals; a closed chain of hinges that are off
//! by so much cannot move at all, and tolerances wide enough for it would let dead points pass. So
//! the smallest moves of all parts that bring each head into its hole are found: Gauss-Newton steps
//! on six unknowns a part, each the least-norm solution by conjugate gradients (CGLS) \cite
//! bjorck_1996_least. Parts that stand on the lattice hold still, as they carry no rounding; heads
//! out of place by more than rounding are left out, so that a fault stays where it is; and where
//! nothing is off by more than 1e-10 not a bit changes.
void seatHeads(Model& model, const parts::Catalogue& catalogue);

//! \brief How far the worst of the heads that fit lies from where it would sit exactly, modules and
//! radians. \param parts Those of the model. \param connections As found from it.
double seatingError(const Model& model,
                    const std::vector<const parts::Part*>& parts,
                    const std::vector<Connection>& connections);

}  // namespace liftarm::model
