#include "sketch/moving_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/det_math.h"
#include "base/index.h"
#include "sketch/moving_bodies.h"

namespace liftarm::sketch {

namespace {

using base::at;
using lattice::Vec3;

constexpr double kRadian = 3.14159265358979323846 / 180.0;
constexpr double kStep = 2.0;       // degrees
constexpr double kBeamWide = 0.99;  // modules between the lines of two beams that touch
constexpr double kFlat = 1e-6;
constexpr int kMostBodies = 24;  // larger machines would take long
constexpr int kMostTries = 20000;

struct Point {
  double u = 0.0;
  double v = 0.0;
};

Point operator-(Point a, Point b) {
  return {a.u - b.u, a.v - b.v};
}

double dot(Point a, Point b) {
  return a.u * b.u + a.v * b.v;
}

double cross(Point a, Point b) {
  return a.u * b.v - a.v * b.u;
}

double distanceTo(Point p, Point from, Point to) {
  const Point span = to - from;
  const double share = std::clamp(dot(p - from, span) / dot(span, span), 0.0, 1.0);
  const Point foot{from.u + share * span.u, from.v + share * span.v};
  return std::sqrt(dot(p - foot, p - foot));
}

double distanceBetween(Point a, Point b, Point c, Point d) {
  const double sideC = cross(b - a, c - a);
  const double sideD = cross(b - a, d - a);
  const double sideA = cross(d - c, a - c);
  const double sideB = cross(d - c, b - c);
  if (sideC * sideD < 0.0 && sideA * sideB < 0.0) {
    return 0.0;
  }
  return std::min(
      {distanceTo(a, c, d), distanceTo(b, c, d), distanceTo(c, a, b), distanceTo(d, a, b)});
}

//! The lines of one body in one plane across the axis: what shares layers.
struct Slab {
  int body = -1;
  double offset = 0.0;  // along the axis
  std::vector<int> lines;
  int width = 1;  // layers
  bool exact = false;
};

//! Which slabs may not share a level, and which must be neighbours, by slab and slab.
struct Rules {
  std::vector<char> apart;
  std::vector<char> pinned;
};

class LayerPlanner {
 public:
  LayerPlanner(const Sketch& sketch, int reach)
      : sketch_(sketch), reach_(reach), bodies_(bodiesOfLines(sketch)) {
    for (const int body : bodies_) {
      count_ = std::max(count_, body + 1);
    }
  }

  std::vector<LayerBits> plan() {
    const auto driven = std::find_if(sketch_.joints.begin(), sketch_.joints.end(), hasRange);
    if (driven == sketch_.joints.end() || count_ > kMostBodies) {
      return {};
    }
    axis_ = driven->axis;
    std::tie(uAxis_, vAxis_) = planeAcross(axis_);
    collectPins();
    collectSlabs();
    rules_.apart.assign(slabs_.size() * slabs_.size(), char{0});
    rules_.pinned = rules_.apart;
    for (std::size_t j = 0; j < sketch_.joints.size(); ++j) {
      if (hasRange(sketch_.joints[j]) && pinOf_[j] >= 0) {
        drive(*sketch_.joints[j].range, pinOf_[j]);
      }
    }
    markPinned();
    return choose();
  }

 private:
  static bool hasRange(const Joint& joint) { return joint.range.has_value(); }

  [[nodiscard]] double along(Vec3 p) const { return lattice::dot(p, axis_); }

  [[nodiscard]] Point flat(Vec3 p) const {
    return {p[lattice::index(uAxis_)], p[lattice::index(vAxis_)]};
  }

  //! The bodies that a joint sets apart, by the lines that it names or that meet there.
  [[nodiscard]] std::pair<int, int> sidesOf(const Joint& joint) const {
    std::vector<int> sides;
    const auto add = [&](int line) {
      const int body = bodies_[at(line)];
      if (std::find(sides.begin(), sides.end(), body) == sides.end()) {
        sides.push_back(body);
      }
    };
    for (const std::vector<int>& group : joint.between) {
      if (!group.empty()) {
        add(group.front());
      }
    }
    for (std::size_t l = 0; joint.between.empty() && l < sketch_.lines.size(); ++l) {
      const Line& line = sketch_.lines[l];
      const double detour =
          lattice::length(joint.at - line.from) + lattice::length(line.to - joint.at) - line.length;
      if (detour < kFlat) {
        add(static_cast<int>(l));
      }
    }
    return sides.size() == 2 ? std::pair{sides[0], sides[1]} : std::pair{-1, -1};
  }

