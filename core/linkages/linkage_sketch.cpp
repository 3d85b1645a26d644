#include "linkages/linkage_sketch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.h"

namespace liftarm::linkages {

namespace {

using base::at;

constexpr int kDrawnTurns = 72;
constexpr double kSame = 1e-6;
constexpr double kParallel = 0.25;  // sine of the angle
constexpr double kRounding = 1e6;   // coordinates are written to a millionth of a module

enum Link { kFrame, kCrank, kRocker, kCoupler };

//! A line of the drawing in the plane.
struct DrawnLine {
  Link link = kFrame;
  Point from;
  Point to;
};

//! Where a hole of the coupler is, in the linkage's own plane.
Point holeAt(const FourBar& bar, const FourBarPose& pose, int hole) {
  const Coupler& coupler = bar.coupler;
  const Point crank = holeOf(coupler.beam, coupler.side, coupler.crankHole);
  const Point rocker = holeOf(coupler.beam, coupler.side, coupler.rockerHole);
  const double square = coupler.length * coupler.length;
  const Point turn =
      (1.0 / square) * ((pose.rockerPin - pose.crankPin) * conjugate(rocker - crank));
  return pose.crankPin + turn * (holeOf(coupler.beam, coupler.side, hole) - crank);
}

std::vector<DrawnLine> linesOf(const FourBar& bar, const FourBarPose& pose) {
  const Point pivot{static_cast<double>(bar.frame), 0.0};
  const CouplerBeam& beam = bar.coupler.beam;
  std::vector<DrawnLine> lines{{kFrame, {}, pivot},
                               {kCrank, {}, pose.crankPin},
                               {kRocker, pivot, pose.rockerPin},
                               {kCoupler, holeAt(bar, pose, 0), holeAt(bar, pose, beam.first)}};
  if (beam.second > 0) {
    lines.push_back(
        {kCoupler, holeAt(bar, pose, beam.first), holeAt(bar, pose, beam.first + beam.second)});
  }
  return lines;
}

bool isOn(Point p, const DrawnLine& line) {
  return length(p - nearestOn(p, line.from, line.to)) < kSame;
}

std::vector<Point> nodesOf(const DrawnLine& line) {
  const int edges = static_cast<int>(std::lround(length(line.to - line.from)));
  std::vector<Point> nodes;
  for (int i = 0; i <= edges; ++i) {
    nodes.push_back(line.from + (static_cast<double>(i) / edges) * (line.to - line.from));
  }
  return nodes;
}

//! Whether two lines lie along each other, or nearly so.
bool areParallel(const DrawnLine& a, const DrawnLine& b) {
  const Point one = a.to - a.from;
  const Point other = b.to - b.from;
  return std::abs(cross(one, other)) < kParallel * length(one) * length(other);
}

//! How far the nearest nodes of two lines are from each other, pins left out.
double nearestNodes(const DrawnLine& a, const DrawnLine& b, const std::array<Point, 4>& pins) {
  double nearest = 1.0;
  for (const Point p : nodesOf(a)) {
    const bool pinned =
        std::any_of(pins.begin(), pins.end(), [&](Point pin) { return length(p - pin) < kSame; });
    for (const Point q : nodesOf(b)) {
      nearest = pinned ? nearest : std::min(nearest, length(p - q));
    }
  }
  return nearest;
}

//! How muddled a drawing is: lines of different links that cross or lie along each other, and how
//! near nodes come that do not belong together.
std::pair<int, double> muddleOf(const std::vector<DrawnLine>& lines,
                                const std::array<Point, 4>& pins) {
  int crossings = 0;
  double nearest = 1.0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const DrawnLine& a = lines[i];
      const DrawnLine& b = lines[j];
      if (a.link == b.link) {
        continue;
      }
      const bool pinned = std::any_of(
          pins.begin(), pins.end(), [&](Point pin) { return isOn(pin, a) && isOn(pin, b); });
      const bool muddled =
          pinned ? areParallel(a, b) : distanceBetween(a.from, a.to, b.from, b.to) < kSame;
      crossings += muddled ? 1 : 0;
      nearest = std::min(nearest, nearestNodes(a, b, pins));
    }
  }
  return {crossings, -nearest};
}

std::array<Point, 4> pinsOf(const FourBar& bar, const FourBarPose& pose) {
  return {Point{}, pose.crankPin, pose.rockerPin, Point{static_cast<double>(bar.frame), 0.0}};
}

