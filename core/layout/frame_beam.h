#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lattice/vec.h"
#include "parts/catalogue.h"

namespace liftarm::layout {

//! \brief One straight bar of a frame: nodes one module apart.
struct FrameBar {
  lattice::Vec3 from;       //!< first node, part frame
  lattice::Vec3 direction;  //!< unit vector from there, part frame
  int nodes = 0;            //!< at most 32
  std::uint32_t crossed =
      0;  //!< bit i: the hole of node i goes across the bar in the frame's plane
};

//! \brief Where two bars of a frame cross or meet in a corner.
struct FrameCrossing {
  int barA = 0;
  int nodeA = 0;
  int barB = 0;
  int nodeB = 0;
};

//! \brief A beam of three or more straight bars in one plane, on two directions at right angles.
//! Its holes go along the plane's normal, or across their bar in the plane; the normal is the cross
//! product of the directions of the first crossing's bars, up to sign.
struct FrameBeam {
  std::string part;  //!< LDraw number
  std::vector<FrameBar> bars;
  std::vector<FrameCrossing> crossings;  //!< at least one
};

//! \brief The frames among some parts: full thickness, each bar of the solid a stretch that covers,
//! a round hole at each node.
std::vector<FrameBeam> frameBeamsOf(const std::vector<parts::Part>& parts);

//! \brief Those of the built-in catalogue, by LDraw number.
const std::vector<FrameBeam>& frameBeams();

//! \brief Index in frameBeams(), or -1.
int frameBeamIndex(const std::string& part);

//! \brief All indices of frameBeams(), ascending.
std::vector<int> allFrameBeams();

}  // namespace liftarm::layout
