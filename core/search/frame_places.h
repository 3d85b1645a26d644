#pragma once

#include <vector>

#include "layout/layout.h"
#include "search/annealing_options.h"

namespace liftarm::search {

//! \brief Where moves may lay frames: sites where a frame and what its runs need beside it are
//! fewer beams than these runs need without. Where there is none the search draws no random number
//! for frames.
class FramePlaces {
 public:
  FramePlaces(const layout::LayoutProblem& problem, const AnnealingOptions& options);

  //! \brief Places in LayoutProblem::sites.
  [[nodiscard]] const std::vector<int>& useful() const { return useful_; }

  //! \brief Takes back what a layout that does not come apart may owe to frames: at first the holes
  //! across their bars, then all frames.
  void withdraw(layout::Layout* layout);

 private:
  std::vector<int> useful_;
  bool across_ = true;  // whether holes across their bars may be used
};

//! \brief Whether a layout has a frame.
bool hasFrame(const LayoutSnapshot& layout);

}  // namespace liftarm::search
