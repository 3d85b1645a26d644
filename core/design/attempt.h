#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "design/crowded_place.h"
#include "design/settings.h"
#include "design/wishes.h"
#include "layout/keeps.h"
#include "layout/layout.h"
#include "mechanisms/mechanism_table.h"
#include "search/layout_search.h"
#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief What a search for a sketch under these settings works on.
layout::LayoutProblem problemOf(const sketch::Sketch& sketch, const Settings& settings);

//! \brief Whether nothing is violated and no part is missing.
bool isWhole(const search::LayoutSnapshot& layout);

//! \brief The searches for one sketch, one after the other: with every wish of the settings, then
//! with fewer, until a layout is whole.
//! \details Two mirrors at once leave few layouts: where the best of these is loose, or takes many
//! more beams than are needed (bent beams across a mirror and frames obey none), it is compared
//! with those that keep one mirror, with one that is symmetric but for what would be loose, and
//! with one that keeps none; being symmetric is worth a part of the objective. A search
//! that does not end whole is followed by a look at the nodes where it failed, each alone: what
//! cannot be joined there is said at once, in place of further searches. Where a node has all lines
//! and the look joins them, that search comes next. Where nothing is found to be at fault, a few
//! more searches with other seeds follow the plans. All searches together take no more than
//! AnnealingOptions::mostWork, more for very large sketches.
class Attempts {
 public:
  //! \pre sketch and settings outlive this.
  Attempts(const sketch::Sketch& sketch, const Settings& settings);
  ~Attempts();
  Attempts(const Attempts&) = delete;
  Attempts& operator=(const Attempts&) = delete;

  //! \brief At most `iterations` steps. \return True when the last search has ended.
  bool advance(std::uint32_t iterations);

  [[nodiscard]] bool done() const;

  //! \brief Of all searches.
  [[nodiscard]] std::uint64_t iterations() const;

  //! \brief From 0 to 1, never less than before: each search has half of what is left.
  [[nodiscard]] double fraction() const;

  //! \brief How often the best layout changed, over all searches.
  [[nodiscard]] std::uint32_t improvements() const;

  //! \brief The search that is going on, or that found the best layout.
  [[nodiscard]] const search::LayoutSearch& search() const;

  [[nodiscard]] const layout::LayoutProblem& problem() const;

  //! \brief Of the best of the searches that have ended: how many ways it can move beyond the
  //! joints, also where that search ended before it asked. 0 for presets that do not ask.
  [[nodiscard]] int freedoms() const;

  //! \brief The place that no layout was found for, where that is why there is none.
  [[nodiscard]] const std::optional<CrowdedPlace>& crowded() const { return crowded_; }

  //! \brief What the sketch keeps and leaves it without a whole layout, if that was found.
  [[nodiscard]] const std::optional<layout::KeepFault>& blamed() const { return blamed_; }

  [[nodiscard]] const mechanisms::MechanismTable& table() const { return table_; }

 private:
  struct Attempt;

  void goOn();
  void begin(Wishes wishes, bool last);
  void findReason();
  void findCrowdedPlace();
  void lookAt(const std::vector<lattice::Vec3>& places, double radius, std::size_t fewest);
  void planMoreSeeds();
  void planBetterSeed();
  void planOtherPrices();
  [[nodiscard]] double workLeft() const;
  void judge(Attempt* attempt) const;
  [[nodiscard]] const Attempt& shown() const;
  [[nodiscard]] bool isGoodEnough(const Attempt& attempt) const;
  void dropNeedlessPlans();

  const sketch::Sketch* sketch_;
  const Settings* settings_;
  mechanisms::MechanismTable table_;
  std::vector<sketch::Symmetry> symmetries_;  // that are wished for
  std::vector<Wishes> plans_;                 // those still to come, the next one last
  std::unique_ptr<Attempt> current_;
  std::unique_ptr<Attempt> best_;  // whole, of those that have ended
  std::optional<CrowdedPlace> crowded_;
  std::optional<layout::KeepFault> blamed_;
  std::vector<std::pair<double, lattice::Vec3>> looked_;  // radius and place of every look
  std::uint32_t moreSeeds_ = 0;                           // searches beyond the plans
  std::uint32_t betterSeeds_ = 0;                         // where the best one is not well built
  int otherPrices_ = 0;                                   // searches with other prices
  bool wholeAlone_ = false;                               // a look found a layout of all lines
  std::uint64_t iterationsBefore_ = 0;
  double workBefore_ = 0.0;  // of searches that ended
  std::uint32_t improvementsBefore_ = 0;
  double left_ = 1.0;  // of the fraction when the present search began
  double fraction_ = 0.0;
  bool done_ = false;
};

}  // namespace liftarm::design
