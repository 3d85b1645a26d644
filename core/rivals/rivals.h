#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "layout/layout.h"
#include "search/layout_search.h"
#include "search/paper_search.h"

namespace liftarm::rivals {

//! \brief What the rivals are given: the sketch's layout problem, and the brick set, weights and
//! temperatures of the paper's method, on whose framework they stand.
struct RivalOptions {
  search::PaperOptions paper;
  double effort = 1.0;  //!< times the usual number of iterations
};

//! \brief The methods with which \cite xu_2019_computational compares its own (section 6 and the
//! discussion in 5.3), by the name that `--method` takes. \details Each head of a file here says
//! how the paper was read. All use the paper's stage one, its placements and its layers, look for
//! fewest faults, then fewest beams, and join the beams of their best layout at the end, where the
//! paper does not say that they connect while they search. Not part of the WebAssembly module
//! that a page loads first, which has no room for them: there, no method has a name.
[[nodiscard]] std::vector<std::string_view> rivalNames();

//! \return The search of that name, or none. \pre problem and solver outlive it.
[[nodiscard]] std::unique_ptr<search::LayoutSearch> makeRival(std::string_view name,
                                                              const layout::LayoutProblem& problem,
                                                              layout::ConnectionSolver& solver,
                                                              RivalOptions options);

//! \brief The cooling schedules that the paper's method knows besides the exponential one.
[[nodiscard]] std::vector<std::string_view> scheduleNames();

//! \return The schedule of that name; empty for "exponential" and for names unknown.
[[nodiscard]] search::MakeCooling coolingOf(std::string_view name);

//! \brief The size n of a problem, after which the paper's random method takes its time: an n by n
//! grid has 2 (n + 1) straight runs, so any sketch has the size of the grid with as many.
[[nodiscard]] int problemSize(const layout::LayoutProblem& problem);

}  // namespace liftarm::rivals
