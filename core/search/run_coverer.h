#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/rng.h"
#include "layout/layout.h"
#include "layout/stack.h"

namespace liftarm::search {

//! \brief What a beam, a joint in line and a violation cost while one run is covered anew.
struct CoverCosts {
  double beam = 10.0;                   //!< each real beam part
  double hole = 0.05;                   //!< each hole: prefers beams that fit
  double layer = 0.4;                   //!< each layer off the line, for each beam
  double layerHole = 0.0;               //!< each hole times layer squared (the paper's deviation)
  double hinge = 3.0;                   //!< two beams in line that share one hole only
  double overhang = 2.0;                //!< a beam that sticks out past the run's end
  double spacer = layout::kSpacerCost;  //!< each gap that a spacer fills
  double violation = 25.0;  //!< a collision, gap or overfull stack, times the place's weight
};

//! \brief Covers one run anew, exactly, while all other runs stay: dynamic programming over the
//! run's nodes and layers, in place of the paper's edge-by-edge operator (5.2). \details A state is
//! (last node of the latest beam, its layer). The next beam overlaps it in one to three nodes on a
//! neighbouring layer; at a junction with a run of another hole axis the first edge may be left to
//! a mechanism instead (paper 5.2, uncovered edges). Costs add up over beams and nodes, so the
//! cheapest cover is found in O(nodes * layers * lengths). How well mechanisms will join the result
//! is not additive: noise on the costs makes different proposals, and the caller judges them.
class RunCoverer {
 public:
  //! \param lengths Allowed numbers of holes, ascending.
  RunCoverer(const layout::LayoutProblem& problem, std::vector<int> lengths, CoverCosts costs);

  //! \param noise Highest random amount added to each beam's cost.
  //! \return The cheapest cover with this hole axis under the noise; nothing when there is none.
  std::optional<layout::Cover> propose(
      const layout::Layout& layout, int run, lattice::Axis axis, double noise, base::Rng* rng);

  //! \brief Beams that the next proposals must contain as they are: arms of bent beams and bars of
  //! frames. Empty again: none.
  //! They may have lengths that no other beam of the proposals may have.
  void setFixed(std::vector<layout::Beam> fixed);

  //! \brief Highest layer, on either side, that the next proposals may use: fewer layers, less
  //! work.
  void setReach(int layers) { wantedReach_ = layers; }

  //! \brief What all proposals took, in beams looked at: a measure of time that is no clock.
  [[nodiscard]] std::uint64_t work() const { return work_; }

  [[nodiscard]] int reach() const { return wantedReach_; }

  //! \brief Layers that the next proposals had better have at the run's junctions
  //! (guide/layer_field); null: any. The list must outlive the proposals.
  void setPreferred(const std::vector<int>* layers) { preferred_ = layers; }

  //! \brief What a beam of each length costs besides, for the next proposals; empty: nothing.
  void setLengthCosts(std::vector<double> costs) { lengthCosts_ = std::move(costs); }

  [[nodiscard]] const CoverCosts& costs() const { return costs_; }

 private:
  static constexpr double kNever = 1e18;     // more than any cover costs
  static constexpr double kForbidden = 1e6;  // more than any cover costs that is allowed

  struct Choice {
    int previous = -1;  //!< state that it continues, -1 at the run's start
    int start = 0;
  };

  void prepare(const layout::Layout& layout, int run, lattice::Axis axis);
  void addBlockers(const layout::Layout& layout, int run, lattice::Axis axis);
  void addJunctionCosts(const layout::Layout& layout, int run, lattice::Axis axis);
  void addToBeams(int layer, int firstEnd, int lastStart, double cost);
  void countForbidden(int run, lattice::Axis axis, int layer);
  void setPlainCosts(int layer);
  [[nodiscard]] int allowedPlace(std::size_t length) const;
  void addBeamCosts(int run, lattice::Axis axis, double noise, base::Rng* rng);
  void favourFixed();
  [[nodiscard]] bool markFixed(layout::Cover* cover) const;
  void markCrossedHoles();
  [[nodiscard]] bool isCrossed(int node, int layer) const;
  void relax(int state, int start, int fromLayer, int overlapFrom);
  [[nodiscard]] double stackCost(std::size_t junctionPlace, unsigned own) const;
  [[nodiscard]] std::size_t beamIndex(int start, std::size_t length, int layer) const;
  [[nodiscard]] int stateOf(int last, int layer) const;
  [[nodiscard]] bool mayStart(int start) const;
  [[nodiscard]] bool mayEnd(int last) const;
  void extendFrom(int last, int layer);

  const layout::LayoutProblem* problem_;
  std::vector<int> allowed_;  // lengths of beams that are not fixed
  std::vector<int> lengths_;  // and of those that are
  CoverCosts costs_;

  std::vector<layout::Beam> fixed_;
  std::vector<layout::Stadium> rooms_;  // that another run takes
  std::vector<double> lengthCosts_;     // by place in allowed_, or empty
  const std::vector<int>* preferred_ = nullptr;

  // One run's working set, reused from call to call.
  int wantedReach_ = guide::kMaxLayer;
  int reach_ = guide::kMaxLayer;
  int edges_ = 0;
  bool exact_ = false;
  std::vector<double> beamCost_;    // by layer, start, length
  std::vector<double> nodeCosts_;   // by node index + 1, on one layer
  std::vector<double> plainCosts_;  // by length, on one layer
  std::vector<int> forbidden_;
  std::vector<double> value_;  // by state
  std::vector<Choice> choice_;
  std::vector<std::uint8_t> mixed_;    // by node index + 1: mechanisms may bridge an edge here
  std::vector<std::uint8_t> crossed_;  // by state: a fixed beam's hole goes another way; or empty
  std::vector<int> junctionPlaces_;    // by node index + 1: place in the lists below, or -1
  std::vector<unsigned> otherLayers_;  // layers of other beams with this axis, by place
  std::vector<double> stackWeights_;   // by place
  std::uint64_t work_ = 0;
  std::vector<unsigned> unwanted_;  // layers that are not preferred, by place
};

}  // namespace liftarm::search
