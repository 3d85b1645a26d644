#include "gears/gear_frame.h"

#include <string>

#include <gtest/gtest.h>

#include "gears/gear_sizes.h"
#include "gears/shaft_plan.h"
#include "parts/catalogue.h"
#include "sketch/shaft_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::gears {
namespace {

TrainRequest requestFor(Place to, double ratio) {
  TrainRequest request;
  request.to = to;
  request.ratio = ratio;
  for (const GearSize& size : gearSizesOf(parts::Catalogue::builtIn().parts())) {
    request.teeth.push_back(size.teeth);
  }
  return request;
}

//! The shafts of the train that a frame was drawn for are planned again in it.
TEST(GearFrame, HasBearingsForAllOfItsTrain) {
  for (const Place to : {Place{3, 0}, Place{0, 9}, Place{6, 3}, Place{17, -17}, Place{-20, 5}}) {
    const TrainRequest request = requestFor(to, 9.0);
    const auto train = findTrain(request);
    ASSERT_TRUE(train.has_value());
    const std::string text = gearFrame(*train, request);
    const auto sketch = sketch::readSketch(text);
    ASSERT_TRUE(sketch.ok()) << sketch.error().message;
    const auto plan = planShafts(sketch.value(), sketch::shaftsOf(text));
    ASSERT_TRUE(plan.ok()) << plan.error().message;
    EXPECT_EQ(plan.value().shafts.size(), train->shafts.size()) << to.u << ' ' << to.v;
  }
}

TEST(GearFrame, HasNoColumnThatIsLongerThanABeam) {
  const TrainRequest request = requestFor({20, 18}, 1.0);
  const auto train = findTrain(request);
  ASSERT_TRUE(train.has_value());
  const std::string text = gearFrame(*train, request);
  const auto sketch = sketch::readSketch(text);
  ASSERT_TRUE(sketch.ok());
  const auto plan = planShafts(sketch.value(), sketch::shaftsOf(text));
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  for (const sketch::Line& line : plan.value().sketch.lines) {
    EXPECT_TRUE(!line.exact || (line.length <= 14 && line.length % 2 == 0));
  }
}

}  // namespace
}  // namespace liftarm::gears
