#pragma once

#include <memory>
#include <vector>

#include "analysis/frame.h"

namespace liftarm::analysis {

//! \brief Solves a frame again and again with other contacts.
//! \details Sparse LDLT (Eigen) of the stiffness scaled to a unit diagonal; one ordering for all
//! factorisations. Refers to the frame, which must outlive it unchanged.
class FrameSolver {
 public:
  explicit FrameSolver(const Frame& frame);
  ~FrameSolver();
  FrameSolver(const FrameSolver&) = delete;
  FrameSolver& operator=(const FrameSolver&) = delete;

  //! \brief Puts in the contacts that are on. \param active One per contact of the frame.
  //! \return False when the frame can move without resistance: then motion() tells how.
  bool prepare(const std::vector<bool>& active);

  //! \brief Displacements of all nodes under loads on nodes. \pre the last prepare() was true.
  [[nodiscard]] std::vector<Six> solve(const std::vector<Six>& loads) const;

  //! \brief A motion that nothing resists, greatest translation 1 mm. Where there are several it is
  //! some mixture of them. \pre the last prepare() was false.
  [[nodiscard]] std::vector<Six> motion() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace liftarm::analysis
