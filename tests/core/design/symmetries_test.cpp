#include "design/symmetries.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/sketches.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

TEST(Symmetries, CanBeAddedToTheSketchAsTheyAre) {
  const std::string text = sketch::writeSketch(testing::houseSketch());
  const base::Result<std::string> found = findSymmetriesJson(text);
  ASSERT_TRUE(found.ok());
  json sketch = json::parse(text);
  std::size_t rotations = 0;
  const json offered = json::parse(found.value());
  for (const json& symmetry : offered["symmetries"]) {
    if (symmetry["kind"] == "rotation") {
      ++rotations;
    } else {
      sketch["symmetries"].push_back(symmetry);
    }
  }
  ASSERT_FALSE(sketch["symmetries"].empty());
  // With all of them in the sketch nothing is left to offer but what the format cannot say.
  const base::Result<std::string> again = findSymmetriesJson(sketch.dump());
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(json::parse(again.value())["symmetries"].size(), rotations);
}

TEST(Symmetries, ComeWithWhatElseThereIsToSayOfTheSketch) {
  const base::Result<std::string> found = findSymmetriesJson(R"({"format": "technic-sketch",
      "version": 1, "lines": [{"from": [0, 0, 0], "to": [5, 0, 0]},
                              {"from": [2.5, -3, 0], "to": [2.5, 3, 0]}]})");
  ASSERT_TRUE(found.ok());
  const json note = json::parse(found.value())["notes"][0];
  EXPECT_EQ(note["kind"], "crossing");
  EXPECT_EQ(note["mend"], json::parse(R"([{"line": 1, "from": [3, -3, 0], "to": [3, 3, 0]}])"));
}

TEST(Symmetries, OfABrokenSketchAreRefusedWithItsMessage) {
  const base::Result<std::string> found = findSymmetriesJson(R"({"format": "other"})");
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("format"), std::string::npos);
}

}  // namespace
}  // namespace liftarm::design
