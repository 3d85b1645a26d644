#pragma once

#include <optional>
#include <vector>

#include "analysis/rank.h"

namespace liftarm::analysis {

//! \brief The same as findNullBasis for a large matrix with few entries.
//! \details Gaussian elimination that keeps the rows short \cite markowitz_1957_elimination among
//! the pivots that are large enough. Faster by orders of magnitude than orthogonalisation, and less
//! sure of the rank: so it tells when a pivot was so small or an entry grew so large that rounding
//! might count. \return Nothing then.
std::optional<NullBasis> eliminateSparse(const ColumnMatrix& matrix,
                                         const std::vector<int>& lateness);

//! \brief Null space of a block: by elimination where it is large and that is sure, else by
//! orthogonalisation.
NullBasis findNullBasisOfAny(const ColumnMatrix& matrix, const std::vector<int>& lateness);

}  // namespace liftarm::analysis
