#include "gears/gear_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "gears/gear_sizes.h"
#include "sketch/keep.h"
#include "sketch/shaft.h"
#include "sketch/sketch_colours.h"

namespace liftarm::gears {

namespace {

using lattice::Cell;

constexpr int kLeastDepth = 4;    // modules between the plates: connectors need them
constexpr int kLongestBeam = 14;  // modules: a column is one exact beam
constexpr int kMargin = 2;        // from the outermost shafts to the rails

//! From least to largest.
struct Span {
  int low = 0;
  int high = 0;
};

class FrameDrawer {
 public:
  FrameDrawer(const Train& train, const TrainRequest& request) : train_(train), request_(request) {
    Span u = spanOf([](Place p) { return p.u; });
    Span v = spanOf([](Place p) { return p.v; });
    alongU_ = u.high - u.low < v.high - v.low;
    for (const Place place : train.shafts) {
      columns_[alongU_ ? place.v : place.u].insert(alongU_ ? place.u : place.v);
    }
    int planes = 1;
    for (const TrainGear& gear : train.gears) {
      planes = std::max(planes, gear.plane + 1);
    }
    depth_ = std::max(kLeastDepth, planes + 1);
    findStoreys(alongU_ ? u : v);
    const double reach = std::ceil(largestRadius()) + 1.0;
    const Span across = alongU_ ? v : u;
    ends_ = {across.low - static_cast<int>(reach), across.high + static_cast<int>(reach)};
  }

  std::string text() {
    for (const int plate : {0, depth_}) {
      for (const Span& storey : storeys_) {
        addStorey(storey, plate);
      }
      for (const int end : {ends_.low, ends_.high}) {
        addLine(cell(end, storeys_.front().low, plate), cell(end, storeys_.back().high, plate));
      }
    }
    for (const int end : {ends_.low, ends_.high}) {
      for (const int rail : {storeys_.front().low, storeys_.back().high}) {
        addLine(cell(end, rail, 0), cell(end, rail, depth_));
      }
    }
    sketch::Shafts shafts;
    for (const Place place : {train_.shafts.front(), train_.shafts.back()}) {
      shafts.shafts.push_back({cellAt(place, -1), cellAt(place, depth_ + 1)});
    }
    shafts.drives.push_back({0, 1, request_.ratio, 100.0 * request_.tolerance});
    sketch_.name = "Gear train";
    return sketch::writeSketch(sketch_, {}, {}, shafts);
  }

 private:
  template <typename Of>
  [[nodiscard]] Span spanOf(Of of) const {
    Span span{of(train_.shafts.front()), of(train_.shafts.front())};
    for (const Place place : train_.shafts) {
      span.low = std::min(span.low, of(place));
      span.high = std::max(span.high, of(place));
    }
    return span;
  }

  [[nodiscard]] double largestRadius() const {
    int teeth = 0;
    for (const TrainGear& gear : train_.gears) {
      teeth = std::max(teeth, gear.teeth);
    }
    return tipRadius(teeth);
  }

  //! Below and above all shafts, and two side by side where a column would be longer than a beam,
  //! but none through a shaft. Beams of 8, 10, 12 or 14 holes there are none, so the rails of a
  //! storey are an even number of modules apart.
  void findStoreys(Span along) {
    std::set<int> taken;
    for (const auto& [place, shafts] : columns_) {
      taken.insert(shafts.begin(), shafts.end());
    }
    int low = along.low - kMargin;
    const int high = along.high + kMargin;
    while (high - low > kLongestBeam) {
      int end = low + kLongestBeam;
      while (taken.count(end) > 0 || taken.count(end + 1) > 0) {
        end -= 2;
      }
      storeys_.push_back({low, end});
      low = end + 1;
    }
    storeys_.push_back({low, high + (high - low) % 2});
  }

  //! Two rails, and between them the columns that have shafts there.
  void addStorey(Span storey, int plate) {
    for (const int rail : {storey.low, storey.high}) {
      addLine(cell(ends_.low, rail, plate), cell(ends_.high, rail, plate));
    }
    for (const auto& [place, shafts] : columns_) {
      const auto above = shafts.upper_bound(storey.low);
      if (above != shafts.end() && *above < storey.high) {
        addLine(cell(place, storey.low, plate), cell(place, storey.high, plate));
      }
    }
  }

  //! \param across Along the rails. \param along Along the columns.
  [[nodiscard]] Cell cell(int across, int along, int plate) const {
    return alongU_ ? Cell{across, plate, along} : Cell{along, plate, across};
  }

  [[nodiscard]] static Cell cellAt(Place place, int slot) { return {place.v, slot, place.u}; }

  void addLine(Cell a, Cell b) {
    const lattice::Vec3 from = lattice::toVec3(a);
    const lattice::Vec3 to = lattice::toVec3(b);
    const int length = static_cast<int>(std::lround(lattice::length(to - from)));
    sketch_.lines.push_back({from, to, length, false, std::nullopt});
  }

  const Train& train_;
  const TrainRequest& request_;
  bool alongU_ = true;  // columns go up
  int depth_ = 0;
  std::map<int, std::set<int>> columns_;  // shafts along each column
  std::vector<Span> storeys_;             // between rails, ascending
  Span ends_;
  sketch::Sketch sketch_;
};

}  // namespace

std::string gearFrame(const Train& train, const TrainRequest& request) {
  return FrameDrawer(train, request).text();
}

}  // namespace liftarm::gears
