#include "core/helpers/models.h"

#include <cmath>

#include "model/number_text.h"

namespace liftarm::testing {

namespace {

using lattice::Mat3;
using lattice::Vec3;
using model::Model;
using model::PlacedPart;

PlacedPart placed(const std::string& part, Vec3 position, const Mat3& rotation) {
  PlacedPart result;
  result.part = part;
  result.pose = {position, rotation};
  return result;
}

}  // namespace

PlacedPart beamAt(const std::string& part, Vec3 center, Vec3 direction, Vec3 holeAxis) {
  return placed(
      part, center, lattice::fromColumns(lattice::cross(direction, holeAxis), direction, holeAxis));
}

PlacedPart pinAt(const std::string& part, Vec3 center, Vec3 axis) {
  const Vec3 side = std::abs(axis.z) > 0.5 ? kX : kZ;
  return placed(part, center, lattice::fromColumns(axis, side, lattice::cross(axis, side)));
}

PlacedPart partAt(const std::string& part, Vec3 position) {
  return placed(part, position, Mat3());
}

void turn(PlacedPart& part, Vec3 axis, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180.0;
  const auto image = [&](Vec3 v) {
    return std::cos(angle) * v + std::sin(angle) * lattice::cross(axis, v) +
           ((1 - std::cos(angle)) * lattice::dot(axis, v)) * axis;
  };
  part.pose.rotation = lattice::fromColumns(image(kX), image(kY), image(kZ)) * part.pose.rotation;
}

std::string sketchOf(const std::vector<std::pair<Vec3, Vec3>>& lines, const std::string& more) {
  const auto point = [](Vec3 p) {
    return "[" + model::numberText(p.x) + "," + model::numberText(p.y) + "," +
           model::numberText(p.z) + "]";
  };
  std::string text = R"({"format":"technic-sketch","version":1,"lines":[)";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += (i == 0 ? "" : ",");
    text += R"({"from":)" + point(lines[i].first) + R"(,"to":)" + point(lines[i].second) + "}";
  }
  return text + "]" + more + "}";
}

Model squareFrame() {
  Model model;
  model.name = "Square";
  model.parts = {beamAt("40490", {4, 0, 0}, kX, kZ),
                 beamAt("40490", {4, 8, 0}, kX, kZ),
                 beamAt("40490", {0, 4, 1}, kY, kZ),
                 beamAt("40490", {8, 4, 1}, kY, kZ),
                 pinAt("2780", {0, 0, 0.5}, kZ),
                 pinAt("2780", {8, 0, 0.5}, kZ),
                 pinAt("2780", {0, 8, 0.5}, kZ),
                 pinAt("2780", {8, 8, 0.5}, kZ)};
  model.sketchJson = sketchOf({{{0, 0, 0}, {8, 0, 0}},
                               {{8, 0, 0}, {8, 8, 0}},
                               {{0, 8, 0}, {8, 8, 0}},
                               {{0, 0, 0}, {0, 8, 0}}},
                              R"(,"ground":0)");
  return model;
}

Model pythagoreanTriangle() {
  Model model;
  model.name = "Triangle 6-8-10";
  const Vec3 slope{-0.6, 0, 0.8};
  model.parts = {beamAt("32524", {3, 0, 0}, kX, kY),
                 beamAt("40490", {0, 1, 4}, kZ, kY),
                 beamAt("32525", {3, 2, 4}, slope, kY),
                 pinAt("6558", {0, 1, 0}, kY),
                 pinAt("6558", {6, 1, 0}, kY),
                 pinAt("2780", {0, 1.5, 8}, kY),
                 // The slope lies two layers off the base: a spacer fills the one between.
                 beamAt("18654", {6, 1, 0}, kX, kY),
                 beamAt("18654", {0, 2, 0}, kX, kY)};
  model.sketchJson =
      sketchOf({{{0, 0, 0}, {6, 0, 0}}, {{0, 0, 0}, {0, 0, 8}}, {{6, 0, 0}, {0, 0, 8}}});
  return model;
}

Model cornerOfTwoBeams() {
  Model model;
  model.name = "Corner";
  model.parts = {partAt("55615", {0, 0, 0}),
                 beamAt("32316", {0, -1, 2}, kZ, kY),
                 beamAt("32316", {0, 2, -1}, kY, kZ)};
  return model;
}

Model bridgedLine() {
  Model model;
  model.name = "Bridged line";
  model.parts = {partAt("48989", {0, 0, 0}),
                 beamAt("32316", {0, -1, -3}, kZ, kY),
                 beamAt("32316", {0, -1, 3}, kZ, kY)};
  model.sketchJson = sketchOf({{{0, -1, -5}, {0, -1, 5}}});
  return model;
}

Model stackedThinBeams() {
  Model model;
  model.name = "Thin beams";
  model.parts = {beamAt("32316", {2, 0, 0}, kX, kZ),
                 beamAt("32063", {2.5, 0, 0.75}, kX, kZ),
                 beamAt("32063", {2.5, 0, 1.25}, kX, kZ),
                 pinAt("2780", {0, 0, 0.5}, kZ),
                 pinAt("2780", {4, 0, 0.5}, kZ)};
  return model;
}

Model squareWithAxle() {
  Model model = squareFrame();
  model.name = "Square with axle";
  // Axle hole at (0, 3, 2), pin hole at (0, 4, 2) on top of the beam at x = 0.
  model.parts.push_back(partAt("60483", {0, 3, 2}));
  model.parts.push_back(pinAt("2780", {0, 4, 1.5}, kZ));
  model.parts.push_back(pinAt("4519", {0, 3, 3}, kZ));
  model.parts.push_back(partAt("3713", {0, 3, 3}));
  // A bush lies along LDraw's z, our y.
  turn(model.parts.back(), kX, 90);
  return model;
}

Model frameOfAxles() {
  Model model;
  model.name = "Frame of axles";
  model.parts = {beamAt("32316", {2, 0, 0}, kX, kY), beamAt("32316", {2, 4, 0}, kX, kY)};
  for (const double x : {0.0, 4.0}) {
    model.parts.push_back(pinAt("44294", {x, 2, 0}, kY));
    for (const double y : {-1.0, 1.0, 3.0, 5.0}) {
      model.parts.push_back(partAt("3713", {x, y, 0}));
    }
  }
  model.sketchJson = sketchOf({{{0, 0, 0}, {4, 0, 0}},
                               {{0, 4, 0}, {4, 4, 0}},
                               {{0, 0, 0}, {0, 4, 0}},
                               {{4, 0, 0}, {4, 4, 0}}});
  return model;
}

std::vector<Model> buildableModels() {
  return {squareFrame(),
          pythagoreanTriangle(),
          cornerOfTwoBeams(),
          bridgedLine(),
          stackedThinBeams(),
          squareWithAxle(),
          frameOfAxles()};
}

}  // namespace liftarm::testing
