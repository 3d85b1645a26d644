#pragma once

#include <cstdint>
#include <vector>

#include "base/rng.h"
#include "layout/layout.h"
#include "search/cover_request.h"
#include "search/junction_costs.h"

namespace liftarm::search {

//! \brief What each beam that may lie on one run costs there, while all other runs stay: by first
//! node, layer and length. \details Nodes are given by their index on the run; a beam may stick out
//! past its ends by one. One object serves call after call, so that its lists stay.
class BeamPrices {
 public:
  //! \pre problem outlives this. \param lengths Allowed numbers of holes, ascending.
  BeamPrices(const layout::LayoutProblem& problem, std::vector<int> lengths, CoverCosts costs);

  //! \brief Prices every beam for a request, on layers up to `reach`. \pre junctions is prepared
  //! for it. Fixed beams are made irresistible, and what stands in their place impossible.
  void set(const layout::Layout& layout,
           const CoverRequest& request,
           int reach,
           const JunctionCosts& junctions,
           base::Rng* rng);

  //! \brief Numbers of holes, ascending: those allowed, and those of fixed beams.
  [[nodiscard]] const std::vector<int>& lengths() const { return lengths_; }

  //! \brief Prices by place in lengths().
  [[nodiscard]] const double* from(int start, int layer) const {
    return prices_.data() + index(start, 0, layer);
  }

  //! \brief What all this took, in beams looked at.
  [[nodiscard]] std::uint64_t work() const { return work_; }

 private:
  void setLengths(std::span<const layout::Beam> fixed);
  void addBlockers(const layout::Layout& layout, const CoverRequest& request);
  void addBlocker(const CoverRequest& request, const layout::Stadium& room, double cost);
  void addToBeams(int layer, int firstEnd, int lastStart, double cost);
  void addBeams(const CoverRequest& request, const JunctionCosts& junctions, base::Rng* rng);
  void addLayer(int layer, double noise, base::Rng* rng);
  void countForbidden(const CoverRequest& request, int layer);
  void setPlain(const CoverRequest& request, int layer);
  void forbidUnwanted(int run);
  void favour(std::span<const layout::Beam> fixed);
  [[nodiscard]] int allowedPlace(std::size_t length) const;

  [[nodiscard]] std::size_t index(int start, std::size_t length, int layer) const {
    return (static_cast<std::size_t>(layer + reach_) * static_cast<std::size_t>(edges_ + 2) +
            static_cast<std::size_t>(start + 1)) *
               lengths_.size() +
           length;
  }

  const layout::LayoutProblem* problem_;
  CoverCosts costs_;
  std::vector<int> allowed_;
  std::vector<int> lengths_;
  int edges_ = 0;
  int reach_ = 0;
  std::vector<double> prices_;          // by layer, start, length
  std::vector<double> nodes_;           // by node + 1, on one layer
  std::vector<double> plain_;           // by length, on one layer
  std::vector<int> forbidden_;          // by node + 2: nodes before it that are, on one layer
  std::vector<layout::Stadium> rooms_;  // that another run takes
  std::uint64_t work_ = 0;
};

}  // namespace liftarm::search