  void collectPins() {
    for (const Joint& joint : sketch_.joints) {
      const auto [a, b] = sidesOf(joint);
      const bool parallel = std::abs(std::abs(lattice::dot(joint.axis, axis_)) - 1.0) < kFlat;
      pinOf_.push_back(a >= 0 && parallel ? static_cast<int>(pins_.size()) : -1);
      if (pinOf_.back() >= 0) {
        const Point p = flat(joint.at);
        pins_.push_back({a, b, p.u, p.v});
        offsets_.push_back(along(joint.at));
      }
    }
  }

  int slabOf(int body, double offset) {
    for (std::size_t s = 0; s < slabs_.size(); ++s) {
      if (slabs_[s].body == body && std::abs(slabs_[s].offset - offset) < kFlat) {
        return static_cast<int>(s);
      }
    }
    return -1;
  }

  void collectSlabs() {
    for (std::size_t l = 0; l < sketch_.lines.size(); ++l) {
      const Line& line = sketch_.lines[l];
      const double offset = along(line.from);
      if (std::abs(along(line.to) - offset) > kFlat) {
        continue;
      }
      int slab = slabOf(bodies_[l], offset);
      if (slab < 0) {
        slab = static_cast<int>(slabs_.size());
        slabs_.push_back({bodies_[l], offset, {}, 1, false});
      }
      Slab& mine = slabs_[at(slab)];
      const Point span = flat(line.to) - flat(line.from);
      for (const int other : mine.lines) {
        const Line& theirs = sketch_.lines[at(other)];
        if (std::abs(cross(span, flat(theirs.to) - flat(theirs.from))) > kFlat) {
          mine.width = 2;
        }
      }
      mine.lines.push_back(static_cast<int>(l));
      mine.exact = mine.exact || line.exact;
    }
  }

  void drive(const std::array<double, 2>& range, int pin) {
    PlaneLinkage linkage(pins_, count_, pin);
    for (const double end : range) {
      linkage.reset();
      const int steps = static_cast<int>(std::ceil(std::abs(end) / kStep));
      for (int i = 0; i <= steps; ++i) {
        const double degrees = steps == 0 ? 0.0 : end * i / steps;
        if (!linkage.turnTo(degrees * kRadian)) {
          break;
        }
        markMeetings(linkage.poses());
      }
    }
  }

  [[nodiscard]] static Point moved(const PlanePose& pose, Point p) {
    const double c = base::detCos(pose.angle);
    const double s = base::detSin(pose.angle);
    return {c * p.u - s * p.v + pose.u, s * p.u + c * p.v + pose.v};
  }

  [[nodiscard]] std::vector<std::pair<Point, Point>> placed(
      const std::vector<PlanePose>& poses) const {
    std::vector<std::pair<Point, Point>> lines;
    for (std::size_t l = 0; l < sketch_.lines.size(); ++l) {
      const PlanePose& pose = poses[at(bodies_[l])];
      lines.emplace_back(moved(pose, flat(sketch_.lines[l].from)),
                         moved(pose, flat(sketch_.lines[l].to)));
    }
    return lines;
  }

  void markMeetings(const std::vector<PlanePose>& poses) {
    const std::vector<std::pair<Point, Point>> lines = placed(poses);
    for (std::size_t s = 1; s < slabs_.size(); ++s) {
      for (std::size_t t = 0; t < s; ++t) {
        char& apart = rules_.apart[s * slabs_.size() + t];
        if (apart != 0 || slabs_[s].body == slabs_[t].body) {
          continue;
        }
        for (const int a : slabs_[s].lines) {
          for (const int b : slabs_[t].lines) {
            const auto& [from, to] = lines[at(a)];
            const auto& [start, end] = lines[at(b)];
            apart = apart != 0 || distanceBetween(from, to, start, end) < kBeamWide ? 1 : 0;
          }
        }
        rules_.apart[t * slabs_.size() + s] = apart;
      }
    }
  }

