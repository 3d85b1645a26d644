#include "linkages/path_match.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace liftarm::linkages {

namespace {

constexpr int kRounds = 8;
constexpr double kSettled = 1e-4;  // modules
constexpr double kTiny = 1e-12;

//! The nearest point of a polyline. \param guess A piece to begin at; the found one afterwards.
Point nearestOf(Point p, const std::vector<Point>& line, bool closed) {
  double best = std::numeric_limits<double>::infinity();
  Point found;
  const std::size_t pieces = closed ? line.size() : line.size() - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Point foot = nearestOn(p, line[i], line[i + 1 == line.size() ? 0 : i + 1]);
    const Point miss = p - foot;
    const double square = dot(miss, miss);
    if (square < best) {
      best = square;
      found = foot;
    }
  }
  return found;
}

//! The quarter turn nearest to a direction.
Point quarterOf(Point turn) {
  if (std::abs(turn.u) >= std::abs(turn.v)) {
    return {turn.u < 0.0 ? -1.0 : 1.0, 0.0};
  }
  return {0.0, turn.v < 0.0 ? -1.0 : 1.0};
}

Point meanOf(const std::vector<Point>& points) {
  Point sum;
  for (const Point p : points) {
    sum = sum + p;
  }
  return (1.0 / static_cast<double>(points.size())) * sum;
}

//! Pairs of points of the curve, unplaced, and where they belong on the path.
struct Pairs {
  std::vector<Point> from;
  std::vector<Point> onto;
};

Point unplaced(const Placement& placement, Point p) {
  const Point turned = conjugate(placement.turn) * (p - placement.shift);
  return placement.mirrored ? conjugate(turned) : turned;
}

Pairs pairUp(const DrawnPath& path, const std::vector<Point>& curve, const Placement& placement) {
  std::vector<Point> placed;
  placed.reserve(curve.size());
  for (const Point p : curve) {
    placed.push_back(placement.apply(p));
  }
  Pairs pairs;
  for (const Point p : path.points) {
    pairs.from.push_back(unplaced(placement, nearestOf(p, placed, true)));
    pairs.onto.push_back(p);
  }
  for (std::size_t i = 0; path.closed && i < placed.size(); ++i) {
    pairs.from.push_back(curve[i]);
    pairs.onto.push_back(nearestOf(placed[i], path.points, true));
  }
  return pairs;
}

void measure(const DrawnPath& path, const Pairs& pairs, Match* match) {
  const std::size_t drawn = path.points.size();
  double there = 0.0;
  double back = 0.0;
  match->largest = 0.0;
  for (std::size_t i = 0; i < pairs.from.size(); ++i) {
    const double miss = length(match->placement.apply(pairs.from[i]) - pairs.onto[i]);
    (i < drawn ? there : back) += miss;
    match->largest = std::max(match->largest, miss);
  }
  there /= static_cast<double>(drawn);
  match->error =
      path.closed ? 0.5 * (there + back / static_cast<double>(pairs.from.size() - drawn)) : there;
}

}  // namespace

Placement fitted(const std::vector<Point>& points,
                 const std::vector<Point>& onto,
                 const Placement& start,
                 Turns turns) {
  Placement placement = start;
  Point mean = meanOf(points);
  mean = placement.mirrored ? conjugate(mean) : mean;
  const Point target = meanOf(onto);
  if (turns == Turns::kAny) {
    Point sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point p = (placement.mirrored ? conjugate(points[i]) : points[i]) - mean;
      sum = sum + conjugate(p) * (onto[i] - target);
    }
    const double size = length(sum);
    placement.turn = size > kTiny ? (1.0 / size) * sum : placement.turn;
  }
  placement.shift = target - placement.turn * mean;
  return placement;
}

std::pair<Placement, double> bestFit(const std::vector<Point>& points,
                                     const std::vector<Point>& onto,
                                     bool mirrored,
                                     Turns turns) {
  Placement start;
  start.mirrored = mirrored;
  Placement placement = fitted(points, onto, start, Turns::kAny);
  if (turns == Turns::kQuarter) {
    start.turn = quarterOf(placement.turn);
    placement = fitted(points, onto, start, turns);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point miss = placement.apply(points[i]) - onto[i];
    sum += dot(miss, miss);
  }
  return {placement, sum / static_cast<double>(points.size())};
}

Match refine(const DrawnPath& path,
             const std::vector<Point>& curve,
             const Placement& start,
             Turns turns) {
  Match match;
  match.placement = start;
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    const Pairs pairs = pairUp(path, curve, match.placement);
    measure(path, pairs, &match);
    if (round + 1 == kRounds || match.error > last - kSettled) {
      break;
    }
    last = match.error;
    match.placement = fitted(pairs.from, pairs.onto, match.placement, turns);
  }
  measure(path, pairUp(path, curve, match.placement), &match);
  return match;
}

}  // namespace liftarm::linkages
