#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "search/axle_sites.h"
#include "search/phase.h"

namespace liftarm::search {

//! \brief Axles in place of beams. \details Where a joint leaves no choice they lie
//! from the first layout on. All others are tried on the best layout, line by line and whole
//! families of lines at once: the runs that an axle goes through are turned and covered anew, what
//! was touched is searched for a while, and it stays where it saves something, takes no more parts,
//! and makes nothing loose.
class AxleTrials final : public Phase {
 public:
  using Phase::Phase;

  Next begin() override;
  Next endRound() override;

  [[nodiscard]] MoveHabits habits() const override { return {.focus = focus_}; }

  void afterMove() override { keep(); }

 private:
  [[nodiscard]] std::vector<int> freeRuns() const;
  Next nextTrial();
  bool beginTrial(const AxleFamily& family);
  bool clear(const AxleFamily& family, lattice::Axis axis);
  bool layAll(const AxleFamily& family, lattice::Axis axis);
  void keep();
  [[nodiscard]] double worthOfFreedoms() const;
  [[nodiscard]] bool isSound(LayoutSnapshot* trial);

  std::vector<AxleFamily> trials_;
  std::size_t next_ = 0;
  std::uint64_t movesLeft_ = 0;  // of all trials
  std::uint64_t moves_ = 0;      // of this one
  int checksLeft_ = 0;
  int freedomsBefore_ = 0;         // of the best layout, where somebody minds
  std::optional<int> heldBefore_;  // what friction does not hold, in the best layout
  LayoutSnapshot bestTrial_;
  std::vector<int> focus_;   // runs that the trial touched
  std::set<int> touched_;    // the same while it is laid
  std::vector<int> turned_;  // runs whose hole axis it turned
};

}  // namespace liftarm::search