//! Whether the rocker is about to turn back, so that from here it could hardly be turned by hand.
bool isNearDeadPoint(const FourBar& bar, const FourBarPose& pose) {
  return std::abs(cross(pose.crankPin, pose.rockerPin - pose.crankPin)) <
         kParallel * bar.crank * bar.coupler.length;
}

FourBarPose clearestPose(const FourBar& bar) {
  std::pair<int, double> best{1 << 20, 0.0};
  FourBarPose found;
  for (const Point turn : turnsOf(kDrawnTurns)) {
    const FourBarPose pose = poseOf(bar, turn);
    std::pair<int, double> muddle = muddleOf(linesOf(bar, pose), pinsOf(bar, pose));
    muddle.first += isNearDeadPoint(bar, pose) ? 1 : 0;
    if (muddle < best) {
      best = muddle;
      found = pose;
    }
  }
  return found;
}

lattice::Vec3 rounded(lattice::Vec3 p) {
  for (int k = 0; k < 3; ++k) {
    p[k] = std::round(p[k] * kRounding) / kRounding;
  }
  return p;
}

std::string nameOf(const FourBar& bar) {
  const auto tenths = static_cast<int>(std::lround(bar.coupler.length * 10.0));
  std::string coupler = std::to_string(tenths / 10);
  if (tenths % 10 != 0) {
    coupler += "." + std::to_string(tenths % 10);
  }
  return "Four-bar " + std::to_string(bar.crank) + " " + coupler + " " +
         std::to_string(bar.rocker) + " " + std::to_string(bar.frame);
}

}  // namespace

lattice::Axis PathPlane::u() const {
  return normal == lattice::Axis::kX ? lattice::Axis::kY : lattice::Axis::kX;
}

lattice::Axis PathPlane::v() const {
  return normal == lattice::Axis::kZ ? lattice::Axis::kY : lattice::Axis::kZ;
}

lattice::Vec3 PathPlane::toSpace(Point p) const {
  lattice::Vec3 q;
  q[lattice::index(normal)] = offset;
  q[lattice::index(u())] = p.u;
  q[lattice::index(v())] = p.v;
  return q;
}

Point PathPlane::toPlane(lattice::Vec3 p) const {
  return {p[lattice::index(u())], p[lattice::index(v())]};
}

sketch::Sketch sketchOf(const LinkageAnswer& answer, const PathPlane& plane) {
  const FourBar& bar = answer.bar;
  const FourBarPose pose = clearestPose(bar);
  const std::vector<DrawnLine> lines = linesOf(bar, pose);
  const auto place = [&](Point p) {
    return rounded(plane.toSpace(answer.match.placement.apply(p)));
  };
  sketch::Sketch drawn;
  drawn.name = nameOf(bar);
  for (const DrawnLine& line : lines) {
    sketch::Line added;
    added.from = place(line.from);
    added.to = place(line.to);
    added.length = static_cast<int>(std::lround(length(line.to - line.from)));
    added.holeAxis = plane.normal;
    drawn.lines.push_back(added);
  }
  const std::array<Point, 4> pins = pinsOf(bar, pose);
  const std::array<std::pair<Link, Link>, 4> sides{
      {{kFrame, kCrank}, {kCrank, kCoupler}, {kRocker, kCoupler}, {kFrame, kRocker}}};
  for (std::size_t p = 0; p < pins.size(); ++p) {
    sketch::Joint joint;
    joint.at = place(pins[p]);
    joint.axis = lattice::unitVector(plane.normal);
    for (const Link side : {sides[p].first, sides[p].second}) {
      std::vector<int>& group = joint.between.emplace_back();
      for (std::size_t l = 0; l < lines.size(); ++l) {
        if (lines[l].link == side && isOn(pins[p], lines[l])) {
          group.push_back(static_cast<int>(l));
        }
      }
    }
    if (p == 0) {
      joint.range = {-180.0, 180.0};
    }
    drawn.joints.push_back(joint);
  }
  return drawn;
}

std::vector<Point> pivotsOf(const LinkageAnswer& answer) {
  const Placement& placement = answer.match.placement;
  return {placement.apply({}), placement.apply({static_cast<double>(answer.bar.frame), 0.0})};
}

std::vector<FourBarPose> posesOf(const LinkageAnswer& answer, int count) {
  const Placement& placement = answer.match.placement;
  std::vector<FourBarPose> poses(at(count));
  const std::vector<Point> turns = turnsOf(count);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const FourBarPose pose = poseOf(answer.bar, turns[i]);
    poses[i] = {placement.apply(pose.crankPin),
                placement.apply(pose.rockerPin),
                placement.apply(pose.point)};
  }
  return poses;
}

}  // namespace liftarm::linkages
