#pragma once

#include <optional>

#include "parts/catalogue.h"

namespace liftarm::testing {

//! \brief A prism with all its surface drawn in.
parts::Prism drawnIn(parts::Prism prism, double by);

//! \brief How far two prisms are apart, by going to and fro between their nearest points until a
//! plane parts them or a point is in both: each answer is its own proof, and shares nothing with
//! analysis/convex.
//! \return Modules, at most the distance and 0 where they share a point; nothing where the rounds
//! found neither proof.
std::optional<double> distance(const parts::Prism& a, const parts::Prism& b, int rounds = 4000);

}  // namespace liftarm::testing
