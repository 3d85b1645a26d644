#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/constraints.h"
#include "analysis/constraints_screws.h"

namespace liftarm::analysis {

//! \brief Moves a linkage with one freedom for real, not at the first order only.
//! \details The bodies hang on a tree of links; each other link closes a loop, and the loops are
//! closed after each step by Newton's method on the angles of the tree (least squares, so that
//! redundant loops do no harm).
class KinematicChain {
 public:
  //! \param linkage Every link turns. \param driver Turns only; added to the links, and its angle
  //! is what the motion is asked for. \param base The body that rests. Where no links lead from it
  //! to the driver, nothing moves. \param slack What the play of the pins lets a loop be open by
  //! where its lengths do not quite close, modules and radians.
  KinematicChain(const Linkage& linkage, const Link& driver, int base, double slack = 0.0);

  //! \brief Brings the driver to an angle in radians from the start.
  //! \return False where the loops cannot be closed there without a jump: a dead point. Then
  //! nothing has moved.
  bool moveTo(double angle);

  //! \brief Where each body is: start place -> present place.
  [[nodiscard]] const std::vector<lattice::Pose>& poses() const { return poses_; }

 private:
  //! One angle or shift of the tree.
  struct Variable {
    int link = 0;
    int parent = 0;
    int child = 0;
    double sign = 1.0;  // of the link's own direction
    bool shifts = false;
    double value = 0.0;
    double start = 0.0;                         // of the present move
    std::optional<double> rate = std::nullopt;  // per radian of the driver, over the move before
  };

  void growTree(int base);
  void addVariables(int link, int parent, int child);
  void place();
  [[nodiscard]] Twist screwOf(const Variable& variable) const;
  bool closeLoops();
  double improve(const std::vector<double>& errors);
  [[nodiscard]] std::vector<double> loopErrors() const;
  [[nodiscard]] bool jumped() const;
  [[nodiscard]] bool isSmooth(double turn) const;

  Linkage linkage_;  // the driver first
  double unit_ = 1.0;
  double slack_ = 0.0;
  std::vector<Variable> variables_;              // parents first
  std::vector<std::vector<std::size_t>> above_;  // per body: variables on its way from the base
  std::vector<int> loops_;                       // links outside the tree
  std::optional<std::size_t> driver_;            // variable; none where the tree lacks the driver
  std::vector<lattice::Pose> poses_;
};

}  // namespace liftarm::analysis
