#pragma once

#include <utility>
#include <vector>

#include "guide/guiding_graph.h"
#include "layout/beam.h"
#include "layout/local_view.h"

namespace liftarm::layout {

//! \brief One bar of a frame on the run that it covers.
struct SiteArm {
  int run = -1;
  Beam beam;    //!< on layer 0, with the site's index
  int own = 0;  //!< nodes that no arm before it has
};

//! \brief A place where every bar of a frame lies on a run of its own.
struct FrameSite {
  int frame = -1;  //!< index in frameBeams()
  lattice::Axis axis = lattice::Axis::kZ;
  lattice::Pose pose;         //!< of the part on layer 0
  bool exact = false;         //!< it may lie on layer 0 only
  std::vector<SiteArm> arms;  //!< by run, ascending
};

//! \brief All places where frames can lie. \details Each bar on another run, parallel to a
//! principal axis, which may stick out past either end of its run by one module and covers at least
//! one edge of it. Where bars cross the runs must meet, and no joint may turn there; nor may one
//! turn where the frame's hole goes another way. All holes on an exact line of one hole axis go
//! along it: shafts may run in any of them. Runs near a junction off their lattice are left out,
//! since frames are wider than the beams whose shadows local views know. \param views, seenBy As in
//! LayoutProblem.
std::vector<FrameSite> findFrameSites(const guide::GuidingGraph& graph,
                                      const std::vector<LocalView>& views,
                                      const std::vector<std::vector<std::pair<int, int>>>& seenBy);

//! \brief The arm on this run. \pre There is one.
const SiteArm& armOn(const FrameSite& site, int run);

}  // namespace liftarm::layout
