#include "sketch/symmetry_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.h"
#include "sketch/arrangement.h"
#include "sketch/point_index.h"
#include "sketch/point_symmetry.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

using base::at;
using lattice::Mat3;
using lattice::Vec3;

constexpr double kSame = kLengthTolerance;
constexpr double kSameDirection = 1e-3;
constexpr std::size_t kMostLines = 600;  // for what is looked for pair by pair
constexpr int kMostPieces = 16;

bool near(Vec3 a, Vec3 b, double tolerance) {
  return lattice::length(a - b) < tolerance;
}

//! One of v and -v: the one whose first component that is not zero is positive.
Vec3 canonical(Vec3 v) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(v[i]) > kSameDirection) {
      return v[i] < 0.0 ? -v : v;
    }
  }
  return v;
}

//! A number without the rounding errors of its computation, so that files stay readable.
double tidy(double v) {
  const double rounded = std::floor(v * 1e9 + 0.5) / 1e9;
  return rounded == 0.0 ? 0.0 : rounded;
}

Vec3 tidy(Vec3 v) {
  return {tidy(v.x), tidy(v.y), tidy(v.z)};
}

double traceOf(const Mat3& a) {
  return a.m[0] + a.m[4] + a.m[8];
}

bool isMirror(const Mat3& a) {
  // Of the maps that turn space inside out, a mirror alone has two directions that stay.
  return lattice::determinant(a) < 0.0 && std::abs(traceOf(a) - 1.0) < kSameDirection;
}

//! The direction that (sign * a) turns round: sign -1 for a mirror, 1 for a rotation.
Vec3 axisOf(const Mat3& a) {
  // For a mirror 1 - a is twice the square of its normal; a rotation's axis is square to all rows
  // of a - 1.
  if (isMirror(a)) {
    int best = 0;
    for (int i = 1; i < 3; ++i) {
      best = a.m[at(4 * i)] < a.m[at(4 * best)] ? i : best;
    }
    Vec3 column;
    for (int i = 0; i < 3; ++i) {
      column[i] = (i == best ? 1.0 : 0.0) - a.m[at(3 * i + best)];
    }
    return canonical(lattice::normalized(column));
  }
  std::array<Vec3, 3> rows;
  for (int i = 0; i < 3; ++i) {
    rows[at(i)] = {a.m[at(3 * i)], a.m[at(3 * i + 1)], a.m[at(3 * i + 2)]};
    rows[at(i)][i] -= 1.0;
  }
  Vec3 best;
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
    const Vec3 across = lattice::cross(rows[at(i)], rows[at(j)]);
    best = lattice::length(across) > lattice::length(best) ? across : best;
  }
  return canonical(lattice::normalized(best));
}

Symmetry mirrorAt(Vec3 normal, double offset) {
  Symmetry symmetry;
  symmetry.kind = Symmetry::Kind::kReflection;
  symmetry.normal = tidy(normal);
  symmetry.offset = tidy(offset);
  return symmetry;
}

bool samePlane(const Symmetry& a, const Symmetry& b) {
  return near(a.normal, b.normal, kSameDirection) && std::abs(a.offset - b.offset) < kSame;
}

//! Whether a shift is a sum of multiples of those, all at most three and independent.
bool spans(const std::vector<Vec3>& shifts, Vec3 shift) {
  const Vec3 unit = lattice::normalized(shift);
  switch (shifts.size()) {
    case 0:
      return false;
    case 1:
      return lattice::length(lattice::cross(lattice::normalized(shifts[0]), unit)) < kSame;
    case 2:
      return std::abs(lattice::dot(lattice::normalized(lattice::cross(shifts[0], shifts[1])),
                                   unit)) < kSame;
    default:
      return true;
  }
}

//! Lines that lie in one place: `image` is `line` moved by a map.
bool isImage(const Line& image, Vec3 from, Vec3 to) {
  return (near(image.from, from, kSame) && near(image.to, to, kSame)) ||
         (near(image.from, to, kSame) && near(image.to, from, kSame));
}

bool sameHoleAxis(const Line& a, const Line& b) {
  return a.exact == b.exact && a.holeAxis == b.holeAxis;
}

//! The direction across a flat sketch; zero when it is not flat.
Vec3 flatNormal(const Arrangement& arrangement) {
  Vec3 normal;
  const Vec3 origin = arrangement.nodes.front().position;
  for (const ArrangedNode& a : arrangement.nodes) {
    for (const Run& run : arrangement.runs) {
      const Vec3 across = lattice::cross(a.position - origin, run.direction);
      normal = lattice::length(across) > lattice::length(normal) ? across : normal;
    }
    if (lattice::length(normal) > 1.0) {
      break;
    }
  }
  const bool flat = std::all_of(
      arrangement.nodes.begin(), arrangement.nodes.end(), [&](const ArrangedNode& node) {
        return std::abs(lattice::dot(normal, node.position - origin)) <
               kSame * lattice::length(normal);
      });
  return flat ? normal : Vec3{};
}

