#pragma once

#include <array>
#include <string>
#include <vector>

#include "lattice/vec.h"
#include "layout/beam.h"
#include "parts/catalogue.h"

namespace liftarm::layout {

//! \brief One arm of a bent beam, seen from its corner.
struct BentArm {
  lattice::Vec3 direction;  //!< unit vector from the corner, part frame
  int holes = 0;            //!< round holes, corner included
  int behind = 0;           //!< of these: on the other side of the corner (the bar of a T)
  bool tail = false;        //!< whether an axle hole follows the last round one

  //! \brief The arm on a run. \param corner Node index of the bend. \param way 1: the arm's
  //! direction is the run's, -1: the opposite.
  [[nodiscard]] Beam laidAt(int corner, int way, int layer) const {
    Beam beam{way > 0 ? corner - behind : corner + behind - holes + 1, holes, layer};
    beam.tail = tail ? way : 0;
    return beam;
  }
};

//! \brief A beam of two arms in one plane: an L, a T, or bent by 53.13 degrees as in a 3-4-5
//! triangle.
struct BentBeam {
  std::string part;      //!< LDraw number
  lattice::Vec3 corner;  //!< centre of the hole that both arms have, part frame
  std::array<BentArm, 2> arms;
  double cosine = 0.0;  //!< of the angle between the arms' directions
};

//! \brief Whether the arms of a bent beam with this cosine can lie along these unit vectors.
bool bendsAlong(const BentBeam& bent, lattice::Vec3 first, lattice::Vec3 second);

//! \brief Where the part is when its corner is at a point and its arms lie along two unit vectors.
//! \pre bendsAlong(bent, first, second).
lattice::Pose poseOf(const BentBeam& bent,
                     lattice::Vec3 corner,
                     lattice::Vec3 first,
                     lattice::Vec3 second);

//! \brief The arms of bent beams and the bars of frames in a cover.
std::vector<Beam> armsOf(const Cover& cover);

//! \brief Whether there are any.
bool hasArms(const Cover& cover);

//! \brief One way in which a bent beam lies on two runs.
struct Bend {
  Beam arm;             //!< on the one run
  Beam mateArm;         //!< on the other
  lattice::Vec3 first;  //!< world directions of the bent beam's arms, for poseOf
  lattice::Vec3 second;
};

//! \brief Adds every way in which bentBeams()[form] can lie on two runs that meet. Arms may stick
//! out past a run's ends by one module.
//! \pre The runs' hole axes are the same.
void addBends(const guide::GuidingGraph& graph,
              int form,
              int run,
              int mate,
              int layer,
              std::vector<Bend>* bends);

//! \brief The bent beams among some parts: full thickness, all holes parallel, two arms that share
//! a round hole. Others (frames, 32009, whose arms do not meet in a hole) are left out.
std::vector<BentBeam> bentBeamsOf(const std::vector<parts::Part>& parts);

//! \brief Those of the built-in catalogue, by LDraw number.
const std::vector<BentBeam>& bentBeams();

//! \brief Index in bentBeams(), or -1.
int bentBeamIndex(const std::string& part);

//! \brief All indices of bentBeams(), ascending.
std::vector<int> allBentBeams();

}  // namespace liftarm::layout
