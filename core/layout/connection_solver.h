#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "layout/local_view.h"
#include "mechanisms/mechanism_table.h"

namespace liftarm::layout {

//! \brief A mechanism in use at a junction: which, and where its origin is relative to the
//! junction.
struct PlacedMechanism {
  std::int32_t oriented = -1;
  lattice::Cell at;
};

//! \brief A mechanism that could join beams besides what joins them already.
struct FurtherJoin {
  PlacedMechanism placed;
  double cost = 0.0;  //!< in parts, as Connection::cost
};

//! \brief What a junction's mechanisms cost besides their parts, in parts.
struct ConnectionCosts {
  double dangling = 0.3;    //!< a head that holds nothing
  double secondHead = 0.2;  //!< less for each further head in a beam: such a corner is stiffer
};

//! \brief How the beams of one junction are joined.
struct Connection {
  std::vector<PlacedMechanism> mechanisms;
  int failed = 0;     //!< clusters of beams left, minus one (DESIGN 7)
  double cost = 0.0;  //!< of the mechanisms, in parts
};

//! \brief A free or used hole of a beam in the box.
struct LocalHole {
  lattice::Cell at;
  lattice::Axis axis = lattice::Axis::kX;
  int terminal = -1;  //!< beam to be joined, by its number, or -1: another beam
  bool used = false;
};

//! \brief One junction's problem: what stands in the box, and which beams must be joined.
class LocalProblem {
 public:
  static constexpr int kMaxTerminals = 16;

  void clear();

  //! \brief Marks a cell as taken by something that no mechanism may enter.
  void block(int cell);

  //! \brief Blocks the cells that a unit cube anywhere would enter, seen from the box's middle.
  void blockAround(lattice::Vec3 middle);

  //! \brief Puts a hole into a cell; two beams in one cell block it.
  void addHole(const LocalHole& hole);

  //! \brief Marks the hole in a cell, if there is one, as taken by a head.
  void useHole(int cell);

  //! \brief Two terminals that are joined already, elsewhere.
  void join(int terminalA, int terminalB);

  int terminals = 0;
  bool isJoint = false;  //!< groups may be joined by one coaxial pin only
  lattice::Axis jointAxis = lattice::Axis::kX;
  std::array<std::int8_t, kMaxTerminals> group{};  //!< joint group of each terminal, -1: any
  std::array<std::int8_t, kMaxTerminals> cluster{};
  std::uint32_t frames = 0;  //!< bit t: terminal t is a frame, which has bars on several sides

  [[nodiscard]] const LocalHole* holeAt(int cell) const;
  [[nodiscard]] bool blocked(int cell) const;

  [[nodiscard]] const std::vector<LocalHole>& holes() const { return holes_; }

  //! \brief The cells that are not empty, each once.
  [[nodiscard]] const std::vector<int>& cells() const { return touched_; }

  //! \brief Equal for equal problems; the order in which they were described does not matter.
  [[nodiscard]] std::uint64_t hash() const;

 private:
  void touch(int cell);

  std::array<std::int16_t, kBoxCells> content_{};  //!< 0 empty, -1 blocked, else hole number + 1
  std::vector<LocalHole> holes_;
  std::vector<int> touched_;
};

class ConnectionSearch;

//! \brief The beam connection procedure (paper 5.2) for one junction: the cheapest set of
//! mechanisms that joins all its beams, stacks and posts together (DESIGN 7), by depth-first search
//! over the mechanisms that fit, with a bound. Answers are kept by the hash of the problem.
class ConnectionSolver {
 public:
  //! \pre table outlives the solver.
  explicit ConnectionSolver(const mechanisms::MechanismTable& table, ConnectionCosts costs = {});
  ~ConnectionSolver();
  ConnectionSolver(const ConnectionSolver&) = delete;
  ConnectionSolver& operator=(const ConnectionSolver&) = delete;

  const Connection& solve(const LocalProblem& problem);

  //! \brief Single mechanisms that join beams of different clusters, the cheapest for each join
  //! first; no more than `most`.
  std::vector<FurtherJoin> joins(const LocalProblem& problem, std::size_t most);

  [[nodiscard]] const mechanisms::MechanismTable& table() const { return *table_; }

  //! \brief What all answers took, in mechanisms looked at: a measure of time that is no clock.
  [[nodiscard]] std::uint64_t work() const;

  [[nodiscard]] std::size_t hits() const { return hits_; }

  [[nodiscard]] std::size_t misses() const { return misses_; }

 private:
  const mechanisms::MechanismTable* table_;
  std::unique_ptr<ConnectionSearch> search_;
  std::unordered_map<std::uint64_t, Connection> known_;  // looked up only, never walked
  std::size_t hits_ = 0;
  std::size_t misses_ = 0;
};

}  // namespace liftarm::layout
