#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "guide/guiding_graph.h"
#include "layout/beam.h"
#include "layout/connection_solver.h"
#include "layout/frame_sites.h"
#include "layout/keeps.h"
#include "layout/local_view.h"

namespace liftarm::layout {

//! \brief Sums over a layout, kept up to date by every edit; the objective's terms are made of
//! them.
struct Tallies {
  int beams = 0;         //!< real beam parts (4 and 6 holes count two)
  int holes = 0;         //!< total length, in holes (paper 4.3, sum of L)
  int layerSquares = 0;  //!< sum of holes times layer squared (paper 4.3, F_dev)
  int overhang = 0;      //!< beam ends past the end of their run
  int hinges = 0;        //!< beams in line that share one hole only (DESIGN 7)
  int collisions = 0;    //!< pairs of beams that interpenetrate
  //! Holes below the ground, in a keep-out box or off an exact line, and beams in line that overlap
  //! where they have no hole in common; and what the sketch keeps and is not there
  //! (layout/keeps.h).
  int forbidden = 0;
  int gaps = 0;               //!< empty layers within stacks (DESIGN 7)
  int overfull = 0;           //!< beams beyond three in one stack
  int failedConnections = 0;  //!< clusters left at junctions, minus one each (DESIGN 7)
  int connectors = 0;         //!< connecting parts, spacers among them
  int mechanisms = 0;
  int mechanismHeads = 0;
  int mechanismCells = 0;
  double pinHeadRatios = 0.0;   //!< sum over mechanisms (paper 4.1)
  double connectionCost = 0.0;  //!< sum of Connection::cost
  int axles = 0;                //!< runs that an axle covers; its parts are connectors

  [[nodiscard]] int violations() const {
    return collisions + forbidden + gaps + overfull + failedConnections;
  }
};

//! \brief A one-hole beam in an empty layer of a junction's stack.
struct Spacer {
  lattice::Axis axis = lattice::Axis::kX;
  int layer = 0;
};

//! \brief What one junction adds to the tallies.
struct JunctionState {
  Connection connection;
  std::vector<Spacer> spacers;
  int gaps = 0;  //!< that no spacer fills
  int overfull = 0;
  bool leans = false;  //!< some of its beams are joined by a neighbouring junction's mechanism
  int loose = 0;       //!< beams that turn on an axle against others, without friction

  [[nodiscard]] int violations() const { return gaps + overfull + connection.failed; }
};

//! \brief What one run adds to the tallies besides its cover.
struct RunState {
  Cover cover;
  int collisions = 0;  //!< pairs of beams of which at least one is on this run
  int forbidden = 0;
};

//! \brief The fixed part of a layout problem, shared by all layouts of one sketch.
struct LayoutProblem {
  guide::GuidingGraph graph;
  bool spacers = true;  //!< whether gaps in stacks may be filled
  //! Whether mechanisms may only use holes within sqrt(3) of the uncovered edges that they bridge
  //! (paper 5.2), in place of any within three modules of the junction. Where no edge is uncovered
  //! a stack of beams is joined as ever.
  bool closeGroups = false;
  std::vector<LocalView> views;  //!< by junction
  std::vector<std::vector<std::pair<int, int>>>
      seenBy;                    //!< by run: (junction, index of its RunView)
  std::vector<FrameSite> sites;  //!< where frames may lie
  std::vector<RunKeep> keeps;    //!< what the sketch keeps, by run; empty: nothing
  std::vector<KeepFault> keepFaults;

  //! \brief What is kept on a run; null: nothing.
  [[nodiscard]] const RunKeep* keepOf(int run) const {
    const RunKeep* keep = keeps.empty() ? nullptr : &keeps[static_cast<std::size_t>(run)];
    return keep == nullptr || keep->empty() ? nullptr : keep;
  }
};

LayoutProblem makeLayoutProblem(guide::GuidingGraph graph, bool spacers = true);

//! \brief What one beam of a run counts for: a bent beam or a frame lies on several runs, of which
//! the lowest counts it, and nodes where its arms meet count once.
struct BeamShare {
  int parts = 0;
  int holes = 0;
};

//! \brief The placements in use with their layers, and the mechanisms that join them.
//! \details Edits are grouped: change covers, settle(), look at tallies(), then keep() or revert().
//! revert() restores exactly what was there before, so a rejected move costs no second search.
class Layout {
 public:
  //! \pre problem and solver outlive the layout.
  Layout(const LayoutProblem& problem, ConnectionSolver& solver);

  //! \brief Replaces the beams of one run. Its neighbours' connections are stale until settle().
  void setCover(int run, Cover cover);

  //! \brief Puts a layout back as it was, mechanisms and all, and keeps it. \pre Both lists are of
  //! one settled layout of this problem.
  void restore(const std::vector<Cover>& covers, const std::vector<JunctionState>& junctions);

  //! \brief Whether mechanisms may use the holes of frames that go across their bars. What is laid
  //! already is not joined anew.
  void setAcross(bool allowed) { across_ = allowed; }

  //! \brief Solves again every connection that the changes since keep() may touch.
  void settle() { settle({}); }

  //! \brief settle() that may give up: `hopeless` is asked each time tallies() has grown, while
  //! what is not solved yet counts with the least it can cost. \return False when it gave up; then
  //! only revert() may follow.
  bool settle(const std::function<bool()>& hopeless);

