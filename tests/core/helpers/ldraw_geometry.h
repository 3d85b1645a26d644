#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::testing {

//! \brief The corners of one triangle, in the part's own frame (ours), modules.
using Triangle = std::array<lattice::Vec3, 3>;

//! \brief Reads parts of ../shared/ldraw with all their subfiles. Quads count as two triangles;
//! lines and winding are left out.
class LdrawGeometry {
 public:
  //! \return Empty when the library has no such part or one of its subfiles is missing.
  std::vector<Triangle> part(const std::string& id);

 private:
  std::map<std::string, std::vector<std::string>> files_;
};

//! \brief Least distance from the line through `center` along `axis` to the triangle, looked at
//! only where the triangle lies within `reach` of `center` along the axis. \return 1e9 where there
//! is none of it.
double distanceToAxis(const Triangle& triangle,
                      lattice::Vec3 center,
                      lattice::Vec3 axis,
                      double reach);

}  // namespace liftarm::testing
