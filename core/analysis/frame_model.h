#pragma once

#include <vector>

#include "analysis/constraints.h"
#include "analysis/frame.h"
#include "analysis/frame_skeleton.h"
#include "analysis/loads.h"
#include "analysis/scene.h"
#include "base/status.h"

namespace liftarm::analysis {

//! \brief What friction is taken to hold.
enum class FitHold {
  kFree,   //!< nothing: Friction::kFree
  kHeld,   //!< what Friction::kHeld does
  kLocked  //!< every fit
};

//! \brief How a model is loaded and held.
struct StressOptions {
  FitHold friction = FitHold::kHeld;
  double heldStiffness = kHeldStiffness;  //!< N mm / rad, an ASSUMPTION
  std::vector<PointLoad> loads;           //!< beside the weight
};

//! \brief The frame of a model, and where its pieces came from.
struct FrameModel {
  Frame frame;
  std::vector<std::vector<int>> nodesOfPart;
  std::vector<int> connectionOfSpring;  //!< index into Scene::connections; -1: holds the model in
                                        //!< place on the ground
  double weight = 0.0;                  //!< N
  lattice::Vec3 up{0, 0, 1};  //!< away from the table, in the model's axes: weights pull against it
  double tilt = 0.0;          //!< degrees between the table's up and the drawing's
};

//! \brief Makes a frame of a model.
//! \details Nodes where something is joined, at ends, corners and loads; bars along the parts'
//! skeletons; each head in its hole is a spring (materials.h) that lets go of what the fit lets go
//! of; it rests on a table as it would by itself (frame_contacts.h). Weights of parts are spread
//! along their bars. Fits that are not good join nothing; meshing gears neither. \return
//! kUnsupported for a part that the catalogue does not have, kInvalidInput for a load in the air.
base::Result<FrameModel> makeFrameModel(const Scene& scene, const StressOptions& options);

}  // namespace liftarm::analysis
