#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/freedoms.h"
#include "analysis/freedoms_query.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief One end of a joint's range.
struct RangeEnd {
  double degrees = 0.0;        //!< at most 180 in magnitude
  std::vector<int> stoppedBy;  //!< two parts that would collide; empty at a dead point or full turn
};

//! \brief How far a joint turns.
struct JointRange {
  bool turns = false;
  RangeEnd from;
  RangeEnd to;
  std::string message;                 //!< one sentence for a person
  int joint = 0;                       //!< of the sketch
  std::optional<JointPair> pair = {};  //!< which of its bodies, where it has more than two
};

//! \brief Key poses along a motion.
struct MotionPath {
  std::vector<int> parts;       //!< those that move
  std::vector<double> degrees;  //!< of what drives the motion, rising, 0 among them
  std::vector<std::vector<lattice::Pose>> poses;  //!< [key][part]: part frame -> world, modules
};

struct JointMotion {
  JointRange range;
  MotionPath path;  //!< empty where nothing turns
};

//! \brief Moves the joints and mechanisms of a model for real (kinematic_chain.h) until something
//! collides, a closed chain comes to a dead point, or half a turn is made either way.
class JointMover {
 public:
  //! \param scene, coverage Must outlive this.
  JointMover(const Scene& scene, const std::vector<EdgeCover>& coverage);

  [[nodiscard]] int joints() const { return static_cast<int>(free_.query.joints.size()); }

  [[nodiscard]] const Freedoms& free() const { return free_.freedoms; }

  [[nodiscard]] const Freedoms& held() const { return held_.freedoms; }

  //! \brief Turns two bodies of a joint of the sketch against each other: those of joint line
  //! `joint` (findJointLines). Pins with friction hold where it turns all the same;
  //! otherwise they turn too. Freedoms that are not the joint's are locked. \pre 0 <= joint <
  //! joints()
  [[nodiscard]] JointMotion turnJoint(int joint) const;

  //! \brief Goes through one motion of free().motions. \pre The index is one of them.
  [[nodiscard]] JointMotion follow(int motion) const;

 private:
  struct Study {
    FreedomsQuery query;
    Freedoms freedoms;
  };

  [[nodiscard]] JointMotion turnLine(int joint) const;
  [[nodiscard]] std::string whyStiff(int joint) const;
  [[nodiscard]] static int baseOf(const Study& study,
                                  int motion,
                                  const MergedLinkage& locked,
                                  const Link& driver);
  [[nodiscard]] JointMotion run(const Study& study, int motion, Link driver) const;

  const Scene& scene_;
  Study free_;
  Study held_;
  double slack_ = 0.0;  // of the pins in their holes
};

}  // namespace liftarm::analysis