//! Mirrors across principal directions before diagonal ones, and those before others.
bool plainerFirst(const Symmetry& a, const Symmetry& b) {
  const auto largest = [](Vec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  };
  return largest(a.normal) > largest(b.normal) + kSameDirection;
}

class Finder {
 public:
  explicit Finder(const Sketch& sketch)
      : sketch_(sketch), arrangement_(arrange(sketch)), flat_(flatNormal(arrangement_)) {}

  FoundSymmetries find() {
    addPointSymmetries(-1);
    std::stable_sort(found_.symmetries.begin(), found_.symmetries.end(), plainerFirst);
    const std::size_t whole = found_.symmetries.size();
    for (int piece = 0; arrangement_.pieces > 1 && arrangement_.pieces <= kMostPieces &&
                        piece < arrangement_.pieces;
         ++piece) {
      addPointSymmetries(piece);
    }
    if (sketch_.lines.size() <= kMostLines) {
      addPartialMirrors(whole);
      addTranslations();
    }
    removeKnown();
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::vector<int> linesOf(int piece) const {
    std::vector<bool> in(sketch_.lines.size(), false);
    for (const Run& run : arrangement_.runs) {
      for (const ArrangedEdge& edge : run.edges) {
        for (const int line : edge.lines) {
          in[at(line)] = in[at(line)] || run.piece == piece;
        }
      }
    }
    std::vector<int> lines;
    for (std::size_t i = 0; i < in.size(); ++i) {
      if (in[i]) {
        lines.push_back(static_cast<int>(i));
      }
    }
    return lines;
  }

  void addPointSymmetries(int piece) {
    for (const PointIsometry& map : pointSymmetries(arrangement_, piece)) {
      if (isMirror(map.linear)) {
        const Vec3 normal = axisOf(map.linear);
        Symmetry mirror = mirrorAt(normal, lattice::dot(normal, map.centre));
        if (piece >= 0) {
          mirror.lines = linesOf(piece);
        }
        add(std::move(mirror));
      } else if (piece < 0 && lattice::determinant(map.linear) > 0.0) {
        addRotation(axisOf(map.linear), map.centre);
      }
    }
  }

  //! Unless the whole sketch has the same mirror.
  void add(Symmetry mirror) {
    const bool known =
        std::any_of(found_.symmetries.begin(), found_.symmetries.end(), [&](const Symmetry& other) {
          return samePlane(other, mirror) && (other.lines.empty() || other.lines == mirror.lines);
        });
    if (!known) {
      found_.symmetries.push_back(std::move(mirror));
    }
  }

  //! Rotations about one axis are counted: with the one that moves nothing they are its order.
  void addRotation(Vec3 axis, Vec3 point) {
    if (lattice::length(flat_) > 0.0 && std::abs(lattice::dot(axis, flat_)) < kSame) {
      return;  // a flat sketch turned over is its mirror image
    }
    for (RotationSymmetry& rotation : found_.rotations) {
      if (near(rotation.axis, axis, kSameDirection)) {
        ++rotation.order;
        return;
      }
    }
    found_.rotations.push_back({tidy(axis), tidy(point), 2});
  }

  //! Mirrors that at least half of the lines share, the one with the most lines of each direction.
  void addPartialMirrors(std::size_t whole) {
    constexpr double kHalf = 0.70710678118654752;
    for (const Vec3 normal : {Vec3{1, 0, 0},
                              Vec3{0, 1, 0},
                              Vec3{0, 0, 1},
                              Vec3{kHalf, kHalf, 0},
                              Vec3{kHalf, -kHalf, 0},
                              Vec3{kHalf, 0, kHalf},
                              Vec3{kHalf, 0, -kHalf},
                              Vec3{0, kHalf, kHalf},
                              Vec3{0, kHalf, -kHalf}}) {
      const auto known = found_.symmetries.begin() + static_cast<std::ptrdiff_t>(whole);
      if (std::any_of(found_.symmetries.begin(), known, [&](const Symmetry& s) {
            return near(s.normal, normal, kSameDirection);
          })) {
        continue;
      }
      addPartialMirror(normal);
    }
  }

  void addPartialMirror(Vec3 normal) {
    // Each pair of a line and its image votes for a plane; a line across it or in it is its own.
    std::vector<std::pair<double, std::pair<int, int>>> votes;
    const auto mirrored = [&](Vec3 p, double offset) {
      return p - (2.0 * (lattice::dot(normal, p) - offset)) * normal;
    };
    for (std::size_t i = 0; i < sketch_.lines.size(); ++i) {
      for (std::size_t j = i; j < sketch_.lines.size(); ++j) {
        const Line& a = sketch_.lines[i];
        const Line& b = sketch_.lines[j];
        const double offset = 0.25 * lattice::dot(normal, a.from + a.to + b.from + b.to);
        if (a.length == b.length && a.exact == b.exact && !a.holeAxis && !b.holeAxis &&
            isImage(b, mirrored(a.from, offset), mirrored(a.to, offset))) {
          votes.push_back({offset, {static_cast<int>(i), static_cast<int>(j)}});
        }
      }
    }
    std::sort(votes.begin(), votes.end());
    std::vector<int> best;
    double bestOffset = 0.0;
    for (std::size_t begin = 0; begin < votes.size();) {
      std::size_t end = begin;
      std::vector<int> lines;
      for (; end < votes.size() && votes[end].first - votes[begin].first < kSame; ++end) {
        lines.push_back(votes[end].second.first);
        lines.push_back(votes[end].second.second);
      }
      std::sort(lines.begin(), lines.end());
      lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
      if (lines.size() > best.size()) {
        best = std::move(lines);
        bestOffset = votes[begin].first;
      }
      begin = end;
    }
    const bool enough = best.size() >= 4 && 2 * best.size() >= sketch_.lines.size();
    const bool moves = std::any_of(best.begin(), best.end(), [&](int line) {
      const Line& l = sketch_.lines[at(line)];
      return std::abs(lattice::dot(normal, l.from) - bestOffset) > kSame ||
             std::abs(lattice::dot(normal, l.to) - bestOffset) > kSame;
    });
    if (enough && moves && best.size() < sketch_.lines.size()) {
      Symmetry mirror = mirrorAt(canonical(normal), bestOffset);
      mirror.lines = best;
      add(std::move(mirror));
    }
  }

  //! Shifts that bring many lines onto others, the shortest first; none in the span of the others.
  void addTranslations() {
    PointIndex shifts(kSame);
    std::vector<std::vector<std::pair<int, int>>> pairs;
    for (std::size_t i = 0; i < sketch_.lines.size(); ++i) {
      for (std::size_t j = 0; j < sketch_.lines.size(); ++j) {
        const Line& a = sketch_.lines[i];
        const Line& b = sketch_.lines[j];
        const Vec3 shift = 0.5 * (b.from + b.to - a.from - a.to);
        const bool forward = near(canonical(shift), shift, kSame) && lattice::length(shift) > kSame;
        const bool along =
            lattice::length(lattice::cross(shift, a.to - a.from)) < kSame * lattice::length(shift);
        if (i == j || !forward || along || a.length != b.length || !sameHoleAxis(a, b) ||
            !isImage(b, a.from + shift, a.to + shift)) {
          continue;
        }
        const std::size_t id = at(shifts.findOrInsert(shift));
        pairs.resize(std::max(pairs.size(), id + 1));
        pairs[id].emplace_back(static_cast<int>(i), static_cast<int>(j));
      }
    }
    std::vector<std::size_t> order;
    for (std::size_t id = 0; id < pairs.size(); ++id) {
      if (pairs[id].size() >= 2 && 4 * pairs[id].size() >= sketch_.lines.size()) {
        order.push_back(id);
      }
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return lattice::length(shifts.at(static_cast<int>(a))) <
             lattice::length(shifts.at(static_cast<int>(b))) - kSame;
    });
    std::vector<Vec3> taken;
    for (const std::size_t id : order) {
      const Vec3 shift = shifts.at(static_cast<int>(id));
      if (spans(taken, shift)) {
        continue;
      }
      taken.push_back(shift);
      Symmetry symmetry;
      symmetry.kind = Symmetry::Kind::kTranslation;
      symmetry.vector = tidy(shift);
      symmetry.pairs = pairs[id];
      found_.symmetries.push_back(std::move(symmetry));
    }
  }

