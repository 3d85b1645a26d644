#pragma once

#include <cstdint>
#include <vector>

#include "layout/layout.h"
#include "search/paper_orientation.h"

namespace liftarm::search {

//! \brief LDraw number of the L beam that the paper's search lays.
inline constexpr const char* kCornerBeam = "32526";

//! \brief Holes of its arms, corner included.
inline constexpr int kCornerLong = 5;
inline constexpr int kCornerShort = 3;

//! \brief A beam placement (paper 5.1): a straight beam on one run, or an L beam with an arm on
//! each of two.
struct PaperPlacement {
  int run = -1;
  int start = 0;
  int holes = 2;
  int mate = -1;  //!< run of the other arm of an L beam, or -1
  int mateStart = 0;
  int mateHoles = 0;
  int covers = 0;  //!< uncovered edges that it would cover
};

//! \brief Sums over a paper layout. Unlike layout::Tallies these count every node of a run, also
//! those that are no junction.
struct PaperSums {
  int beams = 0;
  int holes = 0;          //!< paper 4.3, sum of L
  int layerSquares = 0;   //!< sum of L times layer squared
  int gaps = 0;           //!< paper 4.3, gap(v), read as in DESIGN 7, over all nodes
  int ownCollisions = 0;  //!< pairs of beams of one run on one layer that share a hole
  int ownFailures = 0;    //!< beams of one stretch that no pin in line joins: clusters less one
  int uncovered = 0;      //!< coverable edges that no beam covers
};

//! \brief Enters the sums into the tallies of a layout with the same beams.
//! \param connected Whether the tallies count its connections and collisions already, to which
//! those within runs are added.
void addPaperSums(const PaperSums& sums, layout::Tallies* tallies, bool connected);

//! \brief The beams of the paper's search: which edges of its components can be covered,
//! placements, and edits with undo. \details Connections are not its business.
//!
//! An edge cannot be covered where the hole axes of its two nodes differ (paper 5.1); lines off the
//! principal axes keep theirs, since mechanisms have no hole there to go to. Beams of one run are
//! pinned in line to the next one by start, as everywhere in layout::Layout; a beam within another
//! one may so stay unpinned, which counts as a failed connection.
class PaperLayout {
 public:
  //! \param lengths Allowed numbers of holes, ascending. \pre problem outlives this.
  PaperLayout(const layout::LayoutProblem& problem,
              PaperOrientation orientation,
              std::vector<int> lengths);

  [[nodiscard]] const layout::Cover& cover(int run) const { return covers_[at(run)]; }

  [[nodiscard]] const std::vector<layout::Cover>& covers() const { return covers_; }

  [[nodiscard]] bool coverable(int run, int edge) const {
    return coverable_[at(run)][at(edge)] != 0;
  }

  [[nodiscard]] bool covered(int run, int edge) const;

  //! \brief Layers of the beams of v's component at a node of a run, as bits (layer + kMaxLayer).
  [[nodiscard]] unsigned layersAt(int run, int index) const;

  //! \brief All placements that cover an uncovered edge of these runs. \param corners With L beams.
  [[nodiscard]] std::vector<PaperPlacement> placements(const std::vector<int>& runs,
                                                       bool corners) const;

  void add(const PaperPlacement& placement, int layer);

  //! \brief Takes one beam off, both arms of an L beam. \pre It is there.
  void remove(int run, const layout::Beam& beam) { erase(run, beam); }

  //! \brief Puts a run's cover as another layout of the same problem has it.
  void setCover(int run, const layout::Cover& cover);

  //! \brief Takes off all beams of the component that cover the edge or stop at one of its nodes.
  void removeAround(int run, int edge);

  //! \brief Gives a run another hole axis and takes off what cannot stay then.
  void turn(int run, lattice::Axis axis);

  //! \brief Runs changed since keep(), each once.
  [[nodiscard]] const std::vector<int>& touched() const { return touched_; }

  [[nodiscard]] bool turned() const { return turned_; }

  //! \brief Brings the sums up to date.
  void settle();

  [[nodiscard]] const PaperSums& sums() const { return sums_; }

  void keep();
  void revert();

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void touch(int run);
  std::vector<int> changeAxis(int run, lattice::Axis axis);
  void markCoverable(int run);
  void insert(int run, const layout::Beam& beam);
  void erase(int run, const layout::Beam& beam);
  void eraseStopping(int run, int index);
  [[nodiscard]] PaperSums sumsOfRun(int run) const;
  [[nodiscard]] int failuresOf(int run) const;
  [[nodiscard]] unsigned junctionLayers(int junction) const;
  [[nodiscard]] unsigned ownLayers(int run, int index) const;
  [[nodiscard]] std::vector<int> uncoveredBefore(int run) const;
  [[nodiscard]] bool fits(int run, int start, int holes) const;
  [[nodiscard]] bool joinedAlready(int run, int mate) const;

  const layout::LayoutProblem* problem_;
  std::vector<int> lengths_;
  std::vector<layout::Cover> covers_;
  guide::Orientation axes_;  //!< of the covers
  std::vector<lattice::Axis> junctionAxes_;
  std::vector<std::vector<int>> junctionAt_;  //!< by run and node index: junction or -1
  std::vector<std::vector<std::uint8_t>> coverable_;
  std::vector<PaperSums> runSums_;
  std::vector<int> junctionGaps_;
  PaperSums sums_;

  bool turned_ = false;
  std::vector<int> touched_;
  std::vector<std::uint8_t> isTouched_;
  std::vector<layout::Cover> savedCovers_;  //!< in the order of touched_
  std::vector<lattice::Axis> savedAxes_;
};

}  // namespace liftarm::search
