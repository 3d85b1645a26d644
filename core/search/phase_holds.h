#pragma once

#include <vector>

#include "layout/connection_solver.h"
#include "search/phase.h"

namespace liftarm::search {

//! \brief The last phase: where something of a whole layout moves that should not, a further
//! mechanism between bodies that move against each other holds it, as a builder adds a second
//! connector. \details All that fit beside what is there are held against what they are worth; the
//! best is added where the model can still be built, and again, until nothing moves or none helps.
class FurtherHolds final : public Phase {
 public:
  using Phase::Phase;

  Next begin() override;

  Next endRound() override { return EndOfSearch{}; }

 private:
  struct Hold {
    int junction = -1;
    layout::FurtherJoin join;
    int freedoms = 0;  // with it
  };

  [[nodiscard]] std::vector<Hold> find();
  bool ask(const LayoutSnapshot& layout, Hold* hold);
  [[nodiscard]] double savedBy(const Hold& hold) const;
  bool improve();
  void addAll(const std::vector<Hold>& found);
  bool accept();

  int freedoms_ = 0;   // of the layout
  int checks_ = 0;     // of all that makes a model buildable
  double work_ = 0.0;  // counts of freedoms, times parts
};

}  // namespace liftarm::search
