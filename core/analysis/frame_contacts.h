#pragma once

#include "analysis/frame_model.h"

namespace liftarm::analysis {

//! \brief Rests a model on a table as it really comes to rest (frame_rest.h).
//! \details Feet are points of contact, which push and do not pull (Frame::contacts). Each assembly
//! that rests is kept from sliding and turning on the table by three springs (Frame::springs) in
//! two far points: the least that will do, so that the table carries no sideways force where the
//! loads have none. Weights, which must be all the loads so far and along -z, are turned with the
//! table. \param loads Put on later; what of them presses down has its say in how the model rests.
void addGround(const Scene& scene, const std::vector<PointLoad>& loads, FrameModel& model);

}  // namespace liftarm::analysis
