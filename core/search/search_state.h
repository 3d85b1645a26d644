#pragma once

#include <cstdint>
#include <vector>

#include "base/rng.h"
#include "layout/layout.h"
#include "search/annealing_options.h"
#include "search/covering.h"
#include "search/energy.h"
#include "search/frame_places.h"
#include "search/layout_search.h"
#include "search/move_clock.h"

namespace liftarm::search {

//! \brief What phases and moves of the search work on: the layout as it is, the best one, the
//! random numbers, and what lays and judges covers. Phases own all else that they need.
class SearchState {
 public:
  //! \pre problem and solver outlive the state. The options are never written to.
  SearchState(const layout::LayoutProblem& problem,
              layout::ConnectionSolver& solver,
              AnnealingOptions options);

  SearchState(const SearchState&) = delete;
  SearchState& operator=(const SearchState&) = delete;

  [[nodiscard]] const layout::LayoutProblem& problem() const { return *problem_; }

  [[nodiscard]] const guide::GuidingGraph& graph() const { return problem_->graph; }

  [[nodiscard]] const AnnealingOptions& options() const { return options_; }

  [[nodiscard]] base::Rng& rng() { return rng_; }

  [[nodiscard]] MoveClock& clock() { return clock_; }

  [[nodiscard]] const MoveClock& clock() const { return clock_; }

  // The layout as it is.

  [[nodiscard]] layout::Layout& layout() { return layout_; }

  [[nodiscard]] const layout::Layout& layout() const { return layout_; }

  [[nodiscard]] const layout::Cover& coverOf(int run) const { return layout_.run(run).cover; }

  [[nodiscard]] Covering& covering() { return covering_; }

  [[nodiscard]] const Covering& covering() const { return covering_; }

  [[nodiscard]] const FramePlaces& frames() const { return frames_; }

  void place(int run, const layout::Cover& cover) { covering_.place(&layout_, run, cover); }

  //! \brief Covering::cover() on the layout.
  bool cover(const CoverRequest& request) { return covering_.cover(request, &layout_, &rng_); }

  //! \brief Puts a layout back as it was.
  void restore(const LayoutSnapshot& layout) { layout_.restore(layout.covers, layout.junctions); }

  //! \brief No place weighs more than others any longer.
  void forgetGrudges();

  //! \brief Places that stay violated gain weight, the others lose it.
  void raiseGrudges();

  [[nodiscard]] LayoutSnapshot snapshot() const;

  // Its energy.

  //! \brief The energy of the layout as it lies. \pre It is settled, or being settled.
  [[nodiscard]] double measure();

  //! \brief Takes the layout for the one that moves are compared with.
  void accept() { energy_ = measure(); }

  //! \brief The energy of the layout that was accepted last.
  [[nodiscard]] double energy() const { return energy_; }

  //! \brief Parts beyond those owned, of the layout that was measured last.
  [[nodiscard]] int missing() const { return missing_; }

  [[nodiscard]] const Energy& judge() const { return judge_; }

  //! \brief Freedoms of the layout, while somebody asks for them; each counts what it costs.
  [[nodiscard]] int freedoms() const { return freedoms_; }

  void setFreedoms(int freedoms) { freedoms_ = freedoms; }

  void setFreedomCost(double cost) { judge_.setFreedomCost(cost); }

  // The best one.

  [[nodiscard]] const LayoutSnapshot& best() const { return best_; }

  [[nodiscard]] std::uint32_t improvements() const { return improvements_; }

  //! \brief Whether the layout is better than another: fewer violations, then fewer parts missing
  //! (a whole model with parts to buy says more than one that falls apart for want of them), then
  //! less energy. \pre measure() saw it last.
  [[nodiscard]] bool beats(const LayoutSnapshot& other) const;

  //! \brief snapshot() with all that beats() looks at.
  [[nodiscard]] LayoutSnapshot ratedSnapshot() const;

  void setBest(LayoutSnapshot best);

  //! \brief Says anew what the best layout is worth.
  void rateBest(int freedoms, double energy);

  //! \brief Keeps the layout as the best one where it is.
  void keepBest();

  //! \brief Whether the best layout has no violations and lacks no parts.
  [[nodiscard]] bool hasWhole() const { return best_.faultless(); }

  //! \brief Whether a layout can be built in earnest (AnnealingOptions::buildable).
  [[nodiscard]] bool isBuildable(const LayoutSnapshot& layout) const;

  // The search as a whole.

  //! \brief Whether the layout came from that of an earlier sketch.
  [[nodiscard]] bool grown() const { return grown_; }

  void setGrown() { grown_ = true; }

  //! \brief Takes frames back where the best layout has some and cannot be built.
  //! \return Whether it did: then the search is to start over.
  bool withdrawFrames();

  //! \brief Begins as if nothing had been searched. What was withdrawn stays so.
  void startOver();

  //! \brief What the search took so far, in about nanoseconds, but counted.
  [[nodiscard]] double work() const;

  [[nodiscard]] bool isOverworked() const;

 private:
  const layout::LayoutProblem* problem_;
  const layout::ConnectionSolver* solver_;
  const AnnealingOptions options_;
  base::Rng rng_;
  MoveClock clock_;
  layout::Layout layout_;
  Covering covering_;
  FramePlaces frames_;
  Energy judge_;
  double energy_ = 0.0;
  int missing_ = 0;
  int freedoms_ = 0;
  LayoutSnapshot best_;
  std::uint32_t improvements_ = 0;
  bool grown_ = false;
};

}  // namespace liftarm::search
