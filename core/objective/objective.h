#pragma once

#include <optional>
#include <string_view>

#include "objective/term.h"

namespace liftarm::objective {

//! \brief A weight for each term of kTerms.
using Weights = std::array<double, kTerms.size()>;

//! \brief Place of a term in kTerms and Weights.
std::optional<std::size_t> termIndex(std::string_view name);

//! \brief What a person asks for (paper 4.3; DESIGN 7).
//! `balanced` is ours: it wants all of DESIGN 5b at once, and is what a person gets who asks for
//! nothing.
enum class Preset { kFaithful, kSimple, kFaithfulRigid, kSimpleRigid, kBalanced };

std::optional<Preset> presetFromName(std::string_view name);
std::string_view nameOf(Preset preset);

//! \brief Whether the preset asks for stiffness.
bool isRigid(Preset preset);

//! \brief Weights of the default search, in units of one connecting part; the same for all
//! sketches.
Weights searchWeights(Preset preset);

//! \brief The paper's weights (4.3) for its own terms; all others 0.
Weights paperWeights(Preset preset);

//! \brief The weighted sum of all terms.
double value(const Measures& measures, const Weights& weights);

//! \brief By how much a change of layout changes the objective: exact, since both sides are sums.
double delta(const Measures& before, const Measures& after, const Weights& weights);

}  // namespace liftarm::objective
