#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::objective {

//! \brief Bodies that turn against each other about common lines, and how many degrees of freedom
//! that leaves: the mobility of a layout with every pin turning.
//! \details A hinge is a line with all the bodies that are on it, as beams on one pin are. What is
//! certainly rigid is made one body first: two bodies that share two hinges, transitively. A body
//! on one hinge alone adds one degree of freedom and says no more, so it is taken off. What is left
//! closes loops: about each, the screws of its hinges times their rates add up to zero \cite
//! davies_1981_kirchhoff, and the degrees of freedom are the rates less the rank of those
//! conditions. Connecting parts are bodies that do not count: what only they can do is no freedom.
class HingeGraph {
 public:
  void clear();

  //! \param counts Whether its motion is a freedom: beams' are, those of connecting parts are not.
  int addBody(bool counts);

  //! \brief Makes one body of two.
  void merge(int a, int b);

  //! \param line Number of the line; equal numbers are the same line.
  void addHinge(int line, int a, int b);

  //! \brief Where the lines are. \pre One for each number that addHinge() was given.
  void setLines(std::vector<std::pair<lattice::Axis, lattice::Vec3>> lines) {
    lines_ = std::move(lines);
  }

  //! \brief Degrees of freedom of counting bodies against each other, at the first order.
  int mobility();

  //! \brief The body that a body has become part of by merge() and mobility().
  [[nodiscard]] int rootOf(int body) const;

  [[nodiscard]] int bodies() const { return static_cast<int>(parents_.size()); }

 private:
  using Screw = std::array<double, 6>;  // a line's direction and its moment about a point

  struct Hinge {
    int line = -1;
    std::vector<int> bodies;
  };

  struct Edge {
    int a = -1;
    int b = -1;
    int line = -1;
  };

  void gather();
  bool mergeShared();
  bool takeLeavesOff();
  void markHolder(const Hinge& hinge);
  [[nodiscard]] int loopFreedoms();
  void spanTree(const std::vector<Edge>& edges);
  void addLoop(const std::vector<Edge>& edges, int closing);
  [[nodiscard]] int rankOfLoops(const std::vector<Edge>& edges);
  [[nodiscard]] int rankOfRows();

  std::vector<std::int32_t> parents_;
  std::vector<std::uint8_t> counts_;
  std::vector<std::uint8_t> off_;  // taken off, by root
  std::vector<Hinge> hinges_;
  std::vector<std::pair<lattice::Axis, lattice::Vec3>> lines_;
  int freedoms_ = 0;
  // Of the spanning tree, by body: edge to the parent (index + 1, negative when the body is its
  // first end), parent and depth.
  std::vector<std::int32_t> treeEdge_;
  std::vector<std::int32_t> treeParent_;
  std::vector<std::int32_t> depth_;
  std::vector<std::uint8_t> inTree_;  // by edge
  std::vector<Screw> screws_;         // by edge
  std::vector<int> columnOf_;         // by edge: -1 for those that close loops
  std::size_t treeColumns_ = 0;
  std::vector<double> rows_;
};

}  // namespace liftarm::objective
