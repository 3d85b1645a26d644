#include "linkages/linkage_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/det_math.h"
#include "base/index.h"
#include "lattice/vec.h"

namespace liftarm::linkages {

namespace {

using base::at;

constexpr int kTurns = 72;                  // of the crank, for a curve
constexpr int kFineTurns = 120;             // where it is compared exactly
constexpr int kPathPoints = 64;             // of the path there
constexpr double kUnit = 1.0 / 256.0;       // modules that stored coordinates count
constexpr std::size_t kNearest = 400;       // curves that are laid on the path
constexpr std::size_t kRefined = 40;        // of those compared exactly
constexpr std::size_t kNearestFeet = 3000;  // most of which lie above their pivots
constexpr int kWindowPoints = 5;            // of a stretch of a curve that an open path may be like
constexpr double kLongLoop = 12.0;  // an open path's length, at most: more is hardly its tool
constexpr double kDegrees = 180.0 / 3.14159265358979323846;
constexpr double kAboveGround = 1.0;  // modules from a walker's pivot to its sole

// What a builder weighs beside the error, in millimetres of error.
constexpr double kOverhangWorth = 0.02;       // each beam that sticks out
constexpr double kTransmissionWorth = 0.002;  // each degree that is missing of 90
constexpr double kSizeWorth = 0.004;          // each module of links

std::vector<Point> curveOf(const FourBar& bar, const std::vector<Point>& turns) {
  std::vector<Point> curve;
  curve.reserve(turns.size());
  for (const Point turn : turns) {
    curve.push_back(poseOf(bar, turn).point);
  }
  return curve;
}

ShapePoints shapeOf(const std::vector<Point>& curve) {
  const std::vector<Point> points = resample(curve, true, kShapePoints);
  ShapePoints shape;
  std::copy(points.begin(), points.end(), shape.begin());
  return shape;
}

Point sampleAt(const ShapePoints& points, double place) {
  const double turns = std::floor(place / kShapePoints);
  const double inside = place - turns * kShapePoints;
  const int low = std::min(static_cast<int>(inside), kShapePoints - 1);
  const Point from = points[at(low)];
  return from + (inside - low) * (points[at((low + 1) % kShapePoints)] - from);
}

//! Keeps the nearest so many, the nearest first; equal ones by their number.
template <typename T>
void keepNearest(std::vector<T>* list, std::size_t most) {
  const auto less = [](const T& a, const T& b) {
    return std::tie(a.distance, a.entry) < std::tie(b.distance, b.entry);
  };
  const std::size_t kept = std::min(most, list->size());
  std::partial_sort(
      list->begin(), list->begin() + static_cast<std::ptrdiff_t>(kept), list->end(), less);
  list->resize(kept);
}

int oddBeams(const FourBar& bar) {
  const auto odd = [](int edges) { return edges > 2 && edges % 2 == 1 ? 1 : 0; };
  return odd(bar.crank) + odd(bar.rocker) + odd(bar.frame) +
         (bar.coupler.beam.second == 0 ? odd(bar.coupler.beam.first) : 0);
}

double scoreOf(const LinkageAnswer& answer) {
  const FourBar& bar = answer.bar;
  const double size =
      bar.crank + bar.rocker + bar.frame + bar.coupler.beam.first + bar.coupler.beam.second;
  return lattice::kMillimetresPerModule * answer.match.error + kOverhangWorth * oddBeams(bar) +
         kTransmissionWorth * (90.0 - answer.transmission) + kSizeWorth * size;
}

double degreesOf(double cosine) {
  return kDegrees * base::detAtan2(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine);
}

}  // namespace

LinkageTable::LinkageTable(const FourBarLimits& limits)
    : limits_(limits), couplers_(allCouplers(limits.mostCoupler)) {
  // Couplers of one length have the same links.
  std::stable_sort(couplers_.begin(), couplers_.end(), [](const Coupler& a, const Coupler& b) {
    return a.length < b.length - 1e-9;
  });
}

double LinkageTable::fraction() const {
  return static_cast<double>(next_) / static_cast<double>(couplers_.size());
}

FourBar LinkageTable::barOf(const Entry& entry) const {
  return {entry.crank, entry.rocker, entry.frame, couplers_[entry.coupler]};
}

ShapePoints LinkageTable::pointsOf(const Entry& entry) {
  ShapePoints points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {kUnit * entry.points[2 * i], kUnit * entry.points[2 * i + 1]};
  }
  return points;
}

bool LinkageTable::advance(int couplers) {
  const int last = std::min(next_ + couplers, static_cast<int>(couplers_.size()));
  const bool ends = next_ < last && last == static_cast<int>(couplers_.size());
  for (; next_ < last; ++next_) {
    addCurves(next_);
  }
  if (ends) {
    finish();
  }
  return next_ == static_cast<int>(couplers_.size());
}

