#pragma once

#include <vector>

#include "analysis/disassembly.h"
#include "analysis/scene.h"

namespace liftarm::instructions {

//! \brief One part or one finished group that is put in its place.
struct Add {
  std::vector<int> parts;  //!< indices into the model
  //! Straight moves in the order in which they are made, modules; the last one ends in the place.
  //! Empty: it is laid down, nothing is in its way.
  std::vector<lattice::Vec3> legs;
  int subgroup = -1;    //!< the group that these parts are, or a copy of it
  bool forced = false;  //!< something is in its way: analysis::StuckParts tells what
};

//! \brief What a person does between two pictures.
struct Step {
  int group = 0;
  std::vector<Add> adds;
  bool stable =
      false;  //!< what is built of the group by then stands or lies on the table by itself
};

//! \brief Parts that are built apart, once for each copy.
struct Group {
  std::vector<int> parts;  //!< all of them, those of its subgroups included
  std::vector<std::vector<int>>
      copies;                        //!< the parts of each further copy, in the order of `parts`
  std::vector<bool> mirrored;        //!< for each copy: built as the mirror image
  std::vector<lattice::Pose> poses;  //!< for each copy that is not: takes the group to it
};

//! \brief How a model is built. Group 0 is the whole; the steps of a group come before the step
//! that adds it, and every part is added once in the group where it is built.
struct Sequence {
  std::vector<Group> groups;
  std::vector<Step> steps;
  std::vector<analysis::StuckParts> stuck;
};

//! \brief The disassembly of a model, reversed and made into steps.
//! \pre The model has at most analysis::kMaxPartsTakenApart parts.
Sequence planSequence(const analysis::Scene& scene);

}  // namespace liftarm::instructions
