#pragma once

#include <vector>

#include "analysis/frame.h"
#include "analysis/frame_solver.h"

// Header only: tests of analysis use it, and helpers link no level.

namespace liftarm::testing {

//! \brief Holds a node in all six directions, hard enough to count as fixed.
inline void fix(analysis::Frame& frame, int node, analysis::Six stiffness) {
  analysis::FrameSpring spring;
  spring.a = node;
  spring.at = frame.nodes[static_cast<std::size_t>(node)];
  spring.stiffness = stiffness;
  frame.springs.push_back(spring);
}

inline void clamp(analysis::Frame& frame, int node) {
  constexpr double kHard = 1e12;
  fix(frame, node, {kHard, kHard, kHard, kHard, kHard, kHard});
}

//! \brief A straight chain of equal bars from `from` to `to`.
inline analysis::Frame chain(lattice::Vec3 from,
                             lattice::Vec3 to,
                             int bars,
                             const analysis::Section& section) {
  analysis::Frame frame;
  frame.sections = {section};
  for (int i = 0; i <= bars; ++i) {
    frame.nodes.push_back(from + (static_cast<double>(i) / bars) * (to - from));
  }
  for (int i = 0; i < bars; ++i) {
    analysis::FrameElement bar;
    bar.a = i;
    bar.b = i + 1;
    bar.up = {0, 0, 1};
    frame.elements.push_back(bar);
  }
  frame.loads.assign(frame.nodes.size(), analysis::Six{});
  return frame;
}

//! \return Displacements under the frame's own loads. Empty where it is a mechanism.
inline std::vector<analysis::Six> solved(const analysis::Frame& frame) {
  analysis::FrameSolver solver(frame);
  if (!solver.prepare(std::vector<bool>(frame.contacts.size(), true))) {
    return {};
  }
  return solver.solve(analysis::nodalLoads(frame));
}

}  // namespace liftarm::testing
