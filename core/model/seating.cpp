#include "model/seating.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/index.h"
#include "model/connections.h"

namespace liftarm::model {

namespace {

using base::at;
using lattice::Mat3;
using lattice::Vec3;
using parts::Feature;

constexpr double kSeated = 1e-10;                 // modules and radians: nothing to do
constexpr double kSkewed = 5e-3;                  // of entries of R^T R: more is no rounding
constexpr double kArm = 4.0;                      // modules; makes turns as large as shifts
constexpr double kWork = 3e7;                     // rows times iterations of one solution
constexpr int kMaxIterations = 3000;              // of one solution
constexpr int kMaxSteps = 4;                      // of Gauss and Newton: each squares the error
constexpr double kSmallEnough = 1e-26;            // of the squared gradient
constexpr double kLargestMove = 2 * kRoundedGap;  // modules, and radians times kArm
constexpr double kUnitsPerModule = 20.0;          // LDraw's, whole on the lattice

//! One equation: a male part's and a female part's six unknowns (shift, turn), and what is off.
struct Row {
  std::size_t male = 0;
  std::size_t female = 0;
  std::array<double, 6> ofMale{};
  std::array<double, 6> ofFemale{};
  double off = 0.0;
};

using Six = std::array<double, 6>;
using PartList = std::vector<const parts::Part*>;

Six shiftAndTurn(Vec3 shift, Vec3 turn) {
  return {shift.x, shift.y, shift.z, turn.x / kArm, turn.y / kArm, turn.z / kArm};
}

//! The rows of one connection.
class Seat {
 public:
  Seat(const Model& model, const PartList& parts, const Connection& c)
      : male_(at(c.male)), female_(at(c.female)), rigid_(c.fit == Fit::kRigid) {
    const lattice::Pose& malePose = model.parts[male_].pose;
    const lattice::Pose& femalePose = model.parts[female_].pose;
    const Feature& head = parts[male_]->features[at(c.maleFeature)];
    const Feature& hole = parts[female_]->features[at(c.femaleFeature)];
    maleArm_ = malePose.rotation * head.slots[at(c.maleSlot)];
    femaleArm_ = femalePose.rotation * hole.slots[at(c.femaleSlot)];
    gap_ = femalePose.position + femaleArm_ - malePose.position - maleArm_;
    axis_ = lattice::normalized(malePose.rotation * head.axis);
    holeAxis_ = lattice::normalized(femalePose.rotation * hole.axis);
    holeAxis_ = lattice::dot(axis_, holeAxis_) < 0 ? -holeAxis_ : holeAxis_;
    if (rigid_ && head.wing.has_value() && hole.wing.has_value()) {
      setWings(malePose.rotation * *head.wing, femalePose.rotation * *hole.wing);
    }
    placed_ = isPlaced(hole);
  }

  [[nodiscard]] std::vector<Row> rows() const {
    const Vec3 any = std::abs(axis_.z) > 0.6 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    const Vec3 first = lattice::normalized(lattice::cross(axis_, any));
    std::vector<Row> rows;
    for (const Vec3 side : {first, lattice::cross(axis_, first)}) {
      rows.push_back(gapRow(side));
      rows.push_back(turnRow(lattice::cross(axis_, side), lattice::dot(holeAxis_, side)));
    }
    if (placed_) {
      rows.push_back(gapRow(axis_));
    }
    if (rigid_) {
      rows.push_back(turnRow(axis_, twist_));
    }
    return rows;
  }

  //! Off by no more than rounding.
  [[nodiscard]] bool isRounded() const {
    const double along = lattice::dot(gap_, axis_);
    return lattice::length(gap_ - along * axis_) <= kRoundedGap &&
           (!placed_ || std::abs(along) <= kRoundedGap) &&
           lattice::length(lattice::cross(axis_, holeAxis_)) <= kRoundedTurn &&
           std::abs(twist_) <= kRoundedTurn;
  }

 private:
  //! Both crosses look the same after a quarter turn.
  void setWings(Vec3 male, Vec3 female) {
    const Vec3 square = lattice::cross(axis_, male);
    const double along = lattice::dot(female, male);
    const double aside = lattice::dot(female, square);
    twist_ = std::abs(along) >= std::abs(aside) ? (along < 0 ? -aside : aside)
                                                : (aside < 0 ? along : -along);
  }

