#pragma once

#include <optional>
#include <vector>

#include "guide/guiding_graph.h"
#include "layout/beam.h"
#include "layout/frame_sites.h"
#include "layout/layout.h"

namespace liftarm::search {

//! \brief What a finished layout had on one run, told by places, since another sketch has other
//! runs.
struct EarlierRun {
  lattice::Vec3 from;  //!< its first node, modules
  lattice::Vec3 to;    //!< its last node
  //! Mates of beams are places in the list of runs; bars of frames have no site, but the frame as
  //! their form.
  layout::Cover cover;
  //! By junction on it: index of the node, number of runs that meet there, and 1 where a mechanism
  //! may bridge an edge.
  std::vector<int> meets;
};

using EarlierLayout = std::vector<EarlierRun>;

//! \brief A layout as a later search may take it over. \param sites Of the layout's problem.
//! \param covers One for each run, or none at all.
EarlierLayout earlierLayout(const guide::GuidingGraph& graph,
                            const std::vector<layout::FrameSite>& sites,
                            const std::vector<layout::Cover>& covers);

//! \brief What of an earlier layout still fits.
struct KeptRuns {
  std::vector<std::optional<layout::Cover>> covers;  //!< by run; none where the run is new
  //! Runs that are new, that meet others than before, or that meet a new one; ascending.
  std::vector<int> touched;
  int kept = 0;
};

//! \brief What may be laid.
struct Allowed {
  const std::vector<int>& lengths;              //!< numbers of holes of straight beams
  const std::vector<int>& bends;                //!< bent beams, by index in layout::bentBeams()
  const std::vector<int>& frames;               //!< by index in layout::frameBeams()
  const std::vector<layout::FrameSite>& sites;  //!< where frames may lie now
};

//! \brief Finds the runs of an earlier layout again: same ends, a hole axis and beams that are
//! still allowed. A bent beam or a frame is kept when all its runs are. \param earlier May come
//! from a file: what is not sensible in it is not kept.
KeptRuns keepRuns(const guide::GuidingGraph& graph,
                  const EarlierLayout& earlier,
                  const Allowed& allowed);

//! \brief Takes out the covers that are not as the sketch wants them (layout/keeps.h), with those
//! that share a bent beam or a frame with them.
void dropUnwanted(const layout::LayoutProblem& problem, KeptRuns* kept);

}  // namespace liftarm::search
