#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/rng.h"
#include "guide/orientation.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "layout/layout.h"
#include "objective/objective.h"
#include "search/axle_sites.h"
#include "search/earlier_layout.h"
#include "search/layout_search.h"
#include "search/orbit_covers.h"
#include "search/run_coverer.h"
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
  //! How many ways a whole layout can move that it should not; empty: nobody minds. It is dear to
  //! ask, so only further rounds at the end do, from the best layout without it.
  std::function<int(const LayoutSnapshot&)> freedoms;
  StiffeningOptions stiffening;
  //! Runs that can move so in the layout that `freedoms` was asked of last: moves begin there.
  std::function<std::vector<int>()> looseRuns;
  //! Whether a layout is buildable in earnest; empty: each is that has no violations. Dear as well:
  //! the rounds that ask for freedoms keep no layout as their best before asking this, and a search
  //! that ends with frames asks it once: their holes on two axes can lock parts together.
  std::function<bool(const LayoutSnapshot&)> buildable;
  //! How many ways a layout can move that friction does not hold; empty: nobody minds. Asked of the
  //! few layouts in which axles cover lines whose beams pins held.
  std::function<int(const LayoutSnapshot&)> held;
};

//! \brief Stage two: simulated annealing (paper 5.3) whose move covers one run, or two that meet,
//! anew and exactly (RunCoverer), and joins what it touched anew (ConnectionSolver). \details Where
//! violations stay, their places gain weight until the search leaves them (as breakout local search
//! does); the best layout is kept by (violations, energy). Stepped and deterministic.
class Annealer final : public LayoutSearch {
 public:
  //! \pre problem and solver outlive the annealer.
  Annealer(const layout::LayoutProblem& problem,
           layout::ConnectionSolver& solver,
           AnnealingOptions options);

  //! \brief At most `iterations` moves. \return True when the search has ended.
  bool advance(std::uint32_t iterations) override;

  [[nodiscard]] bool done() const override { return done_; }

  [[nodiscard]] const LayoutSnapshot& best() const override { return best_; }

  [[nodiscard]] std::uint32_t improvements() const override { return improvements_; }

  [[nodiscard]] std::uint64_t iterations() const override { return iterationsBefore_ + iteration_; }

  [[nodiscard]] double temperature() const override { return temperature_; }

  [[nodiscard]] double work() const override;

  [[nodiscard]] double fraction() const override;

  //! \brief "stageOne" until the first layout is there, then "stageTwo", then "done".
  [[nodiscard]] const char* phase() const override;

  [[nodiscard]] bool grown() const override { return grown_; }

  [[nodiscard]] const layout::Layout& current() const { return layout_; }

 private:
  static constexpr double kPickAxis = 0.12;  // share of moves that turn the run's hole axis

  void start();
  void beginAfresh();
  bool layEarlier();
  void layBestAxis(int run);
  [[nodiscard]] bool keepsUp() const;
  void startOver();
  bool withdrawFrames();
  void layFirst(int starts);
  void move();
  void beginRound();
  void finishRound();
  [[nodiscard]] bool hasWhole() const;
  [[nodiscard]] bool isOverworked() const;
  [[nodiscard]] int pickRun();
  [[nodiscard]] int pickPartner(int run);
  void place(int run, const layout::Cover& cover);
  bool layBound(int run, lattice::Axis axis);
  void loosenSymmetry();
  bool recover(int run, double noise, double turning = kPickAxis);
  bool recoverMany(int run, double noise);
  bool mirror(int run, double noise);
  bool shift(int run);
  [[nodiscard]] std::vector<int> planeOf(int run) const;
  bool recoverCrossing(int run, double noise);
  [[nodiscard]] int pickCostlyRun();
  bool coverRun(int run, lattice::Axis axis, double noise, const std::vector<layout::Beam>& fixed);
  bool straighten(int run, double noise);
  bool takeFrameOff(int run, int site, double noise);
  bool bend(int run, double noise);
  void findUsefulSites();
  bool layFrame(double noise);
  [[nodiscard]] bool mayLieAt(const layout::FrameSite& site) const;
  void takeOff(int run, const layout::Beam& arm, std::vector<int>* bare);
  void followCrossing(const std::vector<int>& covered, double noise);
  [[nodiscard]] std::optional<lattice::Axis> bendAxis(int run, int mate) const;
  [[nodiscard]] double energy();
  [[nodiscard]] double plainEnergy(const layout::Tallies& tallies, int freedoms) const;
  void raiseWeights();
  void keepBest();
  void layAgain();
  void goOnStiffening();
  void releaseLooseRuns();
  void beginStiffening();
  void startAgain();
  void offerAgain();
  [[nodiscard]] bool isBuildable(const LayoutSnapshot& layout) const;
  [[nodiscard]] LayoutSnapshot snapshot() const;
  void findAxleRuns();
  void releaseAxleRuns();
  void turnToAxles(guide::Orientation* orientation) const;
  bool layAxleOn(int run);
  void relayAxles();
  void finish();
  void nextTrial();
  bool beginTrial(const AxleFamily& family);
  void keepBestTrial();
  [[nodiscard]] bool isSound(LayoutSnapshot* trial);
  void finishTrial();
  bool passes(double limit);
  void findLooseRuns();

