#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "guide/guiding_graph.h"
#include "lattice/vec.h"
#include "layout/axle.h"
#include "layout/stadium.h"

namespace liftarm::layout {

//! \brief A beam in use on a run: round holes at the run's nodes start .. start + holes - 1. It may
//! stick out past the run's ends by one module. It may be one arm of a bent beam, whose other arm
//! is on run `mate`, or one bar of a frame, whose others are on the other runs of its site.
struct Beam {
  int start = 0;
  int holes = 2;
  int layer = 0;
  int mate = -1;
  int form = -1;  //!< arms: index of the bent beam (layout/bent_beam.h)
  int tail = 0;   //!< arms that end in an axle hole: on which side of the holes it is, -1 or 1
  int site = -1;  //!< bars of frames: index of the place (layout/frame_sites.h)
  //! Bit i: the hole at node start + i goes across the bar in the frame's plane.
  std::uint32_t crossed = 0;

  [[nodiscard]] bool isArm() const { return mate >= 0 || site >= 0; }

  [[nodiscard]] bool reaches(int node) const { return start <= node && node <= last(); }

  //! \brief Whether there is a hole along the cover's axis.
  [[nodiscard]] bool hasHoleAt(int node) const {
    return reaches(node) &&
           (crossed == 0 || (crossed >> static_cast<unsigned>(node - start) & 1U) == 0U);
  }

  [[nodiscard]] int last() const { return start + holes - 1; }

  //! \brief First node that the beam's body reaches, axle holes included.
  [[nodiscard]] int solidStart() const { return tail < 0 ? start - 1 : start; }

  //! \brief Last node that the beam's body reaches, axle holes included.
  [[nodiscard]] int solidLast() const { return tail > 0 ? last() + 1 : last(); }

  friend bool operator==(const Beam& a, const Beam& b) {
    return a.start == b.start && a.holes == b.holes && a.layer == b.layer && a.mate == b.mate &&
           a.form == b.form && a.tail == b.tail && a.site == b.site;
  }
};

//! \brief All beams of one run, by their start, with their common hole axis; or an axle in their
//! place.
struct Cover {
  lattice::Axis axis = lattice::Axis::kX;
  std::vector<Beam> beams;
  Axle axle = {};

  [[nodiscard]] bool empty() const { return beams.empty() && !axle.used(); }

  friend bool operator==(const Cover& a, const Cover& b) {
    return a.axis == b.axis && a.beams == b.beams && a.axle == b.axle;
  }
};

//! \brief Middle of the hole at a run's node index on a layer, world.
inline lattice::Vec3 holePosition(const guide::GuidingGraph& graph,
                                  const guide::GuideRun& run,
                                  lattice::Axis axis,
                                  double index,
                                  int layer) {
  const lattice::Vec3 first = graph.nodes[static_cast<std::size_t>(run.nodes.front())];
  return first + (index + run.holeShift) * run.direction +
         static_cast<double>(layer) * lattice::unitVector(axis);
}

inline Stadium stadiumOf(const guide::GuidingGraph& graph,
                         const guide::GuideRun& run,
                         lattice::Axis axis,
                         const Beam& beam) {
  return {holePosition(graph, run, axis, beam.solidStart(), beam.layer),
          holePosition(graph, run, axis, beam.solidLast(), beam.layer),
          axis,
          beam.site >= 0 ? kFrameRadius : kBeamRadius};
}

//! \brief Up to two node indices of a run, ascending.
struct InlinePins {
  std::array<int, 2> nodes{};
  int count = 0;

  [[nodiscard]] const int* begin() const { return nodes.data(); }

  [[nodiscard]] const int* end() const { return nodes.data() + count; }

  [[nodiscard]] bool has(int node) const {
    return (count > 0 && nodes[0] == node) || (count > 1 && nodes[1] == node);
  }
};

//! \brief Nodes at which two consecutive beams of a run are pinned to each other: of those where
//! both have a hole and that are no junction (junctions are pinned by their own group), the first
//! and the last. \return None when all shared nodes are junctions.
InlinePins inlinePins(const guide::GuideRun& run, const Beam& a, const Beam& b);

//! \brief Nodes at which two beams of a run both have a hole along its hole axis.
int sharedHoles(const Beam& a, const Beam& b);

//! \brief The axis of holes that go across a bar of a frame in its plane.
lattice::Axis axisAcross(const guide::GuideRun& run, lattice::Axis axis);

//! \brief Whether two beams are arms of one bent beam or bars of one frame.
inline bool isOneBeam(int runA, const Beam& a, int runB, const Beam& b) {
  return (a.mate == runB && b.mate == runA) || (a.site >= 0 && a.site == b.site);
}

//! \brief Where two runs meet, or -1.
int commonJunction(const guide::GuidingGraph& graph, int run, int mate);

//! \brief Node index, on run `run`, where it meets run `mate`; -1 when they do not meet.
int cornerIndex(const guide::GuidingGraph& graph, int run, int mate);

//! \brief Number of real parts that a beam of this many holes is made of: two thin ones for 4
//! and 6.
int partsOfBeam(int holes);

}  // namespace liftarm::layout
