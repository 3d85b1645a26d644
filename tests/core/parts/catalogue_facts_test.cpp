#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/shared_data.h"
#include "parts/catalogue.h"

namespace liftarm::parts {
namespace {

using lattice::Vec3;
using nlohmann::json;

const json& facts() {
  static const json document = json::parse(
      testing::readSharedFile("parts/technic_parts.json").value_or("{}"), nullptr, false);
  return document.at("parts");
}

Vec3 turned(const json& v) {
  return {v[0], v[2], -v[1].get<double>()};
}

Vec3 point(const json& v) {
  return (1.0 / 20.0) * turned(v);
}

const char* factName(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::kPin:
      return "pin";
    case FeatureKind::kAxle:
      return "axle";
    case FeatureKind::kPinHole:
      return "pin_hole";
    case FeatureKind::kAxleHole:
      return "axle_hole";
  }
  return "";
}

bool near(Vec3 a, Vec3 b) {
  return lattice::length(a - b) < 2e-5;
}

bool agrees(const Feature& feature, const json& fact) {
  return fact.at("kind") == factName(feature.kind) &&
         near(feature.center, point(fact.at("center"))) &&
         near(feature.axis, lattice::normalized(turned(fact.at("axis")))) &&
         std::abs(feature.length - fact.at("length").get<double>() / 20.0) < 2e-5;
}

std::vector<json> ownFacts(const Part& part) {
  std::vector<json> result;
  for (const json& fact : facts().at(part.id).at("features")) {
    if (fact.at("kind") != "other") {
      result.push_back(fact);
    }
  }
  return result;
}

TEST(CatalogueFacts, EveryFeatureLiesWhereTheSharedFactsSay) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    ASSERT_TRUE(facts().contains(part.id)) << part.id;
    const std::vector<json> expected = ownFacts(part);
    ASSERT_EQ(part.features.size(), expected.size()) << part.id;
    for (const Feature& feature : part.features) {
      EXPECT_TRUE(std::any_of(expected.begin(),
                              expected.end(),
                              [&](const json& fact) { return agrees(feature, fact); }))
          << part.id << " " << factName(feature.kind);
    }
  }
}

TEST(CatalogueFacts, WingsOfAxlesAgreeUpToAQuarterTurn) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    const std::vector<json> expected = ownFacts(part);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(part.features[i].wing.has_value(), expected[i].contains("cross")) << part.id;
      if (part.features[i].wing.has_value()) {
        const double c = lattice::dot(*part.features[i].wing, turned(expected[i].at("cross")));
        EXPECT_TRUE(std::abs(c) < 1e-4 || std::abs(c) > 0.9999) << part.id;
        EXPECT_LT(std::abs(lattice::dot(*part.features[i].wing, part.features[i].axis)), 1e-4)
            << part.id;
      }
    }
  }
}

TEST(CatalogueFacts, BoundsAgreeWithTheSharedBoxes) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    const json& box = facts().at(part.id).at("bbox");
    const Vec3 a = point(box[0]);
    const Vec3 b = point(box[1]);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(part.boundsMin[i], std::min(a[i], b[i]), 1e-5) << part.id;
      EXPECT_NEAR(part.boundsMax[i], std::max(a[i], b[i]), 1e-5) << part.id;
    }
  }
}

//! Facts end the cross bars of 64178 at the flanks of its sides; ours go on to the holes in them.
double prolongedBy(const Part& part) {
  return part.id == "64178" ? 4.0 : 0.0;
}

TEST(CatalogueFacts, StretchesAreTheSharedOnesDrawnBackByHalfAModule) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    if (part.partClass != PartClass::kBeam || !facts().at(part.id).contains("stretches")) {
      continue;
    }
    double ours = 0.0;
    for (const Stretch& stretch : part.stretches) {
      ours += lattice::length(stretch.to - stretch.from);
    }
    double expected = prolongedBy(part);
    for (const json& s : facts().at(part.id).at("stretches")) {
      expected += lattice::length(point(s[1]) - point(s[0])) - 1.0;
    }
    EXPECT_NEAR(ours, expected, 1e-4) << part.id;
  }
}

//! Says of a part where its mass comes from, if that is told; the program has no use for it.
std::string massSource(const std::string& id) {
  std::ifstream file(std::string(LIFTARM_SOURCE_DIR) + "/core/parts/catalogue.json");
  static const json document = json::parse(file, nullptr, false);
  for (const json& part : document.at("parts")) {
    if (part.at("id") == id) {
      return part.value("massSource", "");
    }
  }
  return {};
}

// Plastics of these parts weigh 1.05 (ABS) to 1.41 g/cm3 (POM); what is outside was typed wrong, or
// has a reason that is given.
TEST(CatalogueFacts, EveryMassIsThatOfTheVolumeOrItsSourceIsGiven) {
  LIFTARM_NEED_SHARED_DATA();
  constexpr double kCubicCmPerCubicLdu = 0.04 * 0.04 * 0.04;
  constexpr double kAbs = 1.05;
  for (const Part& part : Catalogue::builtIn().parts()) {
    const json& fact = facts().at(part.id);
    const json& volume = fact.at("volume").is_null() ? fact.at("volume_raw") : fact.at("volume");
    const double ratio = part.mass / (volume.get<double>() * kCubicCmPerCubicLdu * kAbs);
    if (massSource(part.id).empty()) {
      EXPECT_GE(ratio, 0.75) << part.id;
      EXPECT_LE(ratio, 1.35) << part.id;
    }
  }
}

TEST(CatalogueFacts, TheCornerOfThreeByThreeWeighsWhatItsVolumeDoes) {
  EXPECT_NEAR(Catalogue::builtIn().find("55615")->mass, 1.6, 0.1);
}

}  // namespace
}  // namespace liftarm::parts
