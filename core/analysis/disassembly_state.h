#pragma once

#include <vector>

#include "analysis/blocking.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief Which parts each part has a fitting head or hole of: lists, ascending, each part once.
std::vector<std::vector<int>> findNeighbours(const Scene& scene);

//! \brief The parts that are still together, and who blocks whom among them.
//! \details Keeps a count of blockers for each part and direction, so that finding what is free
//! takes no look at the graph.
class DisassemblyState {
 public:
  //! Keeps references to the graphs.
  DisassemblyState(const BlockingGraph& graph,
                   const std::vector<std::vector<int>>& neighbours,
                   std::vector<int> parts);

  [[nodiscard]] const std::vector<int>& parts() const { return parts_; }

  [[nodiscard]] bool has(int part) const { return active_[static_cast<std::size_t>(part)] != 0; }

  //! \brief How many of the others a part would hit on its way out.
  [[nodiscard]] int blockerCount(int direction, int part) const {
    return counts_[static_cast<std::size_t>(direction)][static_cast<std::size_t>(part)];
  }

  //! \brief Whether a set can leave as a whole. \param set Ascending.
  [[nodiscard]] bool isFree(int direction, const std::vector<int>& set) const;

  void remove(const std::vector<int>& set);

  //! \brief Connected sets of parts, each ascending, in order of their first part.
  [[nodiscard]] std::vector<std::vector<int>> components() const;

  //! \brief The same without some parts.
  [[nodiscard]] std::vector<std::vector<int>> componentsWithout(const std::vector<int>& set) const;

  //! \brief A set with all that would hang on nothing once it has left, if that is less than half
  //! and hangs together; else the set alone. \param set Ascending.
  [[nodiscard]] std::vector<int> withLoose(const std::vector<int>& set) const;

  //! \brief For each part of the model, whether its leaving would divide what it is connected to:
  //! articulation points \cite tarjan_1972_depth.
  [[nodiscard]] std::vector<char> cutParts() const;

  //! \brief The strongly connected sets of the blocking graph that nothing outside blocks, without
  //! single parts and the whole. Each ascending.
  [[nodiscard]] std::vector<std::vector<int>> lockedSets(int direction) const;

  //! \brief All that must leave with one part or another, that part included: each set once,
  //! ascending, in order of the first part that it was found for.
  [[nodiscard]] std::vector<std::vector<int>> closures(int direction) const;

  //! \brief Connected sets of parts that leave together in some direction, and whose leaving does
  //! not divide the rest: the smallest first.
  [[nodiscard]] std::vector<std::vector<int>> setsThatDivideNothing() const;

  [[nodiscard]] bool connected(const std::vector<int>& set) const;

  //! \brief The parts that are not in a set.
  [[nodiscard]] std::vector<int> others(const std::vector<int>& set) const;

 private:
  [[nodiscard]] std::vector<std::vector<int>> componentsOf(const std::vector<char>& inside) const;
  [[nodiscard]] std::vector<int> closure(int direction, int part) const;

  const BlockingGraph& graph_;
  const std::vector<std::vector<int>>& neighbours_;
  std::vector<int> parts_;
  std::vector<char> active_;
  std::vector<std::vector<int>> counts_;
};

}  // namespace liftarm::analysis
