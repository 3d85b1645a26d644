#pragma once

#include <array>
#include <vector>

#include "linkages/plane.h"

namespace liftarm::linkages {

//! \brief A beam that can be a coupler: one straight one, or one bent at a corner.
//! \details Holes are numbered along the first arm to the corner and on along the second. The
//! round holes only: an axle hole at an arm's end holds no pin.
struct CouplerBeam {
  int first = 0;         //!< unit edges of the first arm; all of them where it is straight
  int second = 0;        //!< unit edges of the second arm; 0: straight
  double cosine = -1.0;  //!< of the angle between the arms, seen from the corner
};

//! \brief The bent beams of the catalogue that have two arms of round holes: L of 3 by 5 and 2 by
//! 4, and those bent by 53.13 degrees, of 4 by 6, 3 by 7 and 4 by 4.
inline constexpr std::array<CouplerBeam, 5> kBentCouplers{
    {{4, 2, 0.0}, {2, 1, 0.0}, {4, 2, -0.6}, {5, 1, -0.6}, {2, 2, -0.6}}};

//! \brief A coupler: which holes of which beam are the crank's pin, the rocker's pin and the point
//! that draws.
struct Coupler {
  CouplerBeam beam;
  int side = 1;  //!< of a bent one: which way it bends; a mirror image has -1
  int crankHole = 0;
  int rockerHole = 0;
  int pointHole = 0;
  // What follows from them.
  double length = 0.0;  //!< from pin to pin
  Point point;          //!< in the frame whose u axis leads from the crank's pin to the rocker's
};

//! \brief The hole of a coupler's beam in the beam's own frame: the corner (of a straight one: its
//! first hole) is the origin.
Point holeOf(const CouplerBeam& beam, int side, int hole);

//! \brief All couplers of straight beams up to so many edges and of bent beams, each once up to
//! reversal: crankHole, rockerHole and pointHole are three holes.
std::vector<Coupler> allCouplers(int mostEdges);

//! \brief A four-bar: crank and rocker of whole length on pivots a whole distance apart.
struct FourBar {
  int crank = 1;
  int rocker = 1;
  int frame = 1;
  Coupler coupler;
};

//! \brief Where its pins are: the crank's pivot is the origin, the rocker's lies at (frame, 0).
struct FourBarPose {
  Point crankPin;
  Point rockerPin;
  Point point;
};

//! \brief The pose in closed form: the rocker's pin is where two circles meet, on the left of the
//! way from the crank's pin to the rocker's pivot (Freudenstein's equation, solved by geometry).
//! \param turn Unit vector along the crank. \pre isCrankRocker(bar).
FourBarPose poseOf(const FourBar& bar, Point turn);

//! \brief Whether the crank goes round (Grashof's rule with the crank the shortest, strictly).
bool isCrankRocker(int crank, double coupler, int rocker, int frame);

//! \brief Cosine of the smallest angle between coupler and rocker, 0 to 90 degrees, over a turn: it
//! is reached where the crank lies along the frame. \pre isCrankRocker.
double transmissionCosine(int crank, double coupler, int rocker, int frame);

//! \brief Whether beams of crank and rocker, which share a layer, pass each other all the way. A
//! link whose length is none of a beam may stick out a module past its pin.
bool crankPassesRocker(int crank, double coupler, int rocker, int frame);

//! \brief Limits of the table of linkages. Whole modules and degrees.
struct FourBarLimits {
  int mostCrank = 6;
  int mostRocker = 12;
  int mostFrame = 14;
  int mostCoupler = 14;           //!< edges of a straight coupler
  double leastTransmission = 30;  //!< degrees
};

//! \brief Lengths that satisfy the limits with a coupler of this length: (crank, rocker, frame).
std::vector<std::array<int, 3>> crankRockers(double coupler, const FourBarLimits& limits);

//! \brief Unit vectors around the circle, from base/det_math.
std::vector<Point> turnsOf(int count);

}  // namespace liftarm::linkages
