#pragma once

#include <string>

#include "gears/train.h"

namespace liftarm::gears {

//! \brief A sketch of a frame for a train: two upright plates across y, a column for each place
//! along them where shafts stand, rails that join the columns, and beams from plate to plate beyond
//! the gears. Its first shaft is that of the train, its second the last; a drive couples them.
//! \param request What the train was found for.
//! \return Text of a sketch (DESIGN 3). The train's first axis is up, its second along x.
std::string gearFrame(const Train& train, const TrainRequest& request);

}  // namespace liftarm::gears
