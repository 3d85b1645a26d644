#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "design/settings.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

// The page's readers and the schemas are tested against the same table (odd-inputs.test.ts).

namespace liftarm::design {
namespace {

using nlohmann::json;

json rowsOf(const char* kind) {
  std::ifstream file(std::string(LIFTARM_SOURCE_DIR) + "/tests/contract/odd-inputs.json");
  std::stringstream text;
  text << file.rdbuf();
  const json table = json::parse(text.str(), nullptr, false);
  EXPECT_TRUE(table.is_object() && !table[kind].empty());
  return table.is_object() ? table[kind] : json::array();
}

template <typename Read>
void expectTable(const char* kind, const char* member, const Read& read) {
  for (const json& row : rowsOf(kind)) {
    const auto answer = read(row[member].dump());
    EXPECT_EQ(answer.ok(), row["ok"].get<bool>())
        << row["name"] << ": " << (answer.ok() ? "accepted" : answer.error().message);
  }
}

TEST(OddInputs, SketchesAreReadAsTheTableSays) {
  expectTable(
      "sketches", "sketch", [](const std::string& text) { return sketch::readSketch(text); });
}

TEST(OddInputs, ModelsAreReadAsTheTableSays) {
  expectTable("models", "model", [](const std::string& text) { return model::readModel(text); });
}

TEST(OddInputs, SettingsAreReadAsTheTableSays) {
  expectTable("settings", "settings", [](const std::string& text) { return readSettings(text); });
}

}  // namespace
}  // namespace liftarm::design
