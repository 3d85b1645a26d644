#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "design/settings.h"
#include "guide/guiding_graph.h"
#include "mechanisms/mechanism_table.h"
#include "search/annealing_options.h"
#include "search/layout_search.h"
#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief A place whose lines no parts were found to join, even with nothing else around.
struct CrowdedPlace {
  lattice::Vec3 at;
  double radius = 0.0;       //!< modules; 0: one node
  std::vector<int> lines;    //!< that have a node within the radius
  std::vector<int> without;  //!< those of them without which the others can be joined
};

//! \brief Moves of a round, besides those for each run, where many short rounds are worth more than
//! a long one.
inline constexpr std::uint32_t kShortRound = 800;

//! \brief Rounds in which all lines of a place are searched alone.
inline constexpr std::uint32_t kRoundsAlone = 12;

//! \brief The nodes of a layout whose beams are not all joined, or not without a fault.
std::vector<lattice::Vec3> violatedPlaces(const guide::GuidingGraph& graph,
                                          const search::LayoutSnapshot& layout);

//! \brief Lines of a sketch that have a node within so many modules of a point, in their order.
std::vector<int> linesNear(const sketch::Sketch& sketch, lattice::Vec3 at, double radius);

//! \brief Looks at one place alone: its lines, cut to what is near, and nothing else.
//! \details A layout of the whole sketch contains one of the lines of each place, but for beams
//! that a neighbouring node's mechanism joins; so where the lines alone find none, the whole sketch
//! is not worth a long search. No proof: the lines alone are searched too, in counted moves.
//! \return Nothing where they can be joined. Else those that can stay are found by laying one line
//! after the other.
std::optional<CrowdedPlace> findCrowded(const sketch::Sketch& sketch,
                                        lattice::Vec3 at,
                                        double radius,
                                        const Settings& settings,
                                        const mechanisms::MechanismTable& table);

//! \brief The options of a search as it is made of a place alone: so many rounds, short ones, and
//! no axles but for joints.
search::AnnealingOptions optionsAlone(const sketch::Sketch& sketch,
                                      search::AnnealingOptions options,
                                      std::uint32_t rounds);

//! \brief Whether a search of so many rounds joins all lines of a sketch. \param work
//! AnnealingOptions::mostWork.
bool joinsAll(const sketch::Sketch& sketch,
              const Settings& settings,
              const mechanisms::MechanismTable& table,
              std::uint32_t rounds,
              double work);

//! \brief What is said of it: place, reason and the change that would help, in one sentence.
std::string messageOf(const CrowdedPlace& place);

}  // namespace liftarm::design
