#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/constraints.h"
#include "analysis/constraints_screws.h"

namespace liftarm::analysis {

//! \brief The velocities that a linkage allows at the first order, as rates of its links.
//! \details Bodies are ordered as a tree; each link that closes a loop gives six equations in the
//! rates of the loop's links. Links that share no loop, even by way of others, do not depend on
//! each other, so each such block is solved apart: small matrices (docs/freedoms.md).
class MotionBasis {
 public:
  //! \param lateness One number per link: the late ones drive a motion where they can (rank.h).
  MotionBasis(const Linkage& linkage, const std::vector<int>& lateness);

  //! \brief How many independent motions there are beside those of whole assemblies.
  [[nodiscard]] std::size_t size() const { return rates_.size(); }

  //! \brief The twist of each body in a motion; the first body of each assembly is at rest.
  [[nodiscard]] std::vector<Twist> twists(std::size_t motion) const;

  //! \brief The link whose rate is one in this motion and zero in the others, and whether that is a
  //! shift. Locking it takes this motion away and no other.
  struct Driver {
    int link = -1;
    bool shifts = false;
  };

  [[nodiscard]] Driver driver(std::size_t motion) const { return drivers_[motion]; }

  //! \brief The assembly of each body: bodies that links connect. By first member from 0.
  [[nodiscard]] const std::vector<int>& assemblies() const { return assemblies_; }

  //! \brief Pairs of bodies that cannot move against each other: those of blocks without a motion.
  [[nodiscard]] const std::vector<std::pair<int, int>>& locked() const { return locked_; }

 private:
  struct Column {
    int link = -1;
    Twist screw;
  };

  struct Step {
    int parent = -1;
    int link = -1;
  };

  void growTree();
  [[nodiscard]] std::vector<int> loopOf(int link) const;
  [[nodiscard]] std::vector<std::vector<int>> blocks() const;
  void solveBlock(const std::vector<int>& links, const std::vector<int>& lateness);
  [[nodiscard]] double signAlong(int link, int from) const;

  const Linkage& linkage_;
  std::vector<Column> columns_;
  std::vector<std::size_t> firstColumn_;  // of each link, and the end
  std::vector<int> order_;                // bodies, parents first
  std::vector<Step> steps_;
  std::vector<int> depths_;
  std::vector<bool> inTree_;  // per link
  std::vector<int> assemblies_;
  std::vector<std::vector<double>> rates_;  // per motion and column
  std::vector<Driver> drivers_;
  std::vector<std::pair<int, int>> locked_;
};

}  // namespace liftarm::analysis
