#pragma once

#include <cstdint>
#include <vector>

#include "guide/orientation.h"
#include "layout/layout.h"

namespace liftarm::search {

//! \brief The runs that an axle may cover, and those that nothing else can. An axle follows the
//! beams that it goes through: it is laid anew whenever they have moved.
class AxleRuns {
 public:
  //! \param axles That may be laid, by index in layout::axleParts(); none: no run has one.
  //! \pre problem outlives this.
  AxleRuns(const layout::LayoutProblem& problem, std::vector<int> axles);

  [[nodiscard]] const std::vector<int>& runs() const { return runs_; }

  //! \brief Whether a joint about the run itself leaves no choice.
  [[nodiscard]] bool mustHave(int run) const { return must_[static_cast<std::size_t>(run)] != 0; }

  //! \brief Turns what such axles go through to the hole axis along them.
  void turn(guide::Orientation* orientation) const;

  //! \brief Lays the axle on a run that suits the beams which it meets.
  //! \return Whether that changed the layout.
  bool lay(layout::Layout* layout, int run) const;

  //! \brief Lays all axles anew that the layout has.
  void follow(layout::Layout* layout) const;

 private:
  const layout::LayoutProblem* problem_;
  std::vector<int> axles_;
  std::vector<int> runs_;
  std::vector<std::uint8_t> must_;  // by run
};

}  // namespace liftarm::search
