#pragma once

#include <cstdint>

#include <nlohmann/json.hpp>

namespace liftarm::cli {

//! \brief What decides between the results of several seeds.
struct Standing {
  bool buildable = false;
  int violations = 0;  //!< gaps, collisions, uncovered edges and failed connections
  int beams = 0;
  int bricks = 0;
  double objective = 0.0;
  std::uint64_t seed = 0;
};

//! \brief The standing of a report (DESIGN 4); keys that are missing count as 0.
Standing standingOf(const nlohmann::ordered_json& report);

//! \brief Whether a goes before b: buildable before not, then fewer violations, beams, bricks, then
//! the lower objective, then the lower seed. \details A total order over different seeds, so the
//! best of several does not depend on which came first. The page has the same rule
//! (web/src/solver/best-of.ts); tests/contract/best-of.json holds both to it.
bool isBetter(const Standing& a, const Standing& b);

}  // namespace liftarm::cli
