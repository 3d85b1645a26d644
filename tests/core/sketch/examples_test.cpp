//! The gallery of the page: every drawing of public/examples is a valid sketch, and is listed.
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/sketch/sketch_text.h"
#include "sketch/arrangement.h"

namespace liftarm::sketch {
namespace {

std::filesystem::path folder() {
  return std::filesystem::path(LIFTARM_SOURCE_DIR) / "public" / "examples";
}

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file.good()) << path;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> listedFiles() {
  std::vector<std::string> files;
  for (const nlohmann::json& entry : nlohmann::json::parse(textOf(folder() / "index.json"))) {
    for (const char* language : {"en", "de"}) {
      EXPECT_FALSE(entry.at("name").at(language).get<std::string>().empty());
      EXPECT_FALSE(entry.at("description").at(language).get<std::string>().empty());
    }
    EXPECT_EQ(entry.at("id").get<std::string>() + ".sketch.json", entry.at("file"));
    files.push_back(entry.at("file").get<std::string>());
  }
  return files;
}

TEST(Examples, AreAllListedOnce) {
  std::multiset<std::string> listed;
  for (const std::string& file : listedFiles()) {
    listed.insert(file);
  }
  std::multiset<std::string> present;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().filename() != "index.json") {
      present.insert(entry.path().filename().string());
    }
  }
  EXPECT_EQ(listed, present);
}

TEST(Examples, AreOneConnectedPieceEachWithAPinWhereLinesMeet) {
  for (const std::string& file : listedFiles()) {
    const base::Result<Sketch> result = readSketch(textOf(folder() / file));
    ASSERT_TRUE(result.ok()) << file << ": " << result.error().message;
    const Arrangement arrangement = arrange(result.value());
    EXPECT_EQ(arrangement.pieces, 1) << file;
    EXPECT_TRUE(arrangement.offNodeCrossings.empty()) << file;
    EXPECT_LT(result.value().residual, 1e-9) << file;
  }
}

TEST(Examples, AreSmallEnoughToUnderstand) {
  for (const std::string& file : listedFiles()) {
    const base::Result<Sketch> result = readSketch(textOf(folder() / file));
    ASSERT_TRUE(result.ok()) << file;
    EXPECT_LE(result.value().lines.size(), 40U) << file;
  }
}

}  // namespace
}  // namespace liftarm::sketch
