#pragma once

#include "analysis/frame_model.h"

namespace liftarm::analysis {

//! Faces this little above the lowest point rest on the ground too, modules: beams laid flat reach
//! 0.5 below their holes, beams on edge 0.45.
inline constexpr double kGroundTolerance = 0.06;

//! \brief Rests a model on the ground.
//! \details The lowest faces of bodies and of heads that are in no hole get points of contact,
//! which push up and do not pull (Frame::contacts). Each assembly that rests is kept from sliding
//! and turning about the vertical by three springs (Frame::springs) in two far points: the least
//! that will do, so that the ground carries no sideways force where the loads have none.
void addGround(const Scene& scene, FrameModel& model);

}  // namespace liftarm::analysis
