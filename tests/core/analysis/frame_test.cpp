// Bars against closed forms of beam theory.

#include "analysis/frame.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "core/helpers/frames.h"

namespace liftarm::analysis {
namespace {

using testing::chain;
using testing::clamp;
using testing::solved;

constexpr double kE = kAbs.youngsModulus;
constexpr double kG = kAbs.shearModulus();
constexpr double kLength = 100.0;
constexpr double kForce = 3.0;

const Section kBar = rectangleSection(6.0, 9.0);  // 6 along y, 9 along z

double relative(double value, double expected) {
  return std::abs(value - expected) / std::abs(expected);
}

TEST(Cantilever, BendsByTimoshenkoInBothPlanes) {
  Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, 1, kBar);
  clamp(frame, 0);
  frame.loads[1] = {0, kForce, kForce, 0, 0, 0};
  const std::vector<Six> u = solved(frame);
  const double cube = kForce * kLength * kLength * kLength / (3 * kE);
  const double shear = kForce * kLength / (kG * kBar.shearY);
  EXPECT_LT(relative(u[1][1], cube / kBar.inertiaZ + shear), 1e-6);
  EXPECT_LT(relative(u[1][2], cube / kBar.inertiaY + shear), 1e-6);
}

TEST(Cantilever, TurnsAtItsEndWithoutShear) {
  Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, 1, kBar);
  clamp(frame, 0);
  frame.loads[1] = {0, kForce, kForce, 0, 0, 0};
  const std::vector<Six> u = solved(frame);
  const double square = kForce * kLength * kLength / (2 * kE);
  EXPECT_LT(relative(u[1][5], square / kBar.inertiaZ), 1e-6);
  EXPECT_LT(relative(u[1][4], -square / kBar.inertiaY), 1e-6);
}

TEST(Cantilever, IsLongerAndTwistedByAxialForceAndTorque) {
  Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, 3, kBar);
  clamp(frame, 0);
  frame.loads[3] = {kForce, 0, 0, 50.0, 0, 0};
  const std::vector<Six> u = solved(frame);
  EXPECT_LT(relative(u[3][0], kForce * kLength / (kE * kBar.area)), 1e-6);
  EXPECT_LT(relative(u[3][3], 50.0 * kLength / (kG * kBar.torsion)), 1e-6);
}

TEST(Cantilever, BendsTheSameHoweverFinelyItIsDivided) {
  double last = 0.0;
  for (const int bars : {1, 2, 5, 16}) {
    Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, bars, kBar);
    clamp(frame, 0);
    frame.loads.back() = {0, kForce, 0, 0, 0, 0};
    const double now = solved(frame).back()[1];
    if (bars > 1) {
      EXPECT_LT(relative(now, last), 1e-6) << bars;
    }
    last = now;
  }
}

TEST(Cantilever, BendsTheSameHoweverItLies) {
  Frame straight = chain({0, 0, 0}, {kLength, 0, 0}, 2, kBar);
  clamp(straight, 0);
  straight.loads[2] = {0, 0, kForce, 0, 0, 0};
  // Along (3, 4, 0) / 5, the holes' axis still z.
  Frame slanted = chain({7, 8, 9}, {67, 88, 9}, 2, kBar);
  clamp(slanted, 0);
  slanted.loads[2] = {0, 0, kForce, 0, 0, 0};
  EXPECT_LT(relative(solved(slanted)[2][2], solved(straight)[2][2]), 1e-6);
}

TEST(SpreadLoad, SagsASimplySupportedBeamByFiveThreeEightyFourths) {
  constexpr double kLoad = 0.05;  // N/mm
  Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, 2, kBar);
  constexpr double kHard = 1e12;
  testing::fix(frame, 0, {kHard, kHard, kHard, kHard, 0, 0});
  testing::fix(frame, 2, {0, kHard, kHard, 0, 0, 0});
  for (FrameElement& bar : frame.elements) {
    bar.load = {0, 0, -kLoad};
  }
  const std::vector<Six> u = solved(frame);
  const double bending = 5 * kLoad * std::pow(kLength, 4) / (384 * kE * kBar.inertiaY);
  const double shear = kLoad * kLength * kLength / (8 * kG * kBar.shearZ);
  EXPECT_LT(relative(u[1][2], -(bending + shear)), 1e-6);
  const SectionForces middle = forcesAt(frame, frame.elements[0], u, 1.0);
  EXPECT_LT(relative(std::abs(middle.momentY), kLoad * kLength * kLength / 8), 1e-6);
  EXPECT_LT(std::abs(middle.shearZ), 1e-6);
}

TEST(SpreadLoad, GivesAClampedBarItsEndMoments) {
  Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, 1, kBar);
  clamp(frame, 0);
  clamp(frame, 1);
  frame.elements[0].load = {0, 0.1, 0};
  const std::vector<Six> u = solved(frame);
  const double end = 0.1 * kLength * kLength / 12;
  EXPECT_LT(relative(std::abs(forcesAt(frame, frame.elements[0], u, 0.0).momentZ), end), 1e-6);
  EXPECT_LT(relative(std::abs(forcesAt(frame, frame.elements[0], u, 0.5).momentZ), end / 2), 1e-6);
}

