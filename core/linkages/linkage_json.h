#pragma once

#include <string>
#include <string_view>

#include "base/status.h"
#include "linkages/linkage_sketch.h"
#include "linkages/linkage_table.h"

namespace liftarm::linkages {

//! \brief A drawn path with what is asked of it.
struct PathDrawing {
  PathQuestion question;
  PathPlane plane;
};

//! Limits of what is read.
inline constexpr std::size_t kMaxPathBytes = 1U << 20U;
inline constexpr std::size_t kMaxPathPoints = 5000;
inline constexpr double kMaxPathCoordinate = 1000.0;  // modules
inline constexpr int kMaxAnswers = 24;

//! \brief Reads {"format": "technic-path", "version": 1, "points": [[x, y, z], ...], "closed":
//! true, "kind": "any" | "foot" | "line", "turns": "any" | "quarter", "plane": "x" | "y" | "z"
//! (across which it lies), "most": 6}; all but the first three may be left out. A line's path is
//! open, a foot's closed.
base::Result<PathDrawing> readPath(std::string_view text);

//! \brief The best linkages for a path as {"closed", "plane", "offset", "drawn": [[u, v] ...],
//! "answers": [{"error", "largest": millimetres, "transmission": degrees, "links": [crank, coupler,
//! rocker, frame], "pivots": [[u, v], [u, v]], "poses": [[crank's pin u, v, rocker's pin u, v,
//! point u, v] ...] over one turn, "sketch": a sketch (DESIGN 3)}]}. \pre table is whole.
base::Result<std::string> linkagesJson(const LinkageTable& table, std::string_view pathText);

}  // namespace liftarm::linkages
