#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "layout/axle.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "objective/objective.h"
#include "search/earlier_layout.h"
#include "search/layout_search.h"
#include "search/supply.h"

namespace liftarm::search {

//! \brief Parts of the search that can be switched off, to see what each is worth
//! (docs/ablations.md).
struct SearchParts {
  bool corners = true;  //!< bent beams
  bool frames = true;   //!< frames
  bool focus = true;    //!< most moves at violated places
  bool pairs = true;    //!< moves that cover two runs anew
  bool many = true;     //!< ruin and recreate of several runs
  bool turns = true;    //!< moves that turn a run's hole axis
  bool noise = true;    //!< random amounts on the costs of a cover
  bool growth = true;   //!< violations that stay gain weight
  bool walls = true;    //!< a first layout whose lines change layers together (guide/layer_field)
  bool mirrors = true;  //!< moves that mirror a run's layers
  bool shifts = true;   //!< moves that shift or turn over all layers of a plane
  bool costly = true;   //!< moves at runs with more beams than they need
  bool axles = true;    //!< axles that cover lines
  bool orbits = true;   //!< covers that obey the confirmed symmetries, while that can be
};

//! \brief The name by which a person switches a part of the search off (`--set search.NAME=0`).
struct SearchSwitch {
  std::string_view name;
  bool SearchParts::*part;
};

inline constexpr std::array<SearchSwitch, 14> kSearchSwitches{{
    {"corners", &SearchParts::corners},
    {"frames", &SearchParts::frames},
    {"axles", &SearchParts::axles},
    {"focus", &SearchParts::focus},
    {"pairs", &SearchParts::pairs},
    {"many", &SearchParts::many},
    {"turns", &SearchParts::turns},
    {"noise", &SearchParts::noise},
    {"growth", &SearchParts::growth},
    {"walls", &SearchParts::walls},
    {"mirrors", &SearchParts::mirrors},
    {"shifts", &SearchParts::shifts},
    {"orbits", &SearchParts::orbits},
    {"costly", &SearchParts::costly},
}};

//! \brief How long and how the search makes a whole layout stiff. The defaults are for those who
//! ask for stiffness before all else.
struct StiffeningOptions {
  std::uint32_t rounds = 40;  //!< at most; small sketches would go on for thousands
  std::uint32_t roundsPerStart = 4;
  //! When no more rounds begin, in moves times runs squared, about what they take.
  double work = 1.5e7;
  double share = 1.0;       //!< of the moves of other rounds
  double weight = 1.0;      //!< of a freedom: 1 is half a beam at first, two beams at last
  bool otherStarts = true;  //!< whether other hole axes are tried where one start stays loose
  bool polish = false;      //!< one round even where nothing is loose: it takes parts out
  bool frees = false;       //!< whether what stays loose need not be symmetric after some rounds
};

struct AnnealingOptions {
  std::uint64_t seed = 1;
  int starts = 60;                //!< of stage one
  double startTemperature = 6.0;  //!< in units of the energy
  double endTemperature = 0.25;
  std::uint32_t iterationsPerRun = 60;
  std::uint32_t minIterations = 1600;
  std::uint32_t maxRounds = 17;  //!< further rounds while no layout without violations was found
  //! Most work (LayoutSearch::work) of a search: what is not whole by then is given up in
  //! mid-round, what is whole is made no better at the end of a round. About 8 seconds on a machine
  //! of 2024.
  double mostWork = 7e9;
  double mostWorkUntilWhole = 7e9;  //!< the same while no layout is whole
  SearchParts parts;
  Supply supply;  //!< what may be used; fewest parts beyond it after fewest violations
  std::vector<int> lengths{2, 3, 5, 6, 7, 9, 11, 13, 15};
  std::vector<int> bends = layout::allBentBeams();    //!< bent beams that may be laid
  std::vector<int> frames = layout::allFrameBeams();  //!< frames that may be laid
  std::vector<int> axles = layout::allAxleParts();    //!< that may cover lines, with bushes
  objective::Weights weights = objective::searchWeights(objective::Preset::kSimple);
  //! Layout of a sketch that this one came from: what still fits stays as it lies, and only what
  //! was touched is searched. Where that does not end whole, or takes many more beams, the search
  //! is as without it. Not used with symmetries or `freedoms`.
  EarlierLayout earlier;
  //! A layout to go on from, in place of the first one; null: none. Of the same problem.
  const LayoutSnapshot* from = nullptr;
  //! How many ways a whole layout can move that it should not; empty: nobody minds. It is dear to
  //! ask, so only further rounds at the end do, from the best layout without it.
  std::function<int(const LayoutSnapshot&)> freedoms;
  StiffeningOptions stiffening;
  //! Runs that can move so in the layout that `freedoms` was asked of last: moves begin there.
  std::function<std::vector<int>()> looseRuns;
  //! The rigid body that each beam is of, by run, by beam, in the layout that `freedoms` was asked
  //! of last.
  std::function<std::vector<std::vector<int>>()> bodies;
  //! Whether a layout is buildable in earnest; empty: each is that has no violations. Dear as well:
  //! the rounds that ask for freedoms keep no layout as their best before asking this, and a search
  //! that ends with frames asks it once: their holes on two axes can lock parts together.
  std::function<bool(const LayoutSnapshot&)> buildable;
  //! How many ways a layout can move that friction does not hold; empty: nobody minds. Asked of the
  //! few layouts in which axles cover lines whose beams pins held.
  std::function<int(const LayoutSnapshot&)> held;
};

}  // namespace liftarm::search
