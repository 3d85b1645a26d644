#pragma once

#include <cstdint>
#include <vector>

#include "layout/layout.h"
#include "search/cover_request.h"

namespace liftarm::search {

//! \brief What beams of one run cost at its junctions: faults of the stacks that they make with the
//! beams of other runs, and layers that they had better not have. \details Nodes are given by their
//! index on the run, -1 to edges + 2. One object serves call after call, so that its lists stay.
class JunctionCosts {
 public:
  //! \pre problem outlives this.
  JunctionCosts(const layout::LayoutProblem& problem, const CoverCosts& costs)
      : problem_(&problem), costs_(costs) {}

  //! \brief Looks at what meets a run now.
  void prepare(const layout::Layout& layout, const CoverRequest& request);

  //! \brief Whether a mechanism may bridge an edge at a node, for want of a common hole axis.
  [[nodiscard]] bool mayBridge(int node) const { return mixed_[index(node)] != 0; }

  //! \brief Place of a node's junction for cost(), or -1 where there is none.
  [[nodiscard]] int placeOf(int node) const { return places_[index(node)]; }

  //! \brief What these layers (bits, see layerBit) cost at a junction.
  [[nodiscard]] double cost(int place, unsigned own) const;

 private:
  static std::size_t index(int node) { return static_cast<std::size_t>(node + 1); }

  void addJunction(const layout::Layout& layout, const CoverRequest& request, std::size_t j);

  const layout::LayoutProblem* problem_;
  CoverCosts costs_;
  std::vector<std::uint8_t> mixed_;  // by node
  std::vector<int> places_;          // by node: place in the lists below, or -1
  std::vector<unsigned> others_;     // layers of other beams with this axis
  std::vector<unsigned> unwanted_;   // layers that are not preferred
  std::vector<double> weights_;      // of violations
};

//! \brief The bit of a layer in a set of layers.
constexpr unsigned layerBit(int layer) {
  return 1U << static_cast<unsigned>(layer + guide::kMaxLayer);
}

}  // namespace liftarm::search