void LinkageTable::addCurves(int number) {
  const Coupler& coupler = couplers_[at(number)];
  if (number == 0 || coupler.length > couplers_[at(number - 1)].length + 1e-9) {
    links_ = crankRockers(coupler.length, limits_);
  }
  static const std::vector<Point> turns = turnsOf(kTurns);
  for (const auto& [crank, rocker, frame] : links_) {
    const std::vector<Point> curve = curveOf({crank, rocker, frame, coupler}, turns);
    const ShapePoints shape = shapeOf(curve);
    Entry entry;
    entry.coupler = static_cast<std::uint16_t>(number);
    entry.crank = static_cast<std::uint8_t>(crank);
    entry.rocker = static_cast<std::uint8_t>(rocker);
    entry.frame = static_cast<std::uint8_t>(frame);
    entry.perimeter = static_cast<float>(lengthOf(curve, true));
    entry.sizes = sizesOf(coefficientsOf(shape));
    for (std::size_t i = 0; i < shape.size(); ++i) {
      entry.points[2 * i] = static_cast<std::int16_t>(std::lround(shape[i].u / kUnit));
      entry.points[2 * i + 1] = static_cast<std::int16_t>(std::lround(shape[i].v / kUnit));
    }
    entries_.push_back(entry);
  }
}

void LinkageTable::finish() {
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.sizes[0] < b.sizes[0];
  });
}

//! Where a curve comes nearest to a closed path by its coefficients, over all starts, both ways
//! round and both mirrors.
void LinkageTable::placeClosed(const ShapePoints& drawn, Turns turns, Candidate* candidate) const {
  const ShapePoints points = pointsOf(entries_[at(candidate->entry)]);
  std::vector<Point> from(points.begin(), points.end());
  const Coefficients wanted = coefficientsOf(drawn);
  Coefficients mine = coefficientsOf(points);
  std::vector<Point> onto(from.size());
  candidate->distance = 1e18;
  for (const int way : {1, -1}) {
    for (const bool mirrored : {false, true}) {
      // A mirrored curve has the conjugate coefficients of the opposite orders; so has, without the
      // conjugate, one that is gone round the other way.
      int best = 0;
      double most = -1.0;
      for (int start = 0; start < kShapePoints; ++start) {
        Point sum;
        for (int k = 0; k < kCoefficients; ++k) {
          const int order = (k / 2 + 1) * (k % 2 == 0 ? 1 : -1);
          const bool swapped = mirrored != (way < 0);
          Point c = mine[at(swapped ? k ^ 1 : k)];
          c = mirrored ? conjugate(c) : c;
          const int turn = ((order * start) % kShapePoints + kShapePoints) % kShapePoints;
          sum = sum + (rootsOfUnity()[at(turn)] * c) * conjugate(wanted[at(k)]);
        }
        if (length(sum) > most) {
          most = length(sum);
          best = start;
        }
      }
      for (int i = 0; i < kShapePoints; ++i) {
        const int place = ((way * (i + best)) % kShapePoints + kShapePoints) % kShapePoints;
        from[at(i)] = points[at(place)];
        onto[at(i)] = drawn[at(i)];
      }
      const auto [placement, distance] = bestFit(from, onto, mirrored, turns);
      if (distance < candidate->distance) {
        candidate->distance = distance;
        candidate->placement = placement;
      }
    }
  }
}

std::vector<LinkageTable::Candidate> LinkageTable::likeClosed(const PathQuestion& question) const {
  const ShapePoints drawn = shapeOf(question.path.points);
  const Coefficients coefficients = coefficientsOf(drawn);
  std::array<float, kCoefficients> wanted = sizesOf(coefficients);
  std::vector<Candidate> near;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const Entry& entry = entries_[e];
    double straight = 0.0;
    double swapped = 0.0;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const double one = entry.sizes[k] - wanted[k];
      const double other = entry.sizes[k] - wanted[k ^ 1U];
      straight += one * one;
      swapped += other * other;
    }
    near.push_back({static_cast<int>(e), std::min(straight, swapped), {}});
  }
  keepNearest(&near, question.kind == PathKind::kFoot ? kNearestFeet : kNearest);
  for (Candidate& candidate : near) {
    placeClosed(drawn, question.turns, &candidate);
  }
  near.erase(
      std::remove_if(near.begin(),
                     near.end(),
                     [&](const Candidate& candidate) { return !suits(candidate, question); }),
      near.end());
  keepNearest(&near, kRefined);
  return near;
}

namespace {

//! Distances between five points: what neither place nor turn nor mirror changes.
using Chords = std::array<double, 5>;

Chords chordsOf(const std::array<Point, kWindowPoints>& p) {
  return {length(p[4] - p[0]),
          length(p[2] - p[0]),
          length(p[4] - p[2]),
          length(p[3] - p[1]),
          length(p[3] - p[0])};
}

}  // namespace

