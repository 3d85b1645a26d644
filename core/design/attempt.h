#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "design/settings.h"
#include "layout/layout.h"
#include "mechanisms/mechanism_table.h"
#include "search/layout_search.h"
#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief What a search wishes for that the sketch does not ask: tried first, given up where no
//! whole layout was found with it.
struct Wishes {
  bool standing = false;   //!< nothing below the lowest drawn plane (DESIGN 5b.2)
  bool symmetric = false;  //!< the drawing's own symmetries are kept (design/alikeness.h)
  int only = -1;           //!< the one of these that is kept; negative: all
  bool mostly = false;     //!< what stays loose as it is need not be symmetric
};

//! \brief The sketch with what is wished for written into it: its ground half a module below its
//! lowest end point, and the mirrors that it has. What it says itself stays.
sketch::Sketch withWishes(const sketch::Sketch& sketch, Wishes wishes);

//! \brief The searches for one sketch, one after the other: with every wish of the settings, then
//! with fewer, until a layout is whole.
//! \details Two mirrors at once leave few layouts: where the best of these is loose, or takes many
//! more beams than are needed (bent beams across a mirror and frames obey none), it is compared
//! with those that keep one mirror, with one that is symmetric but for what would be loose, and
//! with one that keeps none; being symmetric is worth a part of the objective.
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

  [[nodiscard]] const mechanisms::MechanismTable& table() const { return table_; }

 private:
  struct Attempt;

  void goOn();
  void begin(Wishes wishes, bool last);
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
  std::uint64_t iterationsBefore_ = 0;
  std::uint32_t improvementsBefore_ = 0;
  double left_ = 1.0;  // of the fraction when the present search began
  double fraction_ = 0.0;
  bool done_ = false;
};

}  // namespace liftarm::design
