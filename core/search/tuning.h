#pragma once

#include <array>
#include <cstdint>

//! \file
//! \brief Every number that the default search is tuned by, with its unit and why it is what it is.
//! \details Costs are in units of the energy: one connecting part is about 1, a beam 10. Shares are
//! between 0 and 1. A number that a person may set is in AnnealingOptions instead. What the paper's
//! own method uses stands in the files of that method (paper_*.cpp), with the section it is from.

namespace liftarm::search {

//! \brief Rounds of annealing, and what is done when they end.
struct RoundTuning {
  //! Of the moves of a round, in the first: most sketches are whole after it, and seldom better for
  //! a longer one; those that are not need all the later ones.
  double firstShare = 0.6;
  std::uint32_t perStart = 3;        //!< rounds before other hole axes are tried
  std::uint32_t symmetric = 6;       //!< rounds with every symmetry that may be kept
  std::uint32_t lastSymmetric = 12;  //!< rounds with some of them
  std::uint64_t patience = 150;      //!< moves without progress before weights of violations rise
  double weightStep = 0.5;           //!< what a place that stays violated gains in weight each time
  double weightDecay = 0.95;         //!< share of the weight above 1 that a mended place keeps
  std::uint64_t checkEvery = 16;    //!< moves between looks at temperature and work; a power of two
  double earlierTemperature = 1.5;  //!< of what goes on from an earlier layout: most of it is good
};

//! \brief The first layout.
struct FirstLayoutTuning {
  double noise = 0.5;   //!< on the costs of first covers: starts are to differ, but not by much
  int tries = 16;       //!< at a first cover that obeys the symmetries
  int laterStarts = 4;  //!< of stage one after the first: few, so that they differ
  int budget =
      30000;       //!< starts times runs of stage one: a large sketch is not to keep one waiting
  int passes = 2;  //!< over the new runs of an edit: those laid first do not see the others
};

//! \brief How the energy of a layout is made up besides the objective.
struct EnergyTuning {
  //! A part beyond those owned, as a share of a violation: it weighs less than any other.
  double missingShare = 0.4;
  double same = 1e-9;           //!< energies closer than this are the same
  double beamWork = 10.0;       //!< nanoseconds for a beam looked at, over the shared sketches
  double mechanismWork = 12.0;  //!< the same for a mechanism
};

//! \brief Where a move begins.
struct PickTuning {
  double violated = 0.75;  //!< share of moves at a violated place, while there is one
  double near = 0.15;      //!< of these: at a run that passes near, not one that is met
  double costly = 0.5;     //!< of the others: at a run with more beams than it needs, if any
  double loose = 0.7;      //!< while stiffening: of moves at a run that can move
};

//! \brief What moves do; their own weights are in the table of moves (moves.cpp).
struct MoveTuning {
  double nearLayers = 0.3;   //!< share of moves that use one layer on either side at most: cheap
  double moreLayers = 0.6;   //!< of the others: those that use two
  double mostNoise = 9.0;    //!< on a beam's cost: nearly one beam
  double mirrorNoise = 0.2;  //!< share of the noise when a run follows a mirrored one: it is to fit
  double turn = 0.12;        //!< share of covers that turn the run's hole axis
  double turnMany = 0.3;     //!< the same where several runs are cleared
  double two = 0.35;         //!< share of covers after which a run that is met is covered too
  std::uint32_t mostMany = 4;   //!< runs that are cleared besides the first
  double straighten = 0.25;     //!< share of covers of a run with arms that take these off
  double cheapBend = 0.75;      //!< of bent beams: those that leave the fewest beams beside them
  std::uint32_t followers = 7;  //!< runs, less one, that may follow where layers have changed
  double leastFrameGain = 0.5;  //!< beams that a frame must save to be tried, about
  double sticksOut = 0.2;       //!< beams that an arm's end past the run counts for
  double cheapMiddle = 0.75;    //!< of middle beams: those that leave the fewest others
  double middleOnLine = 0.5;    //!< of middle beams: those on the line itself
};

//! \brief Rounds that make a layout stiff.
struct StiffeningTuning {
  //! What a freedom costs in the rounds of one start: half a beam at first, more than any at last.
  std::array<double, 4> freedomCosts{5, 8, 12, 20};
  std::uint32_t leastRounds = 3;  //!< whatever their work
  std::uint32_t symmetric = 3;    //!< rounds of one start before what is loose is freed
  //! What has more freedoms left than these after so many rounds is not made to be stiff.
  std::uint32_t hopefulRounds = 9;
  int fewFreedoms = 6;
  std::uint32_t plainRounds = 2;  //!< for another start to become whole
  double temperature = 3.0;       //!< at which a round begins: the layout is good already
};

//! \brief Trials of axles that cover lines.
struct AxleTuning {
  double temperature = 1.5;
  double leastSaving = 0.5;        //!< energy that a trial must save
  std::uint64_t movesPerRun = 30;  //!< of one trial, for each run it touches ...
  std::uint64_t fewMoves = 60;     //!< ... besides these ...
  std::uint64_t mostMoves = 500;   //!< ... and no more than these
  double mostShare = 0.3;          //!< moves of all trials, as a share of those before them
  int mostChecks = 4;              //!< of all that makes a model buildable: they are dear
  int fewestEdges = 2;  //!< of a run that an axle may cover: a shorter one has no room for bushes
  double mixedCost = 1.0;   //!< energy of a neighbour at a junction with another hole axis, about
  double hingesEach = 2.0;  //!< hinges for each beam that turns on an axle, as in Tallies::hinges
  double leastGain = 1.0;   //!< energy that a family must promise to be tried
};

//! \brief Mechanisms added at the end where something moves.
struct HoldTuning {
  double worth = 20.0;         //!< of a freedom less, in connecting parts: two beams
  std::size_t mostEach = 400;  //!< that are looked at for one junction
  std::size_t enough = 60;     //!< that help: no more are looked for before some are added
  double mostWork = 1e6;       //!< counts of freedoms, times parts: about microseconds
  int mostChecks = 6;          //!< of all that makes a model buildable: they are dear
};

//! \brief Exact covers of one run.
struct CoverTuning {
  int mostOverlap = 3;             //!< nodes that two beams in line share: no pin holds more
  std::uint64_t overlapWork = 12;  //!< of two beams against each other, in beams looked at
  double forbidden = 1e6;          //!< more than any cover costs that is allowed
  double fixedBonus = 1e7;         //!< what makes a fixed beam irresistible: more than forbidden
  double never = 1e18;             //!< more than any cover costs
};

//! \brief The lower bound on beams (cover_bound.cpp).
struct BoundTuning {
  int steps = 400;
  int patience = 15;  //!< steps without a better bound before the stride halves
  double firstStride = 1.0;
  double targetShare = 1.02;  //!< the bound that steps aim at, times the best so far ...
  double targetMore = 0.5;    //!< ... and this, in beams
};

struct Tuning {
  RoundTuning rounds;
  FirstLayoutTuning first;
  EnergyTuning energy;
  PickTuning picks;
  MoveTuning moves;
  StiffeningTuning stiffening;
  AxleTuning axles;
  HoldTuning holds;
  CoverTuning covers;
  BoundTuning bound;
};

inline constexpr Tuning kTuning{};

}  // namespace liftarm::search