  //! Leaves out what the sketch says already.
  void removeKnown() {
    std::vector<Symmetry>& all = found_.symmetries;
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Symmetry& s) { return has(s); }),
              all.end());
  }

  [[nodiscard]] bool has(const Symmetry& s) const {
    return std::any_of(
        sketch_.symmetries.begin(), sketch_.symmetries.end(), [&](const Symmetry& known) {
          if (known.kind != s.kind) {
            return false;
          }
          if (s.kind == Symmetry::Kind::kTranslation) {
            return near(canonical(known.vector), s.vector, kSame) &&
                   known.pairs.size() >= s.pairs.size();
          }
          const Vec3 normal = canonical(known.normal);
          const double sign = lattice::dot(normal, known.normal) < 0.0 ? -1.0 : 1.0;
          return samePlane(mirrorAt(normal, sign * known.offset), s) &&
                 (known.lines.empty() ||
                  known.lines.size() >= std::max<std::size_t>(1, s.lines.size()));
        });
  }

  const Sketch& sketch_;
  Arrangement arrangement_;
  Vec3 flat_;
  FoundSymmetries found_;
};

}  // namespace

FoundSymmetries findSymmetries(const Sketch& sketch) {
  return Finder(sketch).find();
}

}  // namespace liftarm::sketch
