#include "analysis/well_built.h"

#include "analysis/well_built_items.h"

namespace liftarm::analysis {

std::vector<WellBuiltItem> judgeWellBuilt(const WellBuiltQuery& query) {
  return {judgeFaithful(query),
          judgeStanding(query),
          judgeStiffness(query),
          judgeCleanness(query),
          judgeSymmetry(query),
          judgeFewness(query)};
}

}  // namespace liftarm::analysis
