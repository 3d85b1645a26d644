#include "exporters/ldraw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/ldraw_geometry.h"
#include "core/helpers/models.h"
#include "core/helpers/shared_data.h"
#include "exporters/parts_list.h"

namespace liftarm::exporters {
namespace {

using lattice::Vec3;

struct LdrawLine {
  int color = 0;
  std::array<double, 12> numbers{};
  std::string file;
};

std::optional<LdrawLine> readLine(const std::string& text) {
  std::istringstream fields(text);
  int type = 0;
  LdrawLine parsed;
  if (!(fields >> type) || type != 1) {
    return std::nullopt;
  }
  fields >> parsed.color;
  for (double& number : parsed.numbers) {
    fields >> number;
  }
  std::getline(fields >> std::ws, parsed.file);
  return parsed;
}

//! What a line places, placed by a line that refers to the file it is in.
LdrawLine composed(const LdrawLine& outer, const LdrawLine& inner) {
  LdrawLine result = inner;
  const auto& m = outer.numbers;
  const auto& n = inner.numbers;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t row = 3 + 3 * i;
    result.numbers[i] = m[i] + m[row] * n[0] + m[row + 1] * n[1] + m[row + 2] * n[2];
    for (std::size_t j = 0; j < 3; ++j) {
      result.numbers[row + j] = m[row] * n[3 + j] + m[row + 1] * n[6 + j] + m[row + 2] * n[9 + j];
    }
  }
  return result;
}

using LdrawFiles = std::map<std::string, std::vector<LdrawLine>>;

void place(const LdrawFiles& files, const LdrawLine& line, std::vector<LdrawLine>& parts) {
  const auto submodel = files.find(line.file);
  if (submodel == files.end()) {
    parts.push_back(line);
    return;
  }
  for (const LdrawLine& inner : submodel->second) {
    place(files, composed(line, inner), parts);
  }
}

//! All parts of a document, submodels resolved.
std::vector<LdrawLine> partLines(const std::string& text) {
  LdrawFiles files;
  std::string first;
  std::string file;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("0 FILE ", 0) == 0) {
      file = line.substr(7);
      first = first.empty() ? file : first;
      files[file];
    } else if (const auto parsed = readLine(line)) {
      files[file].push_back(*parsed);
    }
  }
  std::vector<LdrawLine> parts;
  place(files, {16, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, first}, parts);
  return parts;
}

std::string written(const model::Model& model) {
  return writeLdraw(model, parts::Catalogue::builtIn());
}

//! Where LDraw puts a point of its part frame, LDU.
Vec3 placedByLdraw(const LdrawLine& line, Vec3 p) {
  const auto& n = line.numbers;
  return {n[0] + n[3] * p.x + n[4] * p.y + n[5] * p.z,
          n[1] + n[6] * p.x + n[7] * p.y + n[8] * p.z,
          n[2] + n[9] * p.x + n[10] * p.y + n[11] * p.z};
}

//! Three squares, one of them turned and one in another colour: each is a subassembly.
model::Model threeSquares() {
  model::Model model = testing::squareFrame();
  const model::Model square = model;
  for (model::PlacedPart part : square.parts) {
    const lattice::Mat3 turn{{0, -1, 0, 1, 0, 0, 0, 0, 1}};
    part.pose = {turn * part.pose.position + Vec3{30, 1, 0}, turn * part.pose.rotation};
    model.parts.push_back(part);
  }
  for (model::PlacedPart part : square.parts) {
    part.pose.position = part.pose.position + Vec3{0, 20, 0};
    part.color = 4;
    model.parts.push_back(part);
  }
  return model;
}

std::vector<model::Model> exportedModels() {
  std::vector<model::Model> models = testing::buildableModels();
  models.push_back(threeSquares());
  return models;
}

Vec3 toLdraw(Vec3 ours) {
  return {20 * ours.x, -20 * ours.z, 20 * ours.y};
}

TEST(Ldraw, WritesOneLineForEveryPart) {
  for (const model::Model& model : exportedModels()) {
    EXPECT_EQ(partLines(written(model)).size(), model.parts.size());
  }
}

