#include "sketch/snap.h"

#include <algorithm>
#include <cmath>

#include "sketch/sketch_json.h"
#include "sketch/snap_solver.h"
#include "sketch/snap_system.h"

namespace liftarm::sketch {

namespace {

constexpr double kExact = 1e-9;  // modules: as good as whole

bool isWhole(const lattice::Vec3& point) {
  return point.x == std::floor(point.x) && point.y == std::floor(point.y) &&
         point.z == std::floor(point.z);
}

//! Nothing to do: the usual case, and the one where not a single bit may change.
bool liesOnLattice(const std::vector<Line>& lines) {
  return std::all_of(lines.begin(), lines.end(), [](const Line& line) {
    const double length = line.length;
    const lattice::Vec3 span = line.to - line.from;
    return isWhole(line.from) && isWhole(line.to) && lattice::dot(span, span) == length * length;
  });
}

//! Lets the whole coordinates of the worst lines move. A contradiction spreads over the lines
//! around it, so only those with at least half the largest residual are taken. \return False if
//! none was held.
bool releaseWorstLines(SnapSystem& system) {
  const double threshold = 0.5 * largestLengthResidual(system);
  bool released = false;
  for (const LengthRow& row : system.lengths) {
    if (std::abs(residualOf(system, row)) < threshold) {
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int variable : {row.from[axis], row.to[axis]}) {
        char& held = system.held[static_cast<std::size_t>(variable)];
        released = released || held != 0;
        held = 0;
      }
    }
  }
  return released;
}

//! Solves with the contacts of one strength and better.
void attempt(SnapSystem& system, const SketchVariables& variables, Contact weakest) {
  system.values = variables.values;
  system.linear.clear();
  for (const ContactRow& row : variables.contacts) {
    if (static_cast<int>(row.kind) <= static_cast<int>(weakest)) {
      system.linear.push_back(row.row);
    }
  }
  solveSnapSystem(system);
}

//! The values with the smallest error in length so far.
class Best {
 public:
  explicit Best(const SnapSystem& system)
      : values_(system.values), residual_(largestLengthResidual(system)) {}

  void offer(const SnapSystem& system) {
    const double residual = largestLengthResidual(system);
    if (residual < residual_) {
      residual_ = residual;
      values_ = system.values;
    }
  }

  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  std::vector<double> values_;
  double residual_;
};

//! Whole coordinates are held first, then released where lines are still wrong, at last everywhere.
void solve(SnapSystem& system, const SketchVariables& variables) {
  constexpr int kRounds = 8;
  Best best(system);
  for (int round = 0; round < kRounds && system.workLeft > 0; ++round) {
    for (const Contact weakest : {Contact::kCrossing, Contact::kEndPoint}) {
      attempt(system, variables, weakest);
      if (largestLengthResidual(system) <= kExact) {
        return;
      }
      best.offer(system);
    }
    if (!releaseWorstLines(system) || round + 2 >= kRounds) {
      std::fill(system.held.begin(), system.held.end(), char{0});
    }
  }
  system.values = variables.values;
  system.linear.clear();
  solveSnapSystem(system);
  best.offer(system);
  system.values = best.values();
}

//! Takes the rounding noise off values that are halves: 5 and not 5.000000000000001.
void tidy(std::vector<double>& values) {
  constexpr double kNoise = 1e-11;
  for (double& value : values) {
    const double half = 0.5 * std::round(2.0 * value) + 0.0;
    if (std::abs(value - half) <= kNoise) {
      value = half;
    }
  }
}

lattice::Vec3 pointOf(const SnapSystem& system, const std::array<int, 3>& vertex) {
  return {system.values[static_cast<std::size_t>(vertex[0])],
          system.values[static_cast<std::size_t>(vertex[1])],
          system.values[static_cast<std::size_t>(vertex[2])]};
}

double largestMove(const lattice::Vec3& before, const lattice::Vec3& after) {
  const lattice::Vec3 move = after - before;
  return std::max({std::abs(move.x), std::abs(move.y), std::abs(move.z)});
}

SnapReport snapOnce(std::vector<Line>& lines) {
  const SketchVariables variables = findVariables(lines, kLengthTolerance);
  SnapSystem system;
  system.values = variables.values;
  system.lengths = variables.lengths;
  system.held.reserve(system.values.size());
  for (const double value : system.values) {
    system.held.push_back(value == std::floor(value) ? char{1} : char{0});
  }
  for (const ContactRow& row : variables.contacts) {
    system.linear.push_back(row.row);
  }
  if (std::max(largestLengthResidual(system), largestLinearResidual(system)) > kExact) {
    solve(system, variables);
    tidy(system.values);
  }
  SnapReport report;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Line& line = lines[i];
    const lattice::Vec3 from = pointOf(system, variables.ends[i][0]);
    const lattice::Vec3 to = pointOf(system, variables.ends[i][1]);
    report.moved = std::max({report.moved, largestMove(line.from, from), largestMove(line.to, to)});
    const double residual = std::abs(lattice::length(to - from) - line.length);
    if (residual > report.residual) {
      report.residual = residual;
      report.worstLine = static_cast<int>(i);
    }
    line.from = from;
    line.to = to;
  }
  return report;
}

}  // namespace

SnapReport snapToWholeLengths(std::vector<Line>& lines) {
  if (liesOnLattice(lines)) {
    return {};
  }
  // What moved may now lie close to what was out of reach before; a drawing that people make is
  // done after the first pass, and the second finds nothing to move.
  constexpr int kPasses = 3;
  SnapReport report;
  for (int pass = 0; pass < kPasses; ++pass) {
    const SnapReport next = snapOnce(lines);
    report = {next.residual, report.moved + next.moved, next.worstLine};
    if (next.moved == 0.0 || next.residual > kExact) {
      break;
    }
  }
  return report;
}

lattice::Vec3 nodeOfLine(const Line& line, int index) {
  if (index == 0 || index == line.length) {
    return index == 0 ? line.from : line.to;
  }
  const double share = static_cast<double>(index) / static_cast<double>(line.length);
  return line.from + share * (line.to - line.from);
}

}  // namespace liftarm::sketch
