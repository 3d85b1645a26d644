#pragma once

#include <cstdint>
#include <vector>

#include "layout/layout.h"

namespace liftarm::search {

//! \brief A whole layout as it can be kept and put back.
struct LayoutSnapshot {
  std::vector<layout::Cover> covers;
  std::vector<layout::JunctionState> junctions;
  layout::Tallies tallies;
  double energy = 0.0;
  int freedoms = 0;  //!< where the search asked for them: see AnnealingOptions::freedoms
  int missing = 0;   //!< parts that it needs beyond those owned (search/supply.h)

  //! \brief Whether it has no violations and lacks no parts; true of an empty one.
  [[nodiscard]] bool faultless() const { return tallies.violations() + missing == 0; }
};

//! \brief A stepped, deterministic search for a layout: what every method offers (DESIGN 4,
//! --method).
class LayoutSearch {
 public:
  virtual ~LayoutSearch() = default;

  //! \brief At most `iterations` moves. \return True when the search has ended.
  virtual bool advance(std::uint32_t iterations) = 0;

  [[nodiscard]] virtual bool done() const = 0;

  //! \brief The best layout so far; without covers before the first step.
  [[nodiscard]] virtual const LayoutSnapshot& best() const = 0;

  //! \brief How often the best layout changed.
  [[nodiscard]] virtual std::uint32_t improvements() const = 0;

  [[nodiscard]] virtual std::uint64_t iterations() const = 0;

  [[nodiscard]] virtual double temperature() const = 0;

  //! \brief What it took so far, in about nanoseconds, but counted: what two machines do alike.
  [[nodiscard]] virtual double work() const { return 0.0; }

  //! \brief From 0 to 1: how much of the search is done, as far as can be told.
  [[nodiscard]] virtual double fraction() const = 0;

  //! \brief Whether the best layout came from that of an earlier sketch.
  [[nodiscard]] virtual bool grown() const { return false; }

  //! \brief "stageOne" until the first layout is there, then "stageTwo", then "done".
  [[nodiscard]] virtual const char* phase() const = 0;
};

}  // namespace liftarm::search
