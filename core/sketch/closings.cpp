#include "sketch/closings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

constexpr int kReach = 12;  // modules that a span may change
constexpr std::size_t kMostClosings = 2;

std::optional<int> wholeRoot(int square) {
  const int root = static_cast<int>(std::lround(std::sqrt(static_cast<double>(square))));
  return root * root == square ? std::optional(root) : std::nullopt;
}

}  // namespace

std::vector<Closing> nearestClosings(const Line& line) {
  std::vector<int> spans;
  for (int axis = 0; axis < 3; ++axis) {
    const double span = std::abs((line.to - line.from)[axis]);
    if (!isSnapped(span)) {
      spans.push_back(static_cast<int>(std::lround(span)));
    }
  }
  if (spans.size() != 2) {
    return {};
  }
  // (change, first span, second span, length): 12 by 9 is 9 by 12.
  std::vector<std::tuple<int, int, int, int>> found;
  for (int a = std::max(1, spans[0] - kReach); a <= spans[0] + kReach; ++a) {
    for (int b = std::max(1, spans[1] - kReach); b <= spans[1] + kReach; ++b) {
      if (const std::optional<int> length = wholeRoot(a * a + b * b)) {
        const int change = std::abs(a - spans[0]) + std::abs(b - spans[1]);
        const bool swap = spans[0] == spans[1] && a > b;
        found.emplace_back(change, swap ? b : a, swap ? a : b, *length);
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Closing> closings;
  for (const auto& [change, a, b, length] : found) {
    if (closings.size() < kMostClosings) {
      closings.push_back({{a, b}, length});
    }
  }
  return closings;
}

std::string closingsText(const Line& line) {
  std::string text;
  for (const Closing& closing : nearestClosings(line)) {
    text += (text.empty() ? "; nearest that close: " : " or ") + std::to_string(closing.spans[0]) +
            " by " + std::to_string(closing.spans[1]) + " (length " +
            std::to_string(closing.length) + ")";
  }
  return text;
}

}  // namespace liftarm::sketch
