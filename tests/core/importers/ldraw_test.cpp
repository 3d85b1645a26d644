#include "importers/ldraw.h"

#include <string>

#include <gtest/gtest.h>

#include "importers/part_numbers.h"
#include "importers/text_encoding.h"

namespace liftarm::importers {
namespace {

constexpr const char* kBeam = " 0 0 0 1 0 0 0 1 0 0 0 1 32523.dat\n";
constexpr const char* kArm = " 0 0 0 1 0 0 0 1 0 0 0 1 arm.ldr\n";

base::Result<Imported> read(const std::string& text) {
  return readLdraw(text, parts::Catalogue::builtIn());
}

std::string refusalOf(const std::string& text) {
  const base::Result<Imported> imported = read(text);
  return imported.ok() ? std::string() : imported.error().message;
}

TEST(Ldraw, PlacesPartsWhereTheyLieInOurFrame) {
  const base::Result<Imported> imported = read("1 4 20 -40 60 1 0 0 0 1 0 0 0 1 32523.dat\n");
  ASSERT_TRUE(imported.ok());
  ASSERT_EQ(imported.value().model.parts.size(), 1U);
  const model::PlacedPart& part = imported.value().model.parts.front();
  EXPECT_EQ(part.part, "32523");
  EXPECT_EQ(part.color, 4);
  EXPECT_EQ(part.pose.position, (lattice::Vec3{1, 3, 2}));
}

TEST(Ldraw, FollowsSubmodelsAndTheirColour) {
  const std::string text = std::string("0 FILE Main.ldr\n1 4") + kArm + "1 14" + kArm +
                           "0 FILE ARM.LDR\n1 16" + kBeam + "0 NOFILE\n1 0" + kBeam;
  const base::Result<Imported> imported = read(text);
  ASSERT_TRUE(imported.ok());
  ASSERT_EQ(imported.value().model.parts.size(), 2U);
  EXPECT_EQ(imported.value().model.parts[0].color, 4);
  EXPECT_EQ(imported.value().model.parts[1].color, 14);
  EXPECT_EQ(imported.value().model.name, "Main");
}

TEST(Ldraw, KeepsTheLettersOfANameAndNotItsEnding) {
  for (const char* ending : {".ldr", ".LDR", ".Mpd", ""}) {
    const std::string file = std::string("0 FILE My  Chair") + ending + "\n1 4" + kBeam;
    EXPECT_EQ(read(file).value().model.name, "My Chair") << ending;
  }
}

TEST(Ldraw, TakesTheFirstOfTwoFilesOfOneName) {
  const std::string text = std::string("0 FILE main.ldr\n1 4") + kArm + "0 FILE arm.ldr\n1 16" +
                           kBeam + "0 FILE arm.ldr\n1 16" + kBeam + "1 16" + kBeam;
  const base::Result<Imported> imported = read(text);
  ASSERT_TRUE(imported.ok());
  EXPECT_EQ(imported.value().model.parts.size(), 1U);
  ASSERT_EQ(imported.value().notes.size(), 1U);
  EXPECT_EQ(imported.value().notes.front(),
            "arm.ldr stands there more than once; the first counts");
}

TEST(Ldraw, NamesWhatIsNotKnownWithCounts) {
  const std::string brick = "1 4 0 0 0 1 0 0 0 1 0 0 0 1 parts\\3001.DAT\n";
  const base::Result<Imported> imported = read(brick + brick + "1 4" + kBeam);
  ASSERT_TRUE(imported.ok());
  ASSERT_EQ(imported.value().notes.size(), 1U);
  EXPECT_EQ(imported.value().notes.front(),
            "parts that are not known here are not judged: 3001 (2)");
  EXPECT_EQ(refusalOf(brick), "parts that are not known here are not judged: 3001 (1)");
}

TEST(Ldraw, RefusesWhatHoldsItselfAndWhatMultiplies) {
  EXPECT_EQ(refusalOf(std::string("0 FILE arm.ldr\n1 16") + kArm),
            "arm.ldr: the submodel holds itself");
  std::string bomb;
  for (int level = 0; level < 8; ++level) {
    bomb += "0 FILE " + std::to_string(level) + ".ldr\n";
    for (int i = 0; i < 30; ++i) {
      bomb += "1 16 0 0 0 1 0 0 0 1 0 0 0 1 " + std::to_string(level + 1) + ".ldr\n";
    }
  }
  EXPECT_EQ(refusalOf(bomb + "0 FILE 8.ldr\n1 16" + kBeam),
            "submodels and parts are more than 400000, which is the limit");
}

TEST(Ldraw, NamesTheLineThatIsNoPart) {
  EXPECT_EQ(refusalOf("0 A model\r\r1 4 0 0 0 1 0 0 0 1 0 0 0 x 32523.dat\n"),
            "line 3: a part needs a colour, twelve numbers and a file name");
  EXPECT_EQ(refusalOf("0 A model\n"), "the file holds no parts (lines that begin with \"1\")");
}

TEST(Ldraw, TurnsAMirroredPartThatIsItsOwnImage) {
  const base::Result<Imported> imported = read("1 4 0 0 0 -1 0 0 0 1 0 0 0 1 32523.dat\n");
  ASSERT_TRUE(imported.ok());
  const auto& m = imported.value().model.parts.front().pose.rotation.m;
  const double determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) -
                             m[1] * (m[3] * m[8] - m[5] * m[6]) +
                             m[2] * (m[3] * m[7] - m[4] * m[6]);
  EXPECT_EQ(determinant, 1.0);
}

TEST(Ldraw, TakesTheNearestColourOfOneThatIsMixed) {
  const auto colorOf = [](const std::string& written) {
    const base::Result<Imported> imported = read("1 " + written + kBeam);
    return imported.ok() ? imported.value().model.parts.front().color : -1;
  };
  EXPECT_EQ(colorOf("0x2FF0000"), 4);
  EXPECT_EQ(colorOf("#2FFFFFF"), 15);
  EXPECT_EQ(colorOf("9999"), 71);
  EXPECT_EQ(colorOf("16"), 7);
  EXPECT_EQ(colorOf("red"), -1);
}

TEST(Ldraw, IsToldFromOtherFiles) {
  EXPECT_TRUE(looksLikeLdraw("\n  // by hand\n0 Untitled\n"));
  EXPECT_TRUE(looksLikeLdraw("0"));
  EXPECT_TRUE(looksLikeLdraw("\t1 4" + std::string(kBeam)));
  EXPECT_FALSE(looksLikeLdraw("1 4 0 0\n"));
  EXPECT_FALSE(looksLikeLdraw("{\"format\": \"liftarm-model\"}"));
  EXPECT_FALSE(looksLikeLdraw("0123"));
  EXPECT_FALSE(looksLikeLdraw(""));
}

TEST(PartNumbers, AreKnownUnderTheirOtherNamesToo) {
  const parts::Catalogue& catalogue = parts::Catalogue::builtIn();
  const auto idOf = [&](std::string_view name) {
    const parts::Part* part = knownPart(name, catalogue);
    return part != nullptr ? part->id : std::string();
  };
  EXPECT_EQ(idOf("s/32316.dat"), "32316");
  EXPECT_EQ(idOf("32316pr0001"), "32316");
  EXPECT_EQ(idOf("3713a.dat"), "3713");
  EXPECT_EQ(idOf("61332.dat"), "2780");
  EXPECT_EQ(idOf("32316x.dat"), "");
  EXPECT_EQ(idOf(""), "");
}

TEST(TextEncoding, BecomesUtf8) {
  EXPECT_EQ(decodedText("\xEF\xBB\xBF\x30 \xC3\xA4"), "0 \xC3\xA4");
  EXPECT_EQ(decodedText("0 \xE4\x80"), "0 \xC3\xA4\xE2\x82\xAC");
  EXPECT_EQ(decodedText(std::string_view("\xFF\xFE\x30\x00\xE4\x00", 6)), "0\xC3\xA4");
  EXPECT_EQ(decodedText(std::string_view("\x00\x30\x00\x20\x00\x41", 6)), "0 A");
  EXPECT_EQ(decodedText(std::string_view("\xFF\xFE\x3D\xD8\x00\xDE", 6)), "\xF0\x9F\x98\x80");
}

}  // namespace
}  // namespace liftarm::importers
