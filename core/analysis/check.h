#pragma once

#include <string>
#include <vector>

#include "analysis/findings.h"
#include "analysis/motion.h"
#include "analysis/well_built.h"
#include "model/model.h"

namespace liftarm::analysis {

//! \brief One item of the contract in DESIGN 5.
struct CheckItem {
  std::string id;
  std::string title;
  bool ok = false;
  std::string detail;
};

//! \brief Numbers of a model, found from its geometry alone.
struct CheckCounts {
  int beams = 0;
  int bricks = 0;  //!< all parts
  int gaps = 0;
  int collisions = 0;         //!< pairs of parts
  int uncovered = 0;          //!< rows of edges neither covered nor bridged
  int failedConnections = 0;  //!< problems of items 3 and 4
  double mass = 0.0;          //!< grams
  lattice::Vec3 size;         //!< modules along x, y, z
};

//! \brief What a model is worth.
struct CheckReport {
  bool buildable = false;    //!< all items hold
  bool assemblable = false;  //!< item 6 holds
  std::vector<CheckItem> items;
  std::vector<Problem> problems;  //!< item by item
  CheckCounts counts;
  MotionReport motion;                   //!< how it stands and moves; item 7 is judged by it
  std::vector<WellBuiltItem> wellBuilt;  //!< DESIGN 5b; no part of `buildable`
};

//! \brief Judges a model by DESIGN 5, items 1 to 7.
//! \details Written against the placed parts alone: shares nothing with the search but the
//! catalogue.
//! \param model May come from any file; its sketch, if it has one, is read for items 2, 4, 5 and 7.
CheckReport checkModel(const model::Model& model, const parts::Catalogue& catalogue);

//! \brief checkModel()'s answer alone: what is quick to see first, and no further once it is no.
bool isBuildable(const model::Model& model, const parts::Catalogue& catalogue);

}  // namespace liftarm::analysis
