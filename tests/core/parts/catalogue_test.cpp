#include "parts/catalogue.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "parts/catalogue_json.h"

namespace liftarm::parts {
namespace {

const std::vector<Part>& allParts() {
  return Catalogue::builtIn().parts();
}

TEST(Catalogue, FindsEachOfItsPartsByNumberAndNoOther) {
  for (const Part& part : allParts()) {
    EXPECT_EQ(Catalogue::builtIn().find(part.id), &part);
  }
  EXPECT_EQ(Catalogue::builtIn().find("99999"), nullptr);
  EXPECT_EQ(Catalogue::builtIn().find(""), nullptr);
}

TEST(Catalogue, HoldsTheStraightBeamsOfTheDesign) {
  for (const int holes : {1, 2, 3, 5, 7, 9, 11, 13, 15}) {
    EXPECT_EQ(std::count_if(allParts().begin(),
                            allParts().end(),
                            [&](const Part& part) {
                              return part.partClass == PartClass::kBeam && part.holes == holes &&
                                     part.thickness == 1.0;
                            }),
              1)
        << holes;
  }
}

TEST(Catalogue, AStraightBeamHasItsHolesOneModuleApart) {
  for (const Part& part : allParts()) {
    if (part.holes == 0) {
      continue;
    }
    ASSERT_EQ(part.features.size(), static_cast<std::size_t>(part.holes)) << part.id;
    for (const Feature& feature : part.features) {
      EXPECT_FALSE(isMale(feature.kind));
      EXPECT_DOUBLE_EQ(feature.length, part.thickness) << part.id;
    }
    EXPECT_NEAR(part.boundsMax.y - part.boundsMin.y, part.holes - 0.1, 1e-6) << part.id;
  }
}

TEST(Catalogue, EveryPartHasAPositiveMassAndAName) {
  for (const Part& part : allParts()) {
    EXPECT_GT(part.mass, 0.05) << part.id;
    EXPECT_LT(part.mass, 10.0) << part.id;
    EXPECT_FALSE(part.name.empty()) << part.id;
  }
}

TEST(Catalogue, SlotsLieOnTheirFeature) {
  for (const Part& part : allParts()) {
    for (const Feature& feature : part.features) {
      EXPECT_NEAR(lattice::length(feature.axis), 1.0, 1e-12) << part.id;
      for (const lattice::Vec3 slot : feature.slots) {
        const lattice::Vec3 offset = slot - feature.center;
        const double along = lattice::dot(offset, feature.axis);
        EXPECT_LT(lattice::length(offset - along * feature.axis), 1e-5) << part.id;
        EXPECT_LE(std::abs(along), feature.length / 2 + 1e-6) << part.id;
      }
    }
  }
}

TEST(Catalogue, PrismsLieWithinTheBoundsOfThePart) {
  constexpr double kSlack = 0.06;
  for (const Part& part : allParts()) {
    for (const Prism& prism : part.solid) {
      for (int i = 0; i < 3; ++i) {
        const double a = prism.axis[i];
        const double across = prism.radius * std::sqrt(std::max(0.0, 1.0 - a * a));
        const double reach = across + prism.halfThickness * std::abs(a);
        EXPECT_GE(std::min(prism.from[i], prism.to[i]) - reach, part.boundsMin[i] - kSlack)
            << part.id;
        EXPECT_LE(std::max(prism.from[i], prism.to[i]) + reach, part.boundsMax[i] + kSlack)
            << part.id;
      }
    }
  }
}

TEST(Catalogue, EveryPinHasACollarAndNoBeamHas) {
  for (const Part& part : allParts()) {
    if (part.partClass == PartClass::kPin) {
      EXPECT_FALSE(part.collars.empty()) << part.id;
    }
    if (part.partClass == PartClass::kBeam) {
      EXPECT_TRUE(part.collars.empty()) << part.id;
    }
  }
}

TEST(CatalogueJson, NamesThePartAtFault) {
  const auto result = readCatalogue(R"({"parts": [{"id": "32316", "class": "brick"}]})");
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("parts[0] (32316)"), std::string::npos);
}

TEST(CatalogueJson, RefusesWhatIsNoCatalogue) {
  for (const char* text : {"", "[]", "{", R"({"parts": 3})"}) {
    EXPECT_FALSE(readCatalogue(text).ok()) << text;
  }
}

}  // namespace
}  // namespace liftarm::parts
