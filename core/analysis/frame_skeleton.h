#pragma once

#include <vector>

#include "parts/catalogue.h"

namespace liftarm::analysis {

//! \brief What a stretch of a part is made of.
enum class StretchKind { kBody, kPin, kAxle };

//! \brief A straight stretch between two points of a skeleton.
struct SkeletonEdge {
  int a = -1;
  int b = -1;
  StretchKind kind = StretchKind::kBody;
  lattice::Vec3 up;    //!< axis of the holes, part frame
  double width = 7.2;  //!< bodies: across, mm
  double depth = 8.0;  //!< bodies: along the holes, mm
};

//! \brief A part as points and stretches: a connected graph whose points are the middles of all
//! slots and the ends of all arms.
struct Skeleton {
  std::vector<lattice::Vec3> points;          //!< part frame, modules
  std::vector<std::vector<int>> pointOfSlot;  //!< by feature and slot
  std::vector<SkeletonEdge> edges;
};

//! \brief Finds a part's skeleton from its catalogue data.
//! \details Points on an arm of the body are chained along it, slots of one feature along their
//! axis; what is still apart is joined by the shortest stretches. A stretch that ends in a head is
//! pin or axle, any other body.
Skeleton skeletonOf(const parts::Part& part);

//! \brief Drops the points that only lengthen a straight stretch, as far as `keep` allows. Point
//! numbers stay; dropped ones have no edge.
void simplify(Skeleton& skeleton, const std::vector<bool>& keep);

}  // namespace liftarm::analysis
