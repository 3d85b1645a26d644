#pragma once

#include <optional>
#include <string>
#include <vector>

#include "guide/guiding_graph.h"
#include "layout/beam.h"
#include "layout/frame_sites.h"
#include "sketch/keep.h"
#include "sketch/sketch.h"

namespace liftarm::layout {

struct LayoutProblem;

//! \brief A beam that may not lie on a run, on whichever layer.
struct Ban {
  int start = 0;
  int holes = 0;
  int bend = -1;   //!< index in bentBeams(), or -1
  int frame = -1;  //!< index in frameBeams(), or -1; neither: a straight beam
};

//! \brief Layers of the beams that cover an edge between two nodes of a run.
struct LayerRule {
  int first = 0;
  int last = 0;
  unsigned layers = guide::kAllLayers;  //!< bit (layer + kMaxLayer)
};

//! \brief What a sketch's `keep` asks of one run.
struct RunKeep {
  std::vector<Beam> beams;  //!< that lie there as they are, arms and bars included; by start
  std::vector<Ban> bans;
  std::vector<LayerRule> rules;
  std::vector<int>
      splits;           //!< nodes past which a beam reaches by one at most, on one side or other
  bool noAxle = false;  //!< no axle may cover the run

  [[nodiscard]] bool empty() const {
    return beams.empty() && bans.empty() && rules.empty() && splits.empty() && !noAxle;
  }

  //! \brief Whether a beam may lie on the run beside those that are kept. \param sites Of the
  //! problem.
  [[nodiscard]] bool permits(const Beam& beam, const std::vector<FrameSite>& sites) const;

  [[nodiscard]] bool keeps(const Beam& beam) const;
};

//! \brief Something that a sketch wants to keep and that cannot be.
struct KeepFault {
  int line = 0;
  std::string message;  //!< a sentence without a place
  lattice::Vec3 at;     //!< the middle of the part, or a node of the line
};

//! \brief Gives runs the one hole axis of the parts that are kept on them.
void turnToKeeps(const sketch::Sketch& sketch,
                 const sketch::Keeps& keeps,
                 guide::GuidingGraph* graph);

//! \brief Fills in what a sketch keeps, by run, and what of it cannot be.
//! \pre turnToKeeps was asked before the problem was made of its graph.
void addKeeps(const sketch::Sketch& sketch, const sketch::Keeps& keeps, LayoutProblem* problem);

//! \brief A stretch of a line on the run that it is part of.
struct RunStretch {
  int run = -1;
  int start = 0;
  int holes = 0;
};

//! \brief Finds stretches of lines on the runs of a graph.
class StretchFinder {
 public:
  //! \pre Both outlive this.
  StretchFinder(const sketch::Sketch& sketch, const guide::GuidingGraph& graph);

  //! \return None where the stretch goes past its run by more than one module.
  [[nodiscard]] std::optional<RunStretch> find(const sketch::Stretch& stretch) const;

  //! \brief The same the other way: on the line with the lowest number of which the beam covers
  //! an edge, or at whose end it is.
  [[nodiscard]] sketch::Stretch lineOf(const RunStretch& stretch) const;

 private:
  struct LineOnRun {
    int line = -1;
    int run = -1;
    int first = 0;  //!< node of the run at the line's first end
    int sign = 1;   //!< 1: the line goes along the run
    int length = 0;
  };

  const guide::GuidingGraph* graph_;
  std::vector<LineOnRun> places_;  // by line, then by run
};

//! \brief Whether the sketch has nothing against an arm or a bar on a run: it is permitted there,
//! and shares no node with a kept beam.
bool mayLie(const LayoutProblem& problem, int run, const Beam& beam);

//! \brief Violations of what a run keeps: kLostKeep for each kept beam that is not there, one for
//! each beam that may not be.
int keepViolations(const LayoutProblem& problem, int run, const Cover& cover);

//! \brief More than any layout has violations of other kinds that is worth showing.
inline constexpr int kLostKeep = 1000;

//! \brief What a run is covered with before anything is laid: the kept beams.
Cover bareCover(const LayoutProblem& problem, int run, lattice::Axis axis);

}  // namespace liftarm::layout
