#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "layout/connection_solver.h"

namespace liftarm::layout {

//! \brief The search behind ConnectionSolver, with the working sets that it uses again and again:
//! what fits between two holes is tried on a grid of one byte for each cell of the box.
class ConnectionSearch {
 public:
  //! \pre table outlives the search.
  ConnectionSearch(const mechanisms::MechanismTable& table, ConnectionCosts costs);

  //! \brief The cheapest connection of a junction's beams; of the holes near it first, and of all
  //! within reach when those do not suffice.
  Connection run(const LocalProblem& problem);

  //! \brief All mechanisms that fit between beams of different clusters, the cheapest for each join
  //! first; no more than `most`.
  std::vector<FurtherJoin> joins(const LocalProblem& problem, std::size_t most);

  //! \brief Mechanisms that were held against a place or against each other, in all runs.
  [[nodiscard]] std::uint64_t work() const { return work_; }

 private:
  //! A mechanism's cell, and how far its index in the box is from that of the mechanism's origin.
  struct PackedCell {
    std::int16_t offset = 0;
    std::uint8_t axis = 0;
    bool mustHold = false;
    std::array<std::int8_t, 3> at{};
  };

  //! An oriented mechanism: cells first .. first + count of cells_, of which the first are heads.
  struct PackedShape {
    double cost = 0.0;
    std::uint32_t first = 0;
    std::uint16_t heads = 0;
    std::uint16_t count = 0;
    std::array<std::int8_t, 3> low{};  // of its cells' places
    std::array<std::int8_t, 3> high{};
  };

  //! A mechanism that fits at a place, and what it joins.
  struct Candidate {
    PlacedMechanism placed;
    int origin = 0;               // index of the place in the box, which it may be outside of
    std::uint32_t terminals = 0;  // then: clusters
    double cost = 0.0;
    double value = 0.0;  // cost for each join
  };

  void enter(const LocalProblem& problem);
  void leave();
  Connection within(int radius);
  void collect(int radius, std::size_t most);
  void findHoles(int radius);
  void tryPlace(std::int32_t id, int head, lattice::Cell hole);
  [[nodiscard]] bool comesOut(const PackedShape& shape, lattice::Cell place) const;
  void sortCandidates(std::size_t most);
  void toClusters();
  [[nodiscard]] bool respectsJoint(const mechanisms::OrientedMechanism& m,
                                   lattice::Cell at,
                                   std::uint32_t joined) const;
  [[nodiscard]] bool fits(const Candidate& candidate) const;
  void take(const Candidate& candidate, std::uint8_t mark);
  void descend(std::size_t depth, std::uint32_t grown, int left, double cost);

  const mechanisms::MechanismTable* table_;
  ConnectionCosts costs_;
  std::vector<PackedCell> cells_;
  std::vector<PackedShape> shapes_;

  const LocalProblem* problem_ = nullptr;
  std::array<std::uint8_t, kBoxCells> codes_{};  // what is in each cell of the box
  std::array<std::uint8_t, kBoxCells> taken_{};  // cells of the chosen mechanisms
  std::vector<const LocalHole*> holes_;
  std::vector<Candidate> candidates_;
  std::vector<std::vector<std::uint16_t>> open_;  // by depth: candidates that may still be chosen
  std::vector<PlacedMechanism> chosen_;
  double leastValue_ = 0.0;  // of any candidate
  Connection best_;
  int nodes_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace liftarm::layout
