#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace liftarm::gears {

//! \brief Where a shaft crosses the plane across it, modules on the lattice.
struct Place {
  int u = 0;
  int v = 0;

  friend bool operator==(Place a, Place b) { return a.u == b.u && a.v == b.v; }

  friend Place operator+(Place a, Place b) { return {a.u + b.u, a.v + b.v}; }

  friend Place operator-(Place a, Place b) { return {a.u - b.u, a.v - b.v}; }
};

//! \brief What turns at a place: all within `radius` of it, in one slot of the shafts or in all.
struct Disc {
  Place at;
  std::optional<int> plane;  //!< none: an axle, which goes through all
  double radius = 0.0;       //!< modules
};

//! \brief A gear on a shaft of a train. Planes are slots of the shafts, counted from 0.
struct TrainGear {
  int shaft = 0;
  int plane = 0;
  int teeth = 0;
};

//! \brief Parallel shafts, each of which drives the next one.
struct Train {
  std::vector<Place> shafts;
  //! From shaft to shaft: two that follow on each other mesh where they are not on one shaft.
  std::vector<TrainGear> gears;
  double ratio = 1.0;  //!< turns of the first shaft for one turn of the last

  //! \brief Whether first and last shaft turn against each other.
  [[nodiscard]] bool reverses() const { return shafts.size() % 2 == 0; }
};

//! \brief What a train has to do.
struct TrainRequest {
  Place from;
  Place to;
  double ratio = 1.0;       //!< turns of the first shaft for one turn of the last, positive
  double tolerance = 0.03;  //!< share of the ratio that it may be off
  int planes = 4;           //!< slots between the bearings
  std::vector<int> teeth;   //!< of the gears that there are, ascending
  //! Whether a shaft between the two may stand there. Empty: anywhere.
  std::function<bool(Place)> bears = nullptr;
  //! Whether there is room for a gear. Empty: everywhere.
  std::function<bool(const Disc&)> clear = nullptr;
  //! What turns there already, the axles at `from` and `to` left out.
  std::vector<Disc> taken = {};
};

//! Most shafts of a train.
inline constexpr int kMostShafts = 13;

//! \brief The train with the fewest parts that couples two parallel shafts.
//! \details A train is a row of chains: in a chain each gear meshes with the next in one plane, and
//! those between its ends change no ratio; two chains meet on a shaft that carries a gear of both.
//! All chains but the last have two gears. Fewest shafts first, then fewest gears, then the ratio
//! that is least off, then the lowest planes; nothing collides, however it turns. Exhaustive
//! within five chains of which the last one goes no way back.
//! \return Nothing where there is none. \pre from and to differ; ratio and tolerance are positive.
std::optional<Train> findTrain(const TrainRequest& request);

}  // namespace liftarm::gears