  void markPinned() {
    for (std::size_t p = 0; p < pins_.size(); ++p) {
      const int a = slabOf(pins_[p].a, offsets_[p]);
      const int b = slabOf(pins_[p].b, offsets_[p]);
      if (a >= 0 && b >= 0) {
        rules_.pinned[at(a) * slabs_.size() + at(b)] = char{1};
        rules_.pinned[at(b) * slabs_.size() + at(a)] = char{1};
      }
    }
  }

  //! Whether two slabs may lie as they are placed.
  [[nodiscard]] bool agree(std::size_t s, std::size_t t) const {
    const double lowS = slabs_[s].offset + low_[s];
    const double lowT = slabs_[t].offset + low_[t];
    const double below = lowT - (lowS + slabs_[s].width);  // from the one's top to the other
    const double above = lowS - (lowT + slabs_[t].width);
    const double gap = std::max(below, above);
    if (rules_.pinned[s * slabs_.size() + t] != 0) {
      return std::abs(gap) < kFlat;
    }
    return rules_.apart[s * slabs_.size() + t] == 0 || gap > -kFlat;
  }

  void place(std::size_t s, int cost) {
    if (cost >= best_ || ++tries_ > kMostTries) {
      return;
    }
    if (s == slabs_.size()) {
      best_ = cost;
      bestLow_ = low_;
      return;
    }
    for (int step = 0; step <= 2 * reach_; ++step) {
      const int low = step % 2 == 0 ? -step / 2 : (step + 1) / 2;
      const int high = low + slabs_[s].width - 1;
      if (high > reach_ || (slabs_[s].exact && (low > 0 || high < 0))) {
        continue;
      }
      low_[s] = low;
      bool fits = true;
      for (std::size_t t = 0; t < s && fits; ++t) {
        fits = agree(s, t);
      }
      if (fits) {
        place(s + 1, cost + std::max(std::abs(low), std::abs(high)));
      }
    }
  }

  std::vector<LayerBits> choose() {
    low_.assign(slabs_.size(), 0);
    place(0, 0);
    if (bestLow_.empty()) {
      return {};
    }
    const LayerBits all = (1U << static_cast<unsigned>(2 * reach_ + 1)) - 1U;
    std::vector<LayerBits> bits(sketch_.lines.size(), all);
    for (std::size_t s = 0; s < slabs_.size(); ++s) {
      const LayerBits mine = ((1U << static_cast<unsigned>(slabs_[s].width)) - 1U)
                             << static_cast<unsigned>(bestLow_[s] + reach_);
      for (const int line : slabs_[s].lines) {
        bits[at(line)] = isMoved(s) ? mine : all;
      }
    }
    return bits;
  }

  //! Whether anything says where a slab lies.
  [[nodiscard]] bool isMoved(std::size_t s) const {
    for (std::size_t t = 0; t < slabs_.size(); ++t) {
      if (rules_.apart[s * slabs_.size() + t] != 0 || rules_.pinned[s * slabs_.size() + t] != 0) {
        return true;
      }
    }
    return false;
  }

  const Sketch& sketch_;
  int reach_;
  std::vector<int> bodies_;  // by line
  int count_ = 0;
  Vec3 axis_;
  lattice::Axis uAxis_ = lattice::Axis::kX;
  lattice::Axis vAxis_ = lattice::Axis::kY;
  std::vector<PlanePin> pins_;
  std::vector<double> offsets_;  // of pins along the axis
  std::vector<int> pinOf_;       // by joint, or -1
  std::vector<Slab> slabs_;
  Rules rules_;
  std::vector<int> low_;
  std::vector<int> bestLow_;
  int best_ = 1 << 20;
  int tries_ = 0;
};

}  // namespace

std::vector<LayerBits> movingLayers(const Sketch& sketch, int reach) {
  return LayerPlanner(sketch, reach).plan();
}

}  // namespace liftarm::sketch
