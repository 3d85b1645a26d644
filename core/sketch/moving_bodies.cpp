#include "sketch/moving_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/det_math.h"
#include "base/index.h"
#include "sketch/arrangement.h"
#include "sketch/point_index.h"

namespace liftarm::sketch {

namespace {

using base::at;

constexpr int kMostSteps = 12;
constexpr double kClosed = 1e-7;    // modules
constexpr double kDamping = 1e-10;  // keeps what nothing drives where it is

int rootOf(std::vector<int>& parents, int i) {
  while (parents[at(i)] != i) {
    parents[at(i)] = parents[at(parents[at(i)])];
    i = parents[at(i)];
  }
  return i;
}

//! The group of a joint that a line is in, or -1; by itself where the joint names no groups.
int groupOf(const Joint& joint, int line) {
  for (std::size_t g = 0; g < joint.between.size(); ++g) {
    if (std::find(joint.between[g].begin(), joint.between[g].end(), line) !=
        joint.between[g].end()) {
      return static_cast<int>(g);
    }
  }
  return joint.between.empty() ? line : -1;
}

}  // namespace

std::vector<int> bodiesOfLines(const Sketch& sketch) {
  PointIndex points(kSamePoint);
  std::vector<std::vector<int>> meeting;
  for (std::size_t l = 0; l < sketch.lines.size(); ++l) {
    const Line& line = sketch.lines[l];
    for (int k = 0; k <= line.length; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(line.length);
      const int point = points.findOrInsert(line.from + share * (line.to - line.from));
      meeting.resize(at(points.size()));
      meeting[at(point)].push_back(static_cast<int>(l));
    }
  }
  std::vector<std::vector<const Joint*>> joints(meeting.size());
  for (const Joint& joint : sketch.joints) {
    const int point = points.find(joint.at);
    if (point >= 0) {
      joints[at(point)].push_back(&joint);
    }
  }
  std::vector<int> parents(sketch.lines.size());
  std::iota(parents.begin(), parents.end(), 0);
  for (std::size_t p = 0; p < meeting.size(); ++p) {
    for (std::size_t i = 1; i < meeting[p].size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool together =
            std::all_of(joints[p].begin(), joints[p].end(), [&](const Joint* joint) {
              return groupOf(*joint, meeting[p][i]) == groupOf(*joint, meeting[p][j]);
            });
        if (together) {
          const int one = rootOf(parents, meeting[p][i]);
          const int other = rootOf(parents, meeting[p][j]);
          parents[at(std::max(one, other))] = std::min(one, other);
        }
      }
    }
  }
  std::vector<int> numbers(parents.size(), -1);
  std::vector<int> bodies;
  int count = 0;
  for (std::size_t l = 0; l < parents.size(); ++l) {
    int& number = numbers[at(rootOf(parents, static_cast<int>(l)))];
    number = number < 0 ? count++ : number;
    bodies.push_back(number);
  }
  return bodies;
}

std::pair<lattice::Axis, lattice::Axis> planeAcross(lattice::Vec3 axis) {
  int along = 0;
  for (int i = 1; i < 3; ++i) {
    along = std::abs(axis[i]) > std::abs(axis[along]) ? i : along;
  }
  const lattice::Axis u = lattice::axisFromIndex((along + 1) % 3);
  const lattice::Axis v = lattice::axisFromIndex((along + 2) % 3);
  return axis[along] > 0.0 ? std::pair{u, v} : std::pair{v, u};
}

PlaneLinkage::PlaneLinkage(std::vector<PlanePin> pins, int bodies, int driver)
    : pins_(std::move(pins)), driver_(driver), places_(at(bodies), -1), poses_(at(bodies)) {
  std::vector<char> reached(at(bodies), char{0});
  reached[at(pins_[at(driver)].a)] = char{1};
  for (bool grew = true; grew;) {
    grew = false;
    for (const PlanePin& pin : pins_) {
      if (reached[at(pin.a)] != reached[at(pin.b)]) {
        const int fresh = reached[at(pin.a)] != 0 ? pin.b : pin.a;
        reached[at(fresh)] = char{1};
        places_[at(fresh)] = static_cast<int>(unknowns_);
        unknowns_ += 3;
        grew = true;
      }
    }
  }
}

void PlaneLinkage::reset() {
  std::fill(poses_.begin(), poses_.end(), PlanePose{});
}

