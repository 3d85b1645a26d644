#include "design/paint.h"

#include <gtest/gtest.h>

#include "core/helpers/models.h"
#include "core/helpers/solved.h"

namespace liftarm::design {
namespace {

using sketch::SketchColours;

model::Model painted(const SketchColours& colours, model::Model model = testing::squareFrame()) {
  paint(colours, model);
  return model;
}

constexpr std::size_t kBeam = 0;  // of nine holes, on lines[0]
constexpr std::size_t kPin = 4;

TEST(Paint, BeamsOfOneLengthAreAlikeAndPinsAsUsual) {
  const model::Model model = painted({});
  for (std::size_t beam = 0; beam < 4; ++beam) {
    EXPECT_EQ(model.parts[beam].color, 1);
  }
  EXPECT_EQ(model.parts[kPin].color, parts::Catalogue::builtIn().find("2780")->color);
}

TEST(Paint, UsualSchemeIsTheCataloguesOwn) {
  SketchColours colours;
  colours.scheme = "usual";
  EXPECT_EQ(countUnusualColours(painted(colours)), 0);
  EXPECT_EQ(countUnusualColours(painted({})), 4);
}

TEST(Paint, ComponentsTellApart) {
  SketchColours colours;
  colours.scheme = "component";
  model::Model model = testing::squareFrame();
  model.parts[0].component = 0;
  model.parts[1].component = 1;
  model = painted(colours, model);
  EXPECT_NE(model.parts[0].color, model.parts[1].color);
}

TEST(Paint, LinesGoBeforeKindsBeforeTheDefaultBeforeTheScheme) {
  SketchColours colours;
  colours.standard = 71;
  EXPECT_EQ(painted(colours).parts[kBeam].color, 71);
  EXPECT_EQ(painted(colours).parts[kPin].color, painted({}).parts[kPin].color);
  colours.kinds = {{"beam", 15}, {"pin", 4}};
  EXPECT_EQ(painted(colours).parts[kBeam].color, 15);
  EXPECT_EQ(painted(colours).parts[kPin].color, 4);
  colours.lines = {{0, 2}};
  EXPECT_EQ(painted(colours).parts[kBeam].color, 2);
  EXPECT_EQ(painted(colours).parts[1].color, 15);
}

TEST(Paint, SolvedModelHasTheColoursOfItsSketchAndKeepsThem) {
  const std::string sketch =
      R"({"format": "technic-sketch", "version": 2, "lines": [{"from": [0,0,0], "to": [8,0,0]},)"
      R"({"from": [8,0,0], "to": [8,8,0]}], "colours": {"lines": {"1": 25}}})";
  auto session = DesignSession::create(sketch, "{}");
  ASSERT_TRUE(session.ok()) << session.error().message;
  while (!session.value()->advance(1000)) {
  }
  const model::Model model = model::readModel(session.value()->modelJson()).value();
  int orange = 0;
  for (const model::PlacedPart& part : model.parts) {
    orange += part.color == 25 ? 1 : 0;
  }
  EXPECT_EQ(orange, 1);
  EXPECT_EQ(sketch::coloursOf(model.sketchJson).lines.at(1), 25);
}

}  // namespace
}  // namespace liftarm::design