  void keep();
  void revert();

  //! \brief Solves every connection from scratch, in junction order.
  void settleAll();

  [[nodiscard]] const Tallies& tallies() const { return tallies_; }

  [[nodiscard]] const LayoutProblem& problem() const { return *problem_; }

  [[nodiscard]] const RunState& run(int id) const { return runs_[static_cast<std::size_t>(id)]; }

  [[nodiscard]] const JunctionState& junction(int id) const {
    return junctions_[static_cast<std::size_t>(id)];
  }

  [[nodiscard]] const mechanisms::MechanismTable& table() const { return solver_->table(); }

  //! \brief Violations weighted by place: what a search that is stuck raises (setWeights).
  [[nodiscard]] double weightedViolations() const { return weighted_; }

  //! \brief Weights of violations by junction and by run, each at least 0. Sizes as in the graph.
  void setWeights(std::vector<double> junctionWeights, std::vector<double> runWeights);

  [[nodiscard]] const std::vector<double>& junctionWeights() const { return junctionWeights_; }

  [[nodiscard]] const std::vector<double>& runWeights() const { return runWeights_; }

  //! \brief Tallies counted again from the covers and connections alone; equal to tallies() always.
  [[nodiscard]] Tallies recount() const;

  //! \brief Empty layers and beams too many in the stacks at a junction, whether settled or not.
  [[nodiscard]] int stackViolationsAt(int junction) const;

  //! \brief Beams of incident runs that a junction's mechanisms must join, by (run, beam index).
  [[nodiscard]] std::vector<std::pair<int, int>> terminalsAt(int junction) const;

  //! \brief Mechanisms that fit at a junction besides those that are there, and join beams of
  //! different bodies within its reach, whichever runs they are on. None at a joint.
  //! \param bodies By run, by beam. \param most The cheapest for each join, no more than these.
  std::vector<FurtherJoin> furtherJoins(int junction,
                                        const std::vector<std::vector<int>>& bodies,
                                        std::size_t most);

  //! \brief Adds a mechanism to what joins the beams at a junction. \pre All is settled and kept.
  //! Whatever solves the junction again takes it off.
  void addMechanism(int junction, const FurtherJoin& join);

  //! \brief What an axle on a run would have to do with, whatever covers the run now.
  //! \pre The run is principal.
  [[nodiscard]] AxleSite axleSite(int run) const;

 private:
  void addRun(const RunState& state, int run, int sign);
  void addJunction(const JunctionState& state, int junction, int sign);
  [[nodiscard]] int collisionsWith(int run, const Cover& cover, int other) const;
  [[nodiscard]] int forbiddenOf(int run, const Cover& cover) const;
  [[nodiscard]] BeamShare shareOf(int run, const Beam& beam) const;
  [[nodiscard]] bool hasFrameAt(int junction) const;
  void changeCollisions(int run, int delta);
  void solveJunction(int junction);
  void giveWay(int junction);
  bool fillProblem(int junction);
  void fillRun(const RunView& view);
  void fillFrame(const RunView& view,
                 const Beam& bar,
                 const InlinePins& before,
                 const InlinePins& after);
  bool fillOthers(int junction);
  void fillOwn(int junction);
  void fillSpacersOf(const JunctionView& other);
  void addAllTerminals(int junction);
  void addAxle(const Axle& axle, int sign);
  void limitToGroup(int junction);
  void fillAxles(int junction);
  void joinOnAxles(int junction);
  [[nodiscard]] std::uint64_t seatsOn(int run) const;
  [[nodiscard]] bool onAxle(int junction) const;
  void addAxleTerminals(int junction);
  void findStaleOnAxles();
  void countStackOnAxle(int junction, std::array<unsigned, 3>* layers, JunctionState* state) const;
  void findStale();
  void spreadStale();
  double clearStale();
  bool givesUp(double open, const std::function<bool()>& hopeless);
  void countStack(int junction, JunctionState* state) const;
  void fillSpacers(JunctionState* state);
  [[nodiscard]] bool plainStack(int junction, Connection* connection) const;
  [[nodiscard]] std::uint64_t signature(const RunView& view, const Cover& cover) const;
  void saveTallies();
  void saveJunction(int junction);

  const LayoutProblem* problem_;
  ConnectionSolver* solver_;
  std::vector<RunState> runs_;
  std::vector<JunctionState> junctions_;
  std::vector<double> junctionWeights_;
  std::vector<double> runWeights_;
  Tallies tallies_;
  double weighted_ = 0.0;

  Tallies savedTallies_;
  double savedWeighted_ = 0.0;
  std::vector<std::pair<int, RunState>> savedRuns_;
  std::vector<std::pair<int, JunctionState>> savedJunctions_;
  std::vector<std::uint8_t> runSaved_;
  std::vector<std::uint8_t> junctionSaved_;
  std::vector<std::uint8_t> stale_;
  std::vector<int> staleList_;
  std::vector<double> openCosts_;  // by place in staleList_, while settling
  LocalProblem local_;
  int localPiece_ = 0;
  bool across_ = true;
  std::vector<std::pair<int, int>> localTerminals_;  // an axle's beam index is -1
  int localLoose_ = 0;
  bool allTerminals_ = false;  // beams of any run may be terminals
};

}  // namespace liftarm::layout