//! A pin (u, v) of the drawing lies, on a body, at c u - s v + x and s u + c v + y.
void PlaneLinkage::addEquations(double angle) {
  rows_.clear();
  misses_.clear();
  const auto row = [&](double miss) {
    misses_.push_back(miss);
    rows_.resize(rows_.size() + unknowns_, 0.0);
    return rows_.size() - unknowns_;
  };
  for (const PlanePin& pin : pins_) {
    if (places_[at(pin.a)] < 0 && places_[at(pin.b)] < 0) {
      continue;
    }
    const PlanePose& a = poses_[at(pin.a)];
    const PlanePose& b = poses_[at(pin.b)];
    const double ca = base::detCos(a.angle);
    const double sa = base::detSin(a.angle);
    const double cb = base::detCos(b.angle);
    const double sb = base::detSin(b.angle);
    const std::size_t u = row((cb * pin.u - sb * pin.v + b.u) - (ca * pin.u - sa * pin.v + a.u));
    const std::size_t v = row((sb * pin.u + cb * pin.v + b.v) - (sa * pin.u + ca * pin.v + a.v));
    const auto fill = [&](int place, double sign, double c, double s) {
      if (place >= 0) {
        rows_[u + at(place)] = sign;
        rows_[u + at(place) + 2] = sign * (-s * pin.u - c * pin.v);
        rows_[v + at(place) + 1] = sign;
        rows_[v + at(place) + 2] = sign * (c * pin.u - s * pin.v);
      }
    };
    fill(places_[at(pin.a)], -1.0, ca, sa);
    fill(places_[at(pin.b)], 1.0, cb, sb);
  }
  const PlanePin& driver = pins_[at(driver_)];
  const std::size_t turn = row(poses_[at(driver.b)].angle - poses_[at(driver.a)].angle - angle);
  if (places_[at(driver.b)] >= 0) {
    rows_[turn + at(places_[at(driver.b)]) + 2] = 1.0;
  }
}

double PlaneLinkage::error() const {
  double worst = 0.0;
  for (const double miss : misses_) {
    worst = std::max(worst, std::abs(miss));
  }
  return worst;
}

//! (J'J + damping) step = J' misses, by elimination.
bool PlaneLinkage::solveStep(std::vector<double>* step) {
  const std::size_t n = unknowns_;
  std::vector<double> matrix(n * (n + 1), 0.0);
  for (std::size_t r = 0; r < misses_.size(); ++r) {
    const double* row = rows_.data() + r * n;
    for (std::size_t i = 0; i < n; ++i) {
      if (row[i] == 0.0) {
        continue;
      }
      for (std::size_t j = 0; j < n; ++j) {
        matrix[i * (n + 1) + j] += row[i] * row[j];
      }
      matrix[i * (n + 1) + n] += row[i] * misses_[r];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    double* pivot = matrix.data() + i * (n + 1);
    pivot[i] += kDamping;
    if (!(pivot[i] > 0.0)) {
      return false;
    }
    for (std::size_t k = i + 1; k < n; ++k) {
      double* other = matrix.data() + k * (n + 1);
      const double factor = other[i] / pivot[i];
      for (std::size_t j = i; factor != 0.0 && j <= n; ++j) {
        other[j] -= factor * pivot[j];
      }
    }
  }
  step->assign(n, 0.0);
  for (std::size_t i = n; i-- > 0;) {
    double sum = matrix[i * (n + 1) + n];
    for (std::size_t j = i + 1; j < n; ++j) {
      sum -= matrix[i * (n + 1) + j] * (*step)[j];
    }
    (*step)[i] = sum / matrix[i * (n + 1) + i];
  }
  return true;
}

bool PlaneLinkage::turnTo(double angle) {
  const std::vector<PlanePose> before = poses_;
  std::vector<double> step;
  for (int i = 0; i < kMostSteps; ++i) {
    addEquations(angle);
    if (error() < kClosed) {
      return true;
    }
    if (!solveStep(&step)) {
      break;
    }
    for (std::size_t b = 0; b < poses_.size(); ++b) {
      if (places_[b] >= 0) {
        poses_[b].u -= step[at(places_[b])];
        poses_[b].v -= step[at(places_[b]) + 1];
        poses_[b].angle -= step[at(places_[b]) + 2];
      }
    }
  }
  poses_ = before;
  return false;
}

}  // namespace liftarm::sketch
