#pragma once

#include <vector>

#include "layout/layout.h"

namespace liftarm::search {

//! \brief Whether an axle of at most `longest` slots may cover a run: a principal line whose hole
//! axis nobody has fixed, and every run that it meets may have its holes along it. At a joint the
//! axle turns: there the run may share its group with no other.
bool mayHaveAxle(const guide::GuidingGraph& graph, int run, int longest);

//! \brief Whether nothing but an axle can cover a run: it is one side of a joint about itself, and
//! no pin can hold its beams there. \pre mayHaveAxle().
bool needsAxle(const guide::GuidingGraph& graph, int run);

//! \brief The runs that a run meets, each once, ascending.
std::vector<int> runsMet(const guide::GuidingGraph& graph, int run);

//! \brief What things cost, in the units of the search's energy.
struct AxleCosts {
  double beam = 10.0;
  double hole = 0.05;
  double hinge = 3.0;
  double loose = 0.0;  //!< all that moves and should not: an axle may do away with it
};

//! \brief Runs to be tried with axles all at once: parallel ones that go through the same beams.
struct AxleFamily {
  std::vector<int> runs;
  double gain = 0.0;  //!< what that may save at best, about
};

//! \brief Families that may be worth a trial, the best first; what is in a larger family follows
//! alone. \param runs Those that may have axles, ascending. \pre layout is settled.
std::vector<AxleFamily> findAxleFamilies(const layout::Layout& layout,
                                         const std::vector<int>& runs,
                                         const AxleCosts& costs);

}  // namespace liftarm::search
