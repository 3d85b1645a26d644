#include "analysis/freedoms_braces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/index.h"
#include "model/number_text.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;

constexpr double kWhole = 0.01;   // modules from a whole length, and from a lattice plane
constexpr double kHelps = 0.02;   // stretch per unit of motion below which a brace hardly holds
constexpr int kShortest = 3;      // modules
constexpr double kAlong = 0.999;  // cosine: a brace along a line at its end would hide in it
constexpr double kSameNode = 0.01;

//! A node of the sketch and the beam that stands for it.
struct Node {
  Vec3 place;
  int line = -1;
  int part = -1;
};

struct BraceCandidate {
  Brace brace;
  double length = 0.0;
  std::vector<double> stretch;  // per motion, of the ends' distance, for a unit of length
};

std::vector<Node> nodesOf(const std::vector<EdgeCover>& coverage) {
  std::vector<Node> nodes;
  for (const EdgeCover& edge : coverage) {
    if (edge.covers.empty()) {
      continue;
    }
    for (const Vec3 place : {edge.from, edge.to}) {
      const bool known = !nodes.empty() && nodes.back().line == edge.line &&
                         lattice::length(nodes.back().place - place) < kSameNode;
      if (!known) {
        nodes.push_back({place, edge.line, edge.covers.front().part});
      }
    }
  }
  return nodes;
}

bool isWhole(double value) {
  return std::abs(value - std::floor(value + 0.5)) < kWhole;
}

//! Whether a line of the sketch can run here: whole length, in a lattice plane, not over lines.
bool isLine(const Scene& scene, const Node& p, const Node& q) {
  const Vec3 way = q.place - p.place;
  const double length = lattice::length(way);
  if (length < kShortest - kWhole || length > kLongestBrace + kWhole || !isWhole(length)) {
    return false;
  }
  const bool flat =
      std::abs(way.x) < kWhole || std::abs(way.y) < kWhole || std::abs(way.z) < kWhole;
  const auto runsAlong = [&](int line) {
    const sketch::Line& other = scene.sketch->lines[at(line)];
    return std::abs(lattice::dot(way, other.to - other.from)) >
           kAlong * length * lattice::length(other.to - other.from);
  };
  return flat && !runsAlong(p.line) && !runsAlong(q.line);
}

//! The motions that braces are to stop.
std::vector<const FreeMotion*> looseMotions(const Freedoms& freedoms) {
  std::vector<const FreeMotion*> motions;
  for (const FreeMotion& motion : freedoms.motions) {
    if (motion.joint < 0) {
      motions.push_back(&motion);
    }
  }
  return motions;
}

std::vector<BraceCandidate> candidatesOf(const Scene& scene,
                                         const std::vector<Node>& nodes,
                                         const Freedoms& freedoms) {
  const std::vector<const FreeMotion*> motions = looseMotions(freedoms);
  std::vector<BraceCandidate> candidates;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = i + 1; j < nodes.size(); ++j) {
      const Node& p = nodes[i];
      const Node& q = nodes[j];
      if (p.line == q.line || freedoms.groupOf[at(p.part)] == freedoms.groupOf[at(q.part)] ||
          !isLine(scene, p, q)) {
        continue;
      }
      BraceCandidate candidate;
      candidate.length = lattice::length(q.place - p.place);
      const Vec3 way = (1.0 / candidate.length) * (q.place - p.place);
      double most = 0.0;
      for (const FreeMotion* motion : motions) {
        const Vec3 ofP = motion->twists[at(p.part)].velocityAt(p.place);
        const Vec3 ofQ = motion->twists[at(q.part)].velocityAt(q.place);
        candidate.stretch.push_back(lattice::dot(ofQ - ofP, way));
        most = std::max(most, std::abs(candidate.stretch.back()));
      }
      if (most > kHelps) {
        candidate.brace = {{p.line, q.line}, p.place, q.place, ""};
        candidates.push_back(std::move(candidate));
      }
    }
  }
  return candidates;
}

double norm(const std::vector<double>& v) {
  double sum = 0.0;
  for (const double x : v) {
    sum += x * x;
  }
  return std::sqrt(sum);
}

}  // namespace

std::vector<Brace> findBraces(const Scene& scene,
                              const std::vector<EdgeCover>& coverage,
                              const Freedoms& freedoms) {
  std::vector<Brace> braces;
  if (!scene.sketch.has_value() || looseMotions(freedoms).empty()) {
    return braces;
  }
  std::vector<BraceCandidate> candidates = candidatesOf(scene, nodesOf(coverage), freedoms);
  for (std::size_t m = looseMotions(freedoms).size(); m > 0; --m) {
    const BraceCandidate* best = nullptr;
    double bestWorth = 0.0;
    for (const BraceCandidate& candidate : candidates) {
      // A short brace that holds as well saves material.
      const double stretch = norm(candidate.stretch);
      const double worth = stretch / (kShortest + candidate.length);
      if (stretch > kHelps && worth > bestWorth * (1 + 1e-9)) {
        best = &candidate;
        bestWorth = worth;
      }
    }
    if (best == nullptr) {
      break;
    }
    braces.push_back(best->brace);
    braces.back().message = "A line of " + model::numberText(std::round(best->length)) +
                            " modules from " + pointText(best->brace.from) + " to " +
                            pointText(best->brace.to) + " stops one of the free motions.";
    // What is left of each stretch beside what this brace stops.
    const std::vector<double> taken = best->stretch;
    const double square = norm(taken) * norm(taken);
    for (BraceCandidate& candidate : candidates) {
      double share = 0.0;
      for (std::size_t k = 0; k < taken.size(); ++k) {
        share += candidate.stretch[k] * taken[k] / square;
      }
      for (std::size_t k = 0; k < taken.size(); ++k) {
        candidate.stretch[k] -= share * taken[k];
      }
    }
  }
  return braces;
}

}  // namespace liftarm::analysis
