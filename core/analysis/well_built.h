#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/coverage.h"
#include "analysis/findings.h"
#include "analysis/motion.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

// What a builder leaves at most (DESIGN 5b); the figures themselves are told besides.
inline constexpr double kMostMeanLayer = 0.35;    //!< modules that beams lie off their lines
inline constexpr double kMostNakedHeads = 0.02;   //!< share of heads that sit in nothing
inline constexpr double kLeastMirrored = 0.9999;  //!< share of beams whose image is there

//! \brief A number of an item, named as in reports.
struct Figure {
  Figure(std::string named, double number) : name(std::move(named)), value(number) {}

  Figure(std::string named, int count) : name(std::move(named)), value(count) {}

  std::string name;
  double value;
};

//! \brief One item of DESIGN 5b.
struct WellBuiltItem {
  std::string id;  //!< "faithful", "stands", "stiff", "clean", "symmetric", "few"
  std::string title;
  bool ok = true;       //!< also where it does not apply
  bool applies = true;  //!< false: the drawing asks for nothing of this kind
  std::string detail;
  std::vector<Figure> figures;
  std::vector<Problem> places;  //!< where it falls short
};

//! \brief What is judged: a model with its sketch, what covers it, and how it moves.
struct WellBuiltQuery {
  const Scene& scene;
  const std::vector<EdgeCover>& coverage;
  const MotionReport& motion;
};

//! \brief How well a model is built: the six items of DESIGN 5b, in their order.
//! \details Written against the placed parts and the sketch alone, as the checks of DESIGN 5 are.
//! It decides nothing: a model may be buildable and fall short of all six.
std::vector<WellBuiltItem> judgeWellBuilt(const WellBuiltQuery& query);

}  // namespace liftarm::analysis
