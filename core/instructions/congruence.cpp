#include "instructions/congruence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "analysis/union_find.h"

namespace liftarm::instructions {

namespace {

using analysis::Scene;
using lattice::Mat3;
using lattice::Vec3;

//! A point that tells parts apart: what it is, and where, in hundredths of a module.
using Mark = std::array<int, 4>;

//! A part as its number and its marks in order.
using Figure = std::pair<std::string, std::vector<Mark>>;

struct Transform {
  Mat3 turn;
  bool mirrored = false;
  Vec3 shift;

  [[nodiscard]] Vec3 apply(Vec3 p) const {
    return turn * (mirrored ? Vec3{-p.x, p.y, p.z} : p) + shift;
  }
};

Mark markAt(int kind, Vec3 p) {
  // Numbers of models are multiples of a hundredth or irrational: the offset keeps rounding away.
  const auto whole = [](double x) { return static_cast<int>(std::floor(100.0 * x + 0.37)); };
  return {kind, whole(p.x), whole(p.y), whole(p.z)};
}

Figure figureOf(const Scene& scene, int index, const Transform& transform) {
  const auto i = static_cast<std::size_t>(index);
  const parts::Part& part = *scene.parts[i].part;
  const lattice::Pose& pose = scene.model->parts[i].pose;
  Figure figure{part.id, {}};
  const auto add = [&](int kind, Vec3 p) {
    figure.second.push_back(markAt(kind, transform.apply(pose.apply(p))));
  };
  for (const parts::Feature& feature : part.features) {
    const Vec3 half = (feature.length / 2) * feature.axis;
    add(static_cast<int>(feature.kind), feature.center - half);
    add(static_cast<int>(feature.kind), feature.center + half);
  }
  constexpr int kCollar = 4;
  constexpr int kSolid = 5;
  for (const parts::Prism& collar : part.collars) {
    add(kCollar, collar.from);
  }
  for (const parts::Prism& solid : part.solid) {
    add(kSolid, 0.5 * (solid.from + solid.to));
  }
  std::sort(figure.second.begin(), figure.second.end());
  return figure;
}

Vec3 middleOf(const Scene& scene, const std::vector<int>& parts) {
  Vec3 sum;
  for (const int index : parts) {
    const auto i = static_cast<std::size_t>(index);
    const parts::Part& part = *scene.parts[i].part;
    sum = sum + scene.model->parts[i].pose.apply(0.5 * (part.boundsMin + part.boundsMax));
  }
  return (1.0 / static_cast<double>(parts.size())) * sum;
}

std::vector<std::string> numbersOf(const Scene& scene, const std::vector<int>& parts) {
  std::vector<std::string> numbers;
  for (const int part : parts) {
    numbers.push_back(scene.model->parts[static_cast<std::size_t>(part)].part);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

//! How many parts are turned just as the match says, and not the other way round.
std::size_t countExact(const Scene& scene, const std::vector<int>& first, const Match& match) {
  std::size_t exact = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Mat3 turned =
        match.pose.rotation * scene.model->parts[static_cast<std::size_t>(first[i])].pose.rotation;
    const Mat3& own = scene.model->parts[static_cast<std::size_t>(match.parts[i])].pose.rotation;
    bool same = true;
    for (std::size_t k = 0; k < own.m.size(); ++k) {
      same = same && std::abs(turned.m[k] - own.m[k]) < 1e-3;
    }
    exact += same ? 1 : 0;
  }
  return exact;
}

bool isStraightPin(const Scene& scene, int index) {
  const parts::Part& part = *scene.parts[static_cast<std::size_t>(index)].part;
  return part.partClass == parts::PartClass::kPin &&
         std::all_of(part.features.begin(), part.features.end(), [&](const auto& feature) {
           return parts::isMale(feature.kind) &&
                  std::abs(lattice::dot(feature.axis, part.features.front().axis)) > 0.99;
         });
}

//! Flat frames: see the header. Repeated or not, in order of their first part.
std::vector<std::vector<int>> flatFrames(const Scene& scene) {
  const std::size_t count = scene.parts.size();
  analysis::UnionFind groups(count);
  std::vector<int> beamsOf(count,
                           -1);  // pins: one of the beams they are in; -2: in other parts too
  const auto isBeam = [&](int part) {
    const parts::Part* known = scene.parts[static_cast<std::size_t>(part)].part;
    return known->partClass == parts::PartClass::kBeam;
  };
  for (const model::Connection& c : scene.connections) {
    if (!isGood(c.fit)) {
      continue;
    }
    int& beam = beamsOf[static_cast<std::size_t>(c.male)];
    if (!isStraightPin(scene, c.male) || !isBeam(c.female)) {
      beam = -2;
    } else if (beam >= 0) {
      groups.join(beam, c.female);
    } else if (beam == -1) {
      beam = c.female;
    }
  }
  std::map<int, std::vector<int>> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const int part = static_cast<int>(i);
    if (scene.parts[i].part == nullptr) {
      continue;
    }
    if (isBeam(part)) {
      frames[groups.find(part)].push_back(part);
    } else if (beamsOf[i] >= 0) {
      frames[groups.find(beamsOf[i])].push_back(part);
    }
  }
  std::vector<std::vector<int>> result;
  for (auto& [root, frame] : frames) {
    constexpr std::size_t kLeast = 3;
    if (frame.size() >= kLeast && 2 * frame.size() <= count) {
      result.push_back(std::move(frame));
    }
  }
  return result;
}

}  // namespace

std::optional<Match> findMatch(const Scene& scene,
                               const std::vector<int>& first,
                               const std::vector<int>& second) {
  if (first.size() != second.size() || numbersOf(scene, first) != numbersOf(scene, second)) {
    return std::nullopt;
  }
  std::map<Figure, int> target;
  for (const int part : second) {
    target.emplace(figureOf(scene, part, {}), part);
  }
  const Vec3 from = middleOf(scene, first);
  const Vec3 to = middleOf(scene, second);
  std::optional<Match> best;
  std::size_t mostExact = 0;
  for (const bool mirrored : {false, true}) {
    for (const Mat3& turn : lattice::latticeRotations()) {
      Transform transform{turn, mirrored, {}};
      transform.shift = to - transform.apply(from);
      Match match{{}, mirrored, {transform.shift, turn}};
      for (const int part : first) {
        const auto found = target.find(figureOf(scene, part, transform));
        if (found == target.end()) {
          break;
        }
        match.parts.push_back(found->second);
      }
      if (match.parts.size() < first.size()) {
        continue;
      }
      const std::size_t exact = mirrored ? 0 : countExact(scene, first, match);
      if (!best.has_value() || exact > mostExact) {
        mostExact = exact;
        best = std::move(match);
      }
    }
    if (best.has_value()) {
      return best;
    }
  }
  return best;
}

std::vector<std::vector<int>> findRepeatedFrames(const Scene& scene) {
  const std::vector<std::vector<int>> frames = flatFrames(scene);
  std::vector<char> repeated(frames.size(), 0);
  for (std::size_t a = 0; a < frames.size(); ++a) {
    for (std::size_t b = a + 1; b < frames.size(); ++b) {
      if ((repeated[a] == 0 || repeated[b] == 0) && findMatch(scene, frames[a], frames[b])) {
        repeated[a] = repeated[b] = 1;
      }
    }
  }
  std::vector<std::vector<int>> result;
  for (std::size_t a = 0; a < frames.size(); ++a) {
    if (repeated[a] != 0) {
      result.push_back(frames[a]);
    }
  }
  return result;
}

}  // namespace liftarm::instructions
