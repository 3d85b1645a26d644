#pragma once

#include <vector>

#include "model/model.h"

namespace liftarm::model {

//! Two axes are one when they agree within this angle (1 degree) and this distance.
inline constexpr double kCoaxialCosine = 0.99985;
inline constexpr double kCoaxialDistance = 0.06;  //!< modules

//! \brief Finds from geometry every male slot that meets a female slot of another part on one axis.
//! \details A slot is one module long, or half a module in thin beams; a head of one module passes
//! two thin holes. Wrong meetings (isGood(fit) is false) are listed too: analysis judges them.
//! An axle in pin holes is kTurn where it cannot slide: where the parts on it lie side by side
//! without a gap between stops, each of them a collar of the axle or a part with an axle hole.
//! Parts that the catalogue does not have connect to nothing. \return In the order of male part,
//! feature and slot, then female.
std::vector<Connection> findConnections(const Model& model, const parts::Catalogue& catalogue);

}  // namespace liftarm::model