  const layout::LayoutProblem* problem_;
  const layout::ConnectionSolver* solver_;
  AnnealingOptions options_;
  base::Rng rng_;
  layout::Layout layout_;
  RunCoverer coverer_;
  OrbitCovers orbits_;
  SupplyCounter supply_;
  int missing_ = 0;  // of the layout that energy() saw last
  LayoutSnapshot best_;
  bool started_ = false;
  bool done_ = false;
  std::uint64_t iteration_ = 0;
  std::uint64_t roundBegin_ = 0;
  std::uint64_t roundLength_ = 0;
  std::uint32_t round_ = 0;
  std::uint32_t improvements_ = 0;
  std::uint64_t lastChange_ = 0;
  bool grown_ = false;      // from an earlier layout
  std::vector<int> focus_;  // runs that moves begin at then; where there are none, any
  int mostBeams_ = 0;       // that a grown layout may have
  double coldTemperature_ = 0.0;
  std::uint64_t iterationsBefore_ = 0;  // done before the search began afresh
  double temperature_ = 0.0;
  double energy_ = 0.0;
  // Rounds that make the model stiff: some from the best layout, then some from that of another
  // start, and so on.
  bool stiffening_ = false;
  bool again_ = false;  // another start than the first, with a best of its own
  std::uint32_t startsAgain_ = 0;
  LayoutSnapshot bestAgain_;
  double plainTemperature_ = 0.0;  // that rounds start from which do not stiffen
  std::uint32_t stiffRounds_ = 0;  // of this start ...
  std::uint32_t plainRounds_ = 0;  // ... before which it had so many of the other kind
  std::uint32_t allStiffRounds_ = 0;
  double stiffWork_ = 0.0;      // of all starts, in moves times runs squared
  int freedoms_ = 0;            // of the current layout, while stiffening
  std::vector<int> looseRuns_;  // of it
  double freedomCost_ = 0.0;    // of each
  // Axles that cover lines.
  std::vector<int> axleRuns_;               // that may have one
  std::vector<std::uint8_t> mustHaveAxle_;  // by run
  bool trying_ = false;                     // them on the best layout, at the end
  std::vector<AxleFamily> trials_;
  std::size_t nextTrial_ = 0;
  std::uint64_t trialMovesLeft_ = 0;
  int checksLeft_ = 0;
  std::optional<int> heldBefore_;  // of the best layout
  LayoutSnapshot bestTrial_;
  mutable objective::Measures measures_;  // reused: the tallies change, the scale does not
  objective::Weights softWeights_{};      // options_.weights without the hard conditions
  double violationWeight_ = 0.0;
  std::vector<int> fewestBeams_;  // by run: a lower bound
  std::vector<int> sites_;
  std::vector<layout::Bend> bends_;  // that fit, of one move
  std::vector<int> frameSites_;      // where a frame may save beams
  bool acrossFrames_ = true;         // whether holes across their bars may be used
  int site_ = -1;                    // violated junction that the last pick came from
};

}  // namespace liftarm::search