std::vector<LinkageTable::Candidate> LinkageTable::likeOpen(const PathQuestion& question) const {
  struct Window {
    int entry = -1;
    double distance = 0.0;
    int start = 0;
    int way = 1;
  };

  const double far = lengthOf(question.path.points, false);
  const std::vector<Point> few = resample(question.path.points, false, kWindowPoints);
  std::array<Point, kWindowPoints> drawn{few[0], few[1], few[2], few[3], few[4]};
  const Chords forth = chordsOf(drawn);
  std::reverse(drawn.begin(), drawn.end());
  const Chords back = chordsOf(drawn);
  std::vector<Window> windows;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const Entry& entry = entries_[e];
    if (entry.perimeter < far || entry.perimeter > kLongLoop * far) {
      continue;
    }
    const ShapePoints points = pointsOf(entry);
    const double step = far / entry.perimeter * kShapePoints / (kWindowPoints - 1);
    Window best{static_cast<int>(e), 1e18, 0, 1};
    for (int start = 0; start < kShapePoints; ++start) {
      std::array<Point, kWindowPoints> window;
      for (int i = 0; i < kWindowPoints; ++i) {
        window[at(i)] = sampleAt(points, start + i * step);
      }
      const Chords mine = chordsOf(window);
      double same = 0.0;
      double other = 0.0;
      for (std::size_t k = 0; k < mine.size(); ++k) {
        same += (mine[k] - forth[k]) * (mine[k] - forth[k]);
        other += (mine[k] - back[k]) * (mine[k] - back[k]);
      }
      if (std::min(same, other) < best.distance) {
        best = {static_cast<int>(e), std::min(same, other), start, same <= other ? 1 : -1};
      }
    }
    windows.push_back(best);
  }
  keepNearest(&windows, kNearest);
  std::vector<Candidate> near;
  const std::vector<Point> onto = resample(question.path.points, false, kShapePoints / 2 + 1);
  for (const Window& window : windows) {
    const Entry& entry = entries_[at(window.entry)];
    const ShapePoints points = pointsOf(entry);
    const double step = far / entry.perimeter * kShapePoints / static_cast<double>(onto.size() - 1);
    for (const bool mirrored : {false, true}) {
      for (const int way : {1, -1}) {
        std::vector<Point> from;
        for (std::size_t i = 0; i < onto.size(); ++i) {
          const std::size_t place = way > 0 ? i : onto.size() - 1 - i;
          from.push_back(sampleAt(points, window.start + static_cast<double>(place) * step));
        }
        const auto [placement, distance] = bestFit(from, onto, mirrored, question.turns);
        const Candidate candidate{window.entry, distance, placement};
        if (suits(candidate, question)) {
          near.push_back(candidate);
        }
      }
    }
  }
  keepNearest(&near, kRefined);
  return near;
}

//! A walker's pivots are above the ground.
bool LinkageTable::suits(const Candidate& candidate, const PathQuestion& question) const {
  if (question.kind != PathKind::kFoot) {
    return true;
  }
  double lowest = 1e18;
  for (const Point p : question.path.points) {
    lowest = std::min(lowest, p.v);
  }
  const double frame = entries_[at(candidate.entry)].frame;
  const Placement& placement = candidate.placement;
  return std::min(placement.apply({0.0, 0.0}).v, placement.apply({frame, 0.0}).v) >=
         lowest + kAboveGround;
}

std::vector<LinkageAnswer> LinkageTable::find(const PathQuestion& question) const {
  static const std::vector<Point> turns = turnsOf(kFineTurns);
  const std::vector<Candidate> near =
      question.path.closed ? likeClosed(question) : likeOpen(question);
  DrawnPath path = question.path;
  path.points = resample(path.points, path.closed, kPathPoints);
  std::vector<std::pair<double, LinkageAnswer>> answers;
  for (const Candidate& candidate : near) {
    LinkageAnswer answer;
    answer.bar = barOf(entries_[at(candidate.entry)]);
    answer.match = refine(path, curveOf(answer.bar, turns), candidate.placement, question.turns);
    answer.transmission = degreesOf(transmissionCosine(
        answer.bar.crank, answer.bar.coupler.length, answer.bar.rocker, answer.bar.frame));
    if (suits({candidate.entry, 0.0, answer.match.placement}, question)) {
      answers.emplace_back(scoreOf(answer), answer);
    }
  }
  std::stable_sort(answers.begin(), answers.end(), [](const auto& a, const auto& b) {
    return a.first < b.first;
  });
  std::vector<LinkageAnswer> best;
  for (const auto& [score, answer] : answers) {
    const FourBar& bar = answer.bar;
    const bool known = std::any_of(best.begin(), best.end(), [&](const LinkageAnswer& other) {
      return other.bar.crank == bar.crank && other.bar.rocker == bar.rocker &&
             other.bar.frame == bar.frame &&
             std::abs(other.bar.coupler.length - bar.coupler.length) < 1e-9;
    });
    if (!known && static_cast<int>(best.size()) < question.most) {
      best.push_back(answer);
    }
  }
  return best;
}

}  // namespace liftarm::linkages