//! A portal of two columns and a beam, all alike, its feet clamped, pushed sideways at the top.
Frame portal(double height, double span) {
  Frame frame;
  frame.sections = {kBar};
  // No axial and no shear flexibility, as the textbook has it.
  frame.sections[0].area = 1e6;
  frame.sections[0].shearY = frame.sections[0].shearZ = 1e9;
  frame.nodes = {{0, 0, 0}, {0, 0, height}, {span, 0, height}, {span, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    FrameElement bar;
    bar.a = i;
    bar.b = i + 1;
    bar.up = {0, 1, 0};
    frame.elements.push_back(bar);
  }
  frame.loads.assign(4, Six{});
  clamp(frame, 0);
  clamp(frame, 3);
  return frame;
}

TEST(Portal, SwaysAsSlopeDeflectionSays) {
  constexpr double kHeight = 80.0;
  constexpr double kSpan = 120.0;
  Frame frame = portal(kHeight, kSpan);
  frame.loads[1] = {kForce, 0, 0, 0, 0, 0};
  // Slope deflection: the sway is P h^3 (2 + 3 k) / (12 E I (1 + 6 k)) with k = (I/l)/(I/h).
  const double k = kHeight / kSpan;
  const double inertia = kBar.inertiaZ;
  const double sway =
      kForce * std::pow(kHeight, 3) * (2 + 3 * k) / (12 * kE * inertia * (1 + 6 * k));
  EXPECT_LT(relative(solved(frame)[1][0], sway), 1e-3);
}

TEST(Portal, IsSymmetricUnderASymmetricLoad) {
  Frame frame = portal(80.0, 120.0);
  frame.loads[1] = {0, 0, -kForce, 0, 0, 0};
  frame.loads[2] = {0, 0, -kForce, 0, 0, 0};
  const std::vector<Six> u = solved(frame);
  EXPECT_NEAR(u[1][2], u[2][2], 1e-9);
  EXPECT_NEAR(u[1][0], -u[2][0], 1e-9);
  EXPECT_NEAR(u[1][4], -u[2][4], 1e-9);
}

TEST(Stiffness, IsSymmetricAndDoesNotResistRigidMotion) {
  Frame frame = chain({1, 2, 3}, {20, -5, 8}, 1, kBar);
  const std::array<double, 144> k = stiffnessOf(frame, frame.elements[0]);
  // Local axes: a shift along y, and a turn about z of a bar that begins at the origin.
  const double length = lengthOf(frame, frame.elements[0]);
  const std::array<double, 12> shift{0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0};
  const std::array<double, 12> turn{0, 0, 0, 0, 0, 1, 0, length, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 12; ++i) {
    double byShift = 0.0;
    double byTurn = 0.0;
    for (std::size_t j = 0; j < 12; ++j) {
      EXPECT_DOUBLE_EQ(k[12 * i + j], k[12 * j + i]);
      byShift += k[12 * i + j] * shift[j];
      byTurn += k[12 * i + j] * turn[j];
    }
    EXPECT_NEAR(byShift, 0.0, 1e-7);
    EXPECT_NEAR(byTurn, 0.0, 1e-7);
  }
}

TEST(VonMises, AddsBendingAndTakesShearThreefold) {
  SectionForces forces;
  forces.normal = 54.0;
  forces.momentZ = 2 * kBar.modulusZ;
  EXPECT_NEAR(vonMises(kBar, forces), 1.0 + 2.0, 1e-12);
  forces = {};
  forces.torque = kBar.modulusT;
  EXPECT_NEAR(vonMises(kBar, forces), std::sqrt(3.0), 1e-12);
}

TEST(FreeBar, IsAMechanism) {
  Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, 4, kBar);
  constexpr double kHard = 1e6;
  testing::fix(frame, 0, {kHard, kHard, kHard, kHard, kHard, 0});
  EXPECT_TRUE(solved(frame).empty());
}

TEST(FreeBar, IsToldToTurnAboutItsHinge) {
  Frame frame = chain({0, 0, 0}, {kLength, 0, 0}, 4, kBar);
  constexpr double kHard = 1e6;
  testing::fix(frame, 0, {kHard, kHard, kHard, kHard, kHard, 0});
  FrameSolver solver(frame);
  ASSERT_FALSE(solver.prepare({}));
  const std::vector<Six> motion = solver.motion();
  EXPECT_NEAR(std::abs(motion[4][1]), 1.0, 1e-3);
  EXPECT_NEAR(motion[2][1] / motion[4][1], 0.5, 1e-3);
}

TEST(Slender, TwoMetresOfBarAreNotTakenForAMechanism) {
  Frame frame = chain({0, 0, 0}, {2000, 0, 0}, 60, axleSection());
  clamp(frame, 0);
  frame.loads.back() = {0, 0, 0.01, 0, 0, 0};
  const std::vector<Six> u = solved(frame);
  ASSERT_FALSE(u.empty());
  const Section s = axleSection();
  const double expected =
      0.01 * std::pow(2000.0, 3) / (3 * kE * s.inertiaY) + 0.01 * 2000 / (kG * s.shearZ);
  EXPECT_LT(relative(u.back()[2], expected), 1e-6);
}

}  // namespace
}  // namespace liftarm::analysis