  //! A thin hole may lie anywhere along a head of full length.
  static bool isPlaced(const Feature& hole) {
    constexpr double kThin = 0.6;
    return hole.length / static_cast<double>(hole.slots.size()) > kThin;
  }

  [[nodiscard]] Row gapRow(Vec3 direction) const {
    return {male_,
            female_,
            shiftAndTurn(-direction, -lattice::cross(maleArm_, direction)),
            shiftAndTurn(direction, lattice::cross(femaleArm_, direction)),
            lattice::dot(gap_, direction)};
  }

  [[nodiscard]] Row turnRow(Vec3 about, double off) const {
    return {male_, female_, shiftAndTurn({}, -about), shiftAndTurn({}, about), off};
  }

  std::size_t male_;
  std::size_t female_;
  bool rigid_;
  bool placed_ = true;
  double twist_ = 0.0;
  Vec3 maleArm_;
  Vec3 femaleArm_;
  Vec3 gap_;
  Vec3 axis_;
  Vec3 holeAxis_;
};

enum class Heads { kFitting, kRounded };

std::vector<Row> rowsOf(const Model& model,
                        const PartList& parts,
                        const std::vector<Connection>& connections,
                        Heads which) {
  std::vector<Row> rows;
  for (const Connection& c : connections) {
    const Seat seat(model, parts, c);
    if (isGood(c.fit) && (which == Heads::kFitting || seat.isRounded())) {
      const std::vector<Row> added = seat.rows();
      rows.insert(rows.end(), added.begin(), added.end());
    }
  }
  return rows;
}

double worstOf(const std::vector<Row>& rows) {
  double worst = 0.0;
  for (const Row& row : rows) {
    worst = std::max(worst, std::abs(row.off));
  }
  return worst;
}

bool isWhole(double value) {
  return value == std::floor(value);
}

//! On the lattice, with room for what lies between its points.
bool standsOnLattice(const lattice::Pose& pose) {
  const auto whole = [](double value) { return isWhole(kUnitsPerModule * value); };
  return std::all_of(pose.rotation.m.begin(), pose.rotation.m.end(), isWhole) &&
         whole(pose.position.x) && whole(pose.position.y) && whole(pose.position.z);
}

//! The linear equations of one step, each column of six numbers a part that may move.
class SeatingStep {
 public:
  SeatingStep(const std::vector<Row>& rows, std::vector<bool> holds)
      : rows_(rows), holds_(std::move(holds)) {}

  //! The least moves that close the gaps best (CGLS), those of many modules for a small gap damped.
  [[nodiscard]] std::vector<double> solve(double damping) const {
    const double weight = damping * damping;
    std::vector<double> moves(6 * holds_.size(), 0.0);
    std::vector<double> left;
    for (const Row& row : rows_) {
      left.push_back(-row.off);
    }
    std::vector<double> gradient = backward(left);
    std::vector<double> direction = gradient;
    double size = squared(gradient);
    const double enough = kSmallEnough * std::max(size, 1e-12);
    const double allowed = kWork / static_cast<double>(std::max<std::size_t>(rows_.size(), 1));
    for (int i = 0; i < kMaxIterations && i < allowed && size > enough; ++i) {
      const std::vector<double> effect = forward(direction);
      const double share = size / (squared(effect) + weight * squared(direction));
      add(moves, share, direction);
      add(left, -share, effect);
      gradient = backward(left);
      add(gradient, -weight, moves);
      const double next = squared(gradient);
      for (std::size_t k = 0; k < direction.size(); ++k) {
        direction[k] = gradient[k] + next / size * direction[k];
      }
      size = next;
    }
    return moves;
  }

 private:
  static double squared(const std::vector<double>& v) {
    double sum = 0.0;
    for (const double value : v) {
      sum += value * value;
    }
    return sum;
  }

  static void add(std::vector<double>& to, double share, const std::vector<double>& what) {
    for (std::size_t k = 0; k < to.size(); ++k) {
      to[k] += share * what[k];
    }
  }

