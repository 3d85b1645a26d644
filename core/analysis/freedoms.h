#pragma once

#include <optional>
#include <vector>

#include "analysis/constraints_merge.h"
#include "analysis/constraints_screws.h"

namespace liftarm::analysis {

//! \brief Two of the bodies that share one joint, by their places in `between`.
struct JointPair {
  int first = 0;
  int second = 1;
};

//! \brief A line about which two bodies are meant to turn against each other.
struct JointLine {
  lattice::Vec3 at;
  lattice::Vec3 axis;
  std::optional<int> a;  //!< a body on either side, where there is one
  std::optional<int> b;
  int joint = 0;                       //!< of the sketch
  std::optional<JointPair> pair = {};  //!< which of its bodies, where it has more than two

  [[nodiscard]] bool hasBothSides() const { return a.has_value() && b.has_value(); }
};

//! \brief What is asked of a linkage.
struct FreedomsQuery {
  Linkage linkage;
  std::vector<bool> frame;     //!< per body: its motion counts (it holds a beam)
  std::vector<double> weight;  //!< per body: the heaviest that do not move against each other rest
  std::vector<JointLine> joints;
};

//! \brief One independent way to move, at the first order.
struct FreeMotion {
  int joint = -1;             //!< the joint that it turns, or -1
  int link = -1;              //!< of the merged linkage: the one that drives it
  bool shifts = false;        //!< it is driven by a shift along that link, not by turning
  std::vector<Twist> twists;  //!< per body; zero where it rests
};

//! \brief The freedoms of a linkage.
struct Freedoms {
  int internal = 0;      //!< independent motions of frame bodies against each other
  int spinning = 0;      //!< motions in which no frame body moves: pins, bushes, loose connectors
  int beyondJoints = 0;  //!< of `internal`, those in which no joint turns
  std::vector<bool> jointTurns;     //!< per joint: some motion turns it, and none breaks its axis
  std::vector<int> groupOf;         //!< per body: those of one group never move against each other
  std::vector<FreeMotion> motions;  //!< `internal` of them, those of joints first
  MergedLinkage merged;             //!< bodies that are certainly one are one
};

//! \brief Counts and finds the internal motions of a linkage at the first order.
//! \details The null space of all constraints less six for each assembly, less what only spins. In
//! an assembly without frame bodies every body counts.
Freedoms findFreedoms(const FreedomsQuery& query);

//! \brief Freedoms::beyondJoints alone, without finding what moves how: for searches, which ask
//! often.
int countFreedomsBeyondJoints(const FreedomsQuery& query);

//! \brief Merges what cannot move, beyond short loops: blocks without a motion, too.
MergedLinkage mergeAll(const Linkage& linkage);

//! \brief How a joint's side b moves against its side a.
//! \param twists Per body. \pre The joint has both sides.
struct JointMove {
  double rate = 0.0;    //!< turning about the joint's axis
  bool onAxis = false;  //!< nothing else than that: the points of the axis stay together
};

JointMove jointMove(const JointLine& joint, const std::vector<Twist>& twists);

}  // namespace liftarm::analysis
