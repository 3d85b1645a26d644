#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::analysis {

//! \brief One thing that is wrong, and where.
struct Problem {
  std::string kind;                 //!< short and fixed, such as "collision"
  std::string message;              //!< one sentence for a person
  std::optional<lattice::Vec3> at;  //!< world, modules
  std::vector<int> parts;           //!< indices into the model's parts
};

//! \brief The answer to one item of DESIGN 5.
struct ItemResult {
  std::vector<Problem> problems;  //!< empty: the item holds
  std::string detail;             //!< what was looked at, with numbers
};

}  // namespace liftarm::analysis