  [[nodiscard]] std::vector<double> forward(const std::vector<double>& moves) const {
    std::vector<double> effect;
    for (const Row& row : rows_) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 6; ++k) {
        sum +=
            row.ofMale[k] * moves[6 * row.male + k] + row.ofFemale[k] * moves[6 * row.female + k];
      }
      effect.push_back(sum);
    }
    return effect;
  }

  [[nodiscard]] std::vector<double> backward(const std::vector<double>& left) const {
    std::vector<double> gradient(6 * holds_.size(), 0.0);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Row& row = rows_[r];
      for (std::size_t k = 0; k < 6; ++k) {
        gradient[6 * row.male + k] += holds_[row.male] ? 0.0 : row.ofMale[k] * left[r];
        gradient[6 * row.female + k] += holds_[row.female] ? 0.0 : row.ofFemale[k] * left[r];
      }
    }
    return gradient;
  }

  const std::vector<Row>& rows_;
  std::vector<bool> holds_;
};

//! Where a chain stands so that its equations hardly depend on some motion (all in one plane, at a
//! dead point), rounding asks for a long way along it. Rounding never moved a part so far.
std::vector<double> leastMoves(const SeatingStep& step) {
  std::vector<double> moves;
  for (const double damping : {0.0, 1e-5, 1e-3, 1e-2, 1e-1}) {
    moves = step.solve(damping);
    if (std::all_of(moves.begin(), moves.end(), [](double move) {
          return std::abs(move) <= kLargestMove;
        })) {
      return moves;
    }
  }
  return std::vector<double>(moves.size(), 0.0);
}

//! Newton's steps towards the nearest rotation, (3 R - R R^T R) / 2. Nothing where R is no rotation
//! but for rounding, or is one already.
void straighten(Mat3& r) {
  const auto skew = [](const Mat3& m) {
    const Mat3 square = lattice::transposed(m) * m;
    double worst = 0.0;
    for (std::size_t i = 0; i < 9; ++i) {
      worst = std::max(worst, std::abs(square.m[i] - Mat3{}.m[i]));
    }
    return worst;
  };
  for (int i = 0; i < 3; ++i) {
    const double off = skew(r);
    if (off < kSeated || off > kSkewed) {
      return;
    }
    const Mat3 cube = r * (lattice::transposed(r) * r);
    for (std::size_t k = 0; k < 9; ++k) {
      r.m[k] = 1.5 * r.m[k] - 0.5 * cube.m[k];
    }
  }
}

void move(lattice::Pose& pose, const double* six) {
  const Vec3 turn{six[3] / kArm, six[4] / kArm, six[5] / kArm};
  const auto turned = [&](Vec3 v) {
    const Vec3 first = lattice::cross(turn, v);
    return v + first + 0.5 * lattice::cross(turn, first);
  };
  const Mat3 small = lattice::fromColumns(turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}));
  pose.rotation = small * pose.rotation;
  straighten(pose.rotation);
  pose.position = pose.position + Vec3{six[0], six[1], six[2]};
}

}  // namespace

double seatingError(const Model& model,
                    const PartList& parts,
                    const std::vector<Connection>& connections) {
  return worstOf(rowsOf(model, parts, connections, Heads::kFitting));
}

void seatHeads(Model& model, const parts::Catalogue& catalogue) {
  std::vector<bool> holds;
  PartList parts;
  for (PlacedPart& part : model.parts) {
    parts.push_back(catalogue.find(part.part));
    holds.push_back(standsOnLattice(part.pose));
    straighten(part.pose.rotation);
  }
  const std::vector<Connection> connections = findConnections(model, catalogue);
  double before = 0.0;
  for (int step = 0; step < kMaxSteps; ++step) {
    const std::vector<Row> rows = rowsOf(model, parts, connections, Heads::kRounded);
    const double worst = worstOf(rows);
    // Where lengths contradict each other, the best is reached soon.
    if (worst < kSeated || (step > 1 && worst > 0.5 * before)) {
      return;
    }
    before = worst;
    const std::vector<double> moves = leastMoves(SeatingStep(rows, holds));
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
      if (!holds[i]) {
        move(model.parts[i].pose, moves.data() + 6 * i);
      }
    }
  }
}

}  // namespace liftarm::model
