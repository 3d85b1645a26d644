#pragma once

#include <optional>
#include <vector>

#include "analysis/balance.h"
#include "analysis/coverage.h"
#include "analysis/findings.h"
#include "analysis/freedoms.h"
#include "analysis/freedoms_braces.h"
#include "analysis/gear_trains.h"
#include "analysis/joint_motion.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief How a model stands and moves.
struct MotionReport {
  Freedoms free;                   //!< every pin turns
  Freedoms held;                   //!< pins with friction hold
  std::vector<JointRange> joints;  //!< one for each two bodies that share an annotated joint
  GearTrains trains;               //!< what gears couple
  std::optional<Balance> balance;
  std::vector<Brace> braces;  //!< against the free motions that no joint accounts for
};

MotionReport analyseMotion(const Scene& scene, const std::vector<EdgeCover>& coverage);

//! \brief The same without balance and braces, which nothing but a person asks for.
MotionReport analyseFreedoms(const Scene& scene, const std::vector<EdgeCover>& coverage);

//! \brief Item 7 of DESIGN 5: each annotated joint turns about its axis.
ItemResult checkJoints(const Scene& scene, const MotionReport& report);

}  // namespace liftarm::analysis
