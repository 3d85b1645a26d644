#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "layout/connection_solver.h"
#include "objective/objective.h"
#include "search/annealing_options.h"
#include "search/paper_search.h"
#include "sketch/keep.h"

namespace liftarm::design {

inline constexpr std::string_view kDefaultMethod = "default";
inline constexpr std::string_view kPaperMethod = "paper";

//! \brief Whether a method is the paper's or one of its rivals (rivals/rivals.h), which share the
//! paper's placements, weights and count of gaps.
inline bool isPaperFamily(std::string_view method) {
  return method != kDefaultMethod;
}

//! \brief What a person may set. The defaults serve every sketch (DESIGN 7).
struct Settings {
  objective::Preset preset = objective::Preset::kBalanced;
  std::string method = "default";
  search::AnnealingOptions annealing;
  //! Of method "paper" and its rivals; what both have is taken from `annealing`.
  search::PaperOptions paper;
  bool closeGroups = true;  //!< of the same: mechanisms reach sqrt(3) far (layout/layout.h)
  double effort = 1.0;      //!< times the usual number of iterations
  // Those with which every shared sketch was found whole for every seed when corners were solved
  // one by one and with two parts at most; preset balanced adds 15100 and 44809.
  std::vector<std::string> connectors{
      "2780", "6558", "87082", "48989", "55615", "15462", "3713", "18654"};
  layout::ConnectionCosts connection;
  bool standing = false;     //!< nothing lies below the lowest drawn plane, where that can be
  bool corners = false;      //!< connectors may stand for the ends of beams at any corner
  bool symmetric = false;    //!< mirrors of the whole drawing are kept without being asked for
  bool otherPrices = false;  //!< whether searches with other prices are compared
  int mechanismParts = 2;    //!< most connecting parts in one mechanism
  //! How many of a part are owned, by LDraw number; others are not limited. What the search can do
  //! about it is in annealing.supply, lengths and connectors already.
  std::map<std::string, int> owned;
  sketch::Keeps keeps;  //!< what the sketch wants to stay; whoever has its text fills it in
};

//! \brief Where a search with these settings may let mechanisms stand for beams' ends.
inline guide::Bridging bridgingOf(const Settings& settings) {
  return settings.corners ? guide::Bridging::kAtEnds : guide::Bridging::kWhereNeeded;
}

//! \brief Reads {"seed", "preset", "method", "set": {key: value}, "earlier": layout}; an empty text
//! is all defaults. \details `earlier` is what DesignSession::layoutJson() gave for a sketch that
//! this one came from. Keys of `set`: `weights.TERM` (objective/term.h), `effort` (times the usual
//! number of iterations), `starts`, `rounds`, `startTemperature`, `endTemperature`,
//! `mechanismParts`, `lengths` ("2,3,5"), `bent` ("32526,60484", the bent beams that may be laid),
//! `frames` ("64179", the same of frames),
//! `axles` ("4519,32073", the axles that may cover lines, for which bushes are needed),
//! `connectors` ("2780,6558,87082"), `paper.coolingRate` and `paper.schedule` ("linear";
//! rivals/rivals.h) of method paper, `search.PART`, 1 or 0 (search/annealing_options.h,
//! SearchParts), and `owned.PARTID`, how many of a part there are at most (DESIGN 6): 0 switches it
//! off. \return The settings, or one message that names the key and what would be right.
base::Result<Settings> readSettings(std::string_view json);

//! \brief The settings as JSON with every key, for the contract with the page.
std::string settingsJson(const Settings& settings);

}  // namespace liftarm::design