TEST(Ldraw, MatricesAreProperRotations) {
  for (const model::Model& model : exportedModels()) {
    for (const LdrawLine& line : partLines(written(model))) {
      const auto& n = line.numbers;
      const Vec3 x{n[3], n[6], n[9]};
      const Vec3 y{n[4], n[7], n[10]};
      const Vec3 z{n[5], n[8], n[11]};
      EXPECT_NEAR(lattice::dot(x, x), 1.0, 1e-5);
      EXPECT_NEAR(lattice::dot(y, y), 1.0, 1e-5);
      EXPECT_LT(lattice::length(lattice::cross(x, y) - z), 1e-5);
    }
  }
}

TEST(Ldraw, EveryFeatureLandsWhereTheModelHasIt) {
  for (const model::Model& model : exportedModels()) {
    const std::vector<LdrawLine> lines = partLines(written(model));
    for (const model::PlacedPart& placed : model.parts) {
      const parts::Part& part = *parts::Catalogue::builtIn().find(placed.part);
      bool found = false;
      for (const LdrawLine& line : lines) {
        double worst = line.file == placed.part + ".dat" ? 0.0 : 1e9;
        for (const parts::Feature& feature : part.features) {
          const Vec3 expected = toLdraw(placed.pose.apply(feature.center));
          const Vec3 got = placedByLdraw(line, toLdraw(feature.center));
          worst = std::max(worst, lattice::length(got - expected));
        }
        found = found || worst < 1e-3;
      }
      EXPECT_TRUE(found) << model.name << " " << placed.part;
    }
  }
}

TEST(Ldraw, EveryPartOfTheCatalogueIsInTheLibrary) {
  LIFTARM_NEED_SHARED_DATA();
  for (const parts::Part& part : parts::Catalogue::builtIn().parts()) {
    EXPECT_TRUE(testing::readSharedFile("ldraw/parts/" + part.id + ".dat").has_value()) << part.id;
  }
}

TEST(Ldraw, StepsGoUpwards) {
  const std::string text = written(testing::squareFrame());
  EXPECT_EQ(text.find("0 FILE Square.ldr\n"), 0U);
  EXPECT_GT(text.find("0 STEP"), text.find("1 "));
  // LDraw's y points down: no step may begin above the one after it.
  double last = 1e9;
  for (const LdrawLine& line : partLines(text)) {
    EXPECT_LE(line.numbers[1], last + 20.0);
    last = line.numbers[1];
  }
}

TEST(Ldraw, ARepeatedSubassemblyIsOneSubmodel) {
  const std::string text = written(threeSquares());
  std::size_t files = 0;
  for (std::size_t at = text.find("0 FILE "); at != std::string::npos;
       at = text.find("0 FILE ", at + 1)) {
    ++files;
  }
  // The whole, the first square with its copy, and the one of another colour.
  EXPECT_EQ(files, 3U);
}

TEST(Ldraw, ANameCannotBreakTheFile) {
  model::Model model = testing::squareFrame();
  model.name = "a\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat\r";
  EXPECT_EQ(partLines(written(model)).size(), model.parts.size());
}

TEST(Ldraw, NamesHoldNoMoreThanOneSpaceInARow) {
  model::Model model = testing::squareFrame();
  model.name = "  Big  bridge\t\xC2\x9B of  ours ";
  const std::string text = writeLdraw(model, parts::Catalogue::builtIn());
  EXPECT_EQ(text.rfind("0 FILE Big bridge of ours.ldr\n0 Big bridge of ours\n", 0), 0U);
}

TEST(Ldraw, ANameIsNoCommand) {
  for (const std::string name : {"FILE x", "NOFILE", "STEP", "!LDCAD"}) {
    model::Model model = testing::squareFrame();
    model.name = name;
    const std::string text = writeLdraw(model, parts::Catalogue::builtIn());
    EXPECT_EQ(text.rfind("0 FILE " + name + ".ldr\n0 Model " + name + "\n", 0), 0U) << text;
  }
}

TEST(PartsList, CountsPartsByNumberAndColour) {
  EXPECT_EQ(writePartsCsv(testing::squareFrame()), "Part,Color,Quantity\n2780,71,4\n40490,71,4\n");
}

}  // namespace
}  // namespace liftarm::exporters
