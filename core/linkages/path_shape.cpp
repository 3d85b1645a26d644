#include "linkages/path_shape.h"

#include <algorithm>
#include <cstddef>

#include "base/index.h"
#include "linkages/four_bar.h"

namespace liftarm::linkages {

namespace {

using base::at;

}  // namespace

double lengthOf(const std::vector<Point>& line, bool closed) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    sum += length(line[i] - line[i - 1]);
  }
  return closed ? sum + length(line.front() - line.back()) : sum;
}

std::vector<Point> resample(const std::vector<Point>& line, bool closed, int count) {
  const double step = lengthOf(line, closed) / (closed ? count : count - 1);
  std::vector<Point> points;
  points.reserve(at(count));
  double before = 0.0;
  std::size_t i = 0;
  const std::size_t pieces = closed ? line.size() : line.size() - 1;
  double piece = length(line[1 % line.size()] - line[0]);
  for (int k = 0; k < count; ++k) {
    const double wanted = step * k;
    while (before + piece < wanted && i + 1 < pieces) {
      before += piece;
      ++i;
      piece = length(line[(i + 1) % line.size()] - line[i]);
    }
    const double share = piece > 0.0 ? std::min(1.0, (wanted - before) / piece) : 0.0;
    points.push_back(line[i] + share * (line[(i + 1) % line.size()] - line[i]));
  }
  return points;
}

const ShapePoints& rootsOfUnity() {
  static const ShapePoints roots = [] {
    const std::vector<Point> turns = turnsOf(kShapePoints);
    ShapePoints copied;
    std::copy(turns.begin(), turns.end(), copied.begin());
    return copied;
  }();
  return roots;
}

Coefficients coefficientsOf(const ShapePoints& points) {
  const ShapePoints& roots = rootsOfUnity();
  Coefficients found{};
  for (int order = 1; order <= kOrders; ++order) {
    Point forth;
    Point back;
    for (int i = 0; i < kShapePoints; ++i) {
      const Point root = roots[at(order * i % kShapePoints)];
      forth = forth + conjugate(root) * points[at(i)];
      back = back + root * points[at(i)];
    }
    found[at(2 * order - 2)] = (1.0 / kShapePoints) * forth;
    found[at(2 * order - 1)] = (1.0 / kShapePoints) * back;
  }
  return found;
}

std::array<float, kCoefficients> sizesOf(const Coefficients& coefficients) {
  std::array<float, kCoefficients> sizes{};
  const bool swapped = length(coefficients[1]) > length(coefficients[0]);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sizes[i] = static_cast<float>(length(coefficients[swapped ? i ^ 1U : i]));
  }
  return sizes;
}

}  // namespace liftarm::linkages
