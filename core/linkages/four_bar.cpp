#include "linkages/four_bar.h"

#include <algorithm>

#include "base/det_math.h"
#include "base/index.h"

namespace liftarm::linkages {

namespace {

using base::at;

constexpr double kFullTurn = 2.0 * 3.14159265358979323846;
constexpr double kBeamWide = 0.995;  // modules between two beams that just pass
constexpr int kClearanceTurns = 90;
constexpr std::array<int, 8> kBeamEdges{1, 2, 4, 6, 8, 10, 12, 14};

int edgesOf(const CouplerBeam& beam) {
  return beam.first + beam.second;
}

Coupler makeCoupler(const CouplerBeam& beam, int side, std::array<int, 3> holes) {
  Coupler coupler{beam, side, holes[0], holes[1], holes[2], 0.0, {}};
  const Point crank = holeOf(beam, side, holes[0]);
  const Point span = holeOf(beam, side, holes[1]) - crank;
  coupler.length = length(span);
  const Point along = (1.0 / coupler.length) * span;
  coupler.point = (holeOf(beam, side, holes[2]) - crank) * conjugate(along);
  return coupler;
}

//! A straight beam of `edges` whose ends are both in use, each up to reversal.
void addStraight(int edges, std::vector<Coupler>* couplers) {
  for (int a = 0; a <= edges; ++a) {
    for (int b = a + 1; b <= edges; ++b) {
      for (int p = 0; p <= edges; ++p) {
        const bool whole = std::min(a, p) == 0 && std::max(b, p) == edges;
        if (p != a && p != b && whole) {
          couplers->push_back(makeCoupler({edges, 0, -1.0}, 1, {a, b, p}));
        }
      }
    }
  }
}

//! A bent beam whose three holes are not all on one arm.
void addBent(const CouplerBeam& beam, std::vector<Coupler>* couplers) {
  const int edges = edgesOf(beam);
  for (const int side : {1, -1}) {
    for (int a = 0; a <= edges; ++a) {
      for (int b = 0; b <= edges; ++b) {
        for (int p = 0; p <= edges; ++p) {
          const bool straight =
              std::max({a, b, p}) <= beam.first || std::min({a, b, p}) >= beam.first;
          if (a != b && p != a && p != b && !straight) {
            couplers->push_back(makeCoupler(beam, side, {a, b, p}));
          }
        }
      }
    }
  }
}

//! How far a link of this length may stick out past its pins.
double overhangOf(int edges) {
  return std::find(kBeamEdges.begin(), kBeamEdges.end(), edges) == kBeamEdges.end() ? 1.0 : 0.0;
}

}  // namespace

Point holeOf(const CouplerBeam& beam, int side, int hole) {
  if (beam.second == 0) {
    return {static_cast<double>(hole), 0.0};
  }
  if (hole <= beam.first) {
    return {static_cast<double>(beam.first - hole), 0.0};
  }
  const double sine = std::sqrt(1.0 - beam.cosine * beam.cosine);
  const double far = static_cast<double>(hole - beam.first);
  return {far * beam.cosine, far * sine * side};
}

std::vector<Coupler> allCouplers(int mostEdges) {
  std::vector<Coupler> couplers;
  for (int edges = 2; edges <= mostEdges; ++edges) {
    addStraight(edges, &couplers);
  }
  for (const CouplerBeam& beam : kBentCouplers) {
    addBent(beam, &couplers);
  }
  return couplers;
}

FourBarPose poseOf(const FourBar& bar, Point turn) {
  FourBarPose pose;
  pose.crankPin = static_cast<double>(bar.crank) * turn;
  const Point span = Point{static_cast<double>(bar.frame), 0.0} - pose.crankPin;
  const double far = length(span);
  const double b = bar.coupler.length;
  const double c = bar.rocker;
  const double along = (b * b - c * c + far * far) / (2.0 * far);
  const double across = std::sqrt(std::max(0.0, b * b - along * along));
  const Point direction = (1.0 / (far * b)) * (span * Point{along, across});
  pose.rockerPin = pose.crankPin + b * direction;
  pose.point = pose.crankPin + direction * bar.coupler.point;
  return pose;
}

bool isCrankRocker(int crank, double coupler, int rocker, int frame) {
  const double shortest = crank;
  const std::array<double, 3> others{
      coupler, static_cast<double>(rocker), static_cast<double>(frame)};
  const double longest = *std::max_element(others.begin(), others.end());
  const double sum = others[0] + others[1] + others[2] - longest;
  return shortest < *std::min_element(others.begin(), others.end()) && shortest + longest < sum;
}

double transmissionCosine(int crank, double coupler, int rocker, int frame) {
  double most = 0.0;
  for (const int sign : {-1, 1}) {
    const double far = frame + sign * crank;
    most = std::max(
        most, std::abs(coupler * coupler + rocker * rocker - far * far) / (2.0 * coupler * rocker));
  }
  return most;
}

bool crankPassesRocker(int crank, double coupler, int rocker, int frame) {
  FourBar bar;
  bar.crank = crank;
  bar.rocker = rocker;
  bar.frame = frame;
  bar.coupler.length = coupler;
  const Point pivot{static_cast<double>(frame), 0.0};
  const double crankOver = overhangOf(crank);
  const double rockerOver = overhangOf(rocker);
  const std::vector<Point> turns = turnsOf(kClearanceTurns);
  return std::all_of(turns.begin(), turns.end(), [&](Point turn) {
    const FourBarPose pose = poseOf(bar, turn);
    const Point out = (rockerOver / rocker) * (pose.rockerPin - pivot);
    return distanceBetween(-crankOver * turn,
                           pose.crankPin + crankOver * turn,
                           pivot - out,
                           pose.rockerPin + out) >= kBeamWide;
  });
}

std::vector<std::array<int, 3>> crankRockers(double coupler, const FourBarLimits& limits) {
  const double leastCosine = base::detCos(limits.leastTransmission * kFullTurn / 360.0);
  std::vector<std::array<int, 3>> found;
  for (int crank = 1; crank <= limits.mostCrank; ++crank) {
    for (int rocker = crank + 1; rocker <= limits.mostRocker; ++rocker) {
      for (int frame = crank + 1; frame <= limits.mostFrame; ++frame) {
        if (isCrankRocker(crank, coupler, rocker, frame) &&
            transmissionCosine(crank, coupler, rocker, frame) <= leastCosine &&
            crankPassesRocker(crank, coupler, rocker, frame)) {
          found.push_back({crank, rocker, frame});
        }
      }
    }
  }
  return found;
}

std::vector<Point> turnsOf(int count) {
  std::vector<Point> turns(at(count));
  for (int i = 0; i < count; ++i) {
    const double angle = kFullTurn * i / count;
    turns[at(i)] = {base::detCos(angle), base::detSin(angle)};
  }
  return turns;
}

}  // namespace liftarm::linkages
