#pragma once

#include <vector>

#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief What two bodies may still do against each other: turn about a line, shift along it, both
//! or neither. Both directions of motion share one line.
struct Link {
  int a = -1;
  int b = -1;
  bool turns = true;    //!< pin in pin hole, axle in pin hole
  bool shifts = false;  //!< axle in pin hole
  lattice::Vec3 at;     //!< a point of the line, world, modules
  lattice::Vec3 axis;   //!< unit direction of the line
};

//! \brief Bodies and the links between them: all that rigidity needs to know of a model.
struct Linkage {
  int bodies = 0;
  std::vector<Link> links;
};

//! \brief Whether friction counts.
enum class Friction {
  kFree,  //!< every pin in a pin hole turns, every axle in one turns and slides
  kHeld   //!< pins with ridges hold, those of connectors too; no axle slides. The rest turns
};

//! \brief What a fit lets go of.
struct Play {
  bool turns = false;   //!< about the head's axis
  bool shifts = false;  //!< along it
};

//! \brief The one notion of what friction holds, for freedoms and for stress. \pre The fit is good.
Play playOf(const Scene& scene, const model::Connection& connection, Friction friction);

//! \brief The linkage of a model; body i is part i.
//! \details Pin in pin hole: turns (5 constraints). Axle in pin hole: turns and shifts (4). Axle in
//! axle hole: nothing (6). Thin holes alike. Fits that are wrong (item 3 of DESIGN 5) hold nothing.
Linkage linkageOf(const Scene& scene, Friction friction);

//! \brief Whether two links run on one line, either way.
bool onOneLine(const Link& p, const Link& q);

//! \brief What is left where two links join the same two bodies: the motions that both allow.
//! \return With the line of `p`; neither turns nor shifts where they lock each other.
Link together(const Link& p, const Link& q);

}  // namespace liftarm::analysis
