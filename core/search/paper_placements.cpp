#include <algorithm>
#include <numeric>

#include "search/paper_layout.h"

namespace liftarm::search {

using layout::Beam;

//! Entry i is the number of coverable edges before edge i that no beam covers.
std::vector<int> PaperLayout::uncoveredBefore(int run) const {
  std::vector<int> bare(coverable_[at(run)].begin(), coverable_[at(run)].end());
  for (const Beam& beam : covers_[at(run)].beams) {
    std::fill(bare.begin() + beam.start, bare.begin() + beam.last(), 0);
  }
  std::vector<int> before(bare.size() + 1, 0);
  std::partial_sum(bare.begin(), bare.end(), before.begin() + 1);
  return before;
}

bool PaperLayout::fits(int run, int start, int holes) const {
  const int last = start + holes - 1;
  if (start < 0 || last > problem_->graph.runs[at(run)].edgeCount()) {
    return false;
  }
  const std::vector<std::uint8_t>& edges = coverable_[at(run)];
  return std::all_of(
      edges.begin() + start, edges.begin() + last, [](std::uint8_t ok) { return ok != 0; });
}

bool PaperLayout::joinedAlready(int run, int mate) const {
  const std::vector<Beam>& beams = covers_[at(run)].beams;
  return std::any_of(
      beams.begin(), beams.end(), [&](const Beam& beam) { return beam.mate == mate; });
}

std::vector<PaperPlacement> PaperLayout::placements(const std::vector<int>& runs,
                                                    bool corners) const {
  std::vector<PaperPlacement> found;
  std::vector<std::vector<int>> before(covers_.size());
  for (const int run : runs) {
    before[at(run)] = uncoveredBefore(run);
    const std::vector<int>& bare = before[at(run)];
    for (int start = 0; start < static_cast<int>(bare.size()) && bare.back() > 0; ++start) {
      for (const int holes : lengths_) {
        if (!fits(run, start, holes)) {
          break;
        }
        const int count = bare[at(start + holes - 1)] - bare[at(start)];
        if (count > 0) {
          found.push_back({run, start, holes, -1, 0, 0, count});
        }
      }
    }
  }
  const auto covers = [&](int run, int start, int holes) {
    const std::vector<int>& bare = before[at(run)];
    return bare.empty() ? 0 : bare[at(start + holes - 1)] - bare[at(start)];
  };
  const auto addCorner = [&](int run, int mate, int corner, int mateCorner) {
    for (int way = 0; way < 8; ++way) {
      const int holes = (way & 1) != 0 ? kCornerLong : kCornerShort;
      const int mateHoles = kCornerLong + kCornerShort - holes;
      const int start = (way & 2) != 0 ? corner : corner - holes + 1;
      const int mateStart = (way & 4) != 0 ? mateCorner : mateCorner - mateHoles + 1;
      if (fits(run, start, holes) && fits(mate, mateStart, mateHoles)) {
        const int count = covers(run, start, holes) + covers(mate, mateStart, mateHoles);
        if (count > 0) {
          found.push_back({run, start, holes, mate, mateStart, mateHoles, count});
        }
      }
    }
  };
  // Runs of one line meet end to end where their rules differ: no corner.
  const auto square = [&](int a, int b) {
    const std::vector<guide::GuideRun>& all = problem_->graph.runs;
    return std::abs(lattice::dot(all[at(a)].direction, all[at(b)].direction)) < 0.5;
  };
  for (const int run : runs) {
    const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
    for (std::size_t j = 0; j < guideRun.junctions.size() && corners && guideRun.principal; ++j) {
      for (const guide::Incidence& other :
           problem_->graph.junctions[at(guideRun.junctions[j])].incident) {
        // A pair of which both runs are asked for is looked at once, from its lower run.
        const bool twice = !before[at(other.run)].empty() && other.run < run;
        if (other.run != run && !twice && square(run, other.run) &&
            problem_->graph.runs[at(other.run)].principal &&
            axes_[at(other.run)] == axes_[at(run)] && !joinedAlready(run, other.run)) {
          addCorner(run, other.run, guideRun.junctionIndices[j], other.index);
        }
      }
    }
  }
  return found;
}

}  // namespace liftarm::search
