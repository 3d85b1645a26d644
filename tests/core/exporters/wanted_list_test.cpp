#include "exporters/wanted_list.h"

#include <string>

#include <gtest/gtest.h>

#include "core/helpers/models.h"
#include "exporters/parts_list.h"
#include "exporters/spreadsheet.h"

namespace liftarm::exporters {
namespace {

model::Model twoBeams(int color) {
  model::Model model;
  for (const double x : {0.0, 4.0}) {
    model::PlacedPart part = testing::partAt("32316", {x, 0, 0});
    part.color = color;
    model.parts.push_back(part);
  }
  return model;
}

TEST(WantedList, HasOneItemForPartAndColour) {
  EXPECT_EQ(writeWantedList(twoBeams(0)).value(),
            "<INVENTORY>\n<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>32316</ITEMID><COLOR>11</COLOR>"
            "<MINQTY>2</MINQTY></ITEM>\n</INVENTORY>\n");
}

TEST(WantedList, KnowsTheColourOfEveryCataloguePart) {
  for (const parts::Part& part : parts::Catalogue::builtIn().parts()) {
    EXPECT_NE(findColourIds(part.color), nullptr) << part.id;
  }
}

TEST(WantedList, HasTheNumbersThatAreKnownFromElsewhere) {
  EXPECT_EQ(findColourIds(1)->brickLink, 7);
  EXPECT_EQ(findColourIds(4)->brickLink, 5);
  EXPECT_EQ(findColourIds(14)->brickLink, 3);
  EXPECT_EQ(findColourIds(71)->brickLink, 86);
  EXPECT_EQ(findColourIds(72)->brickLink, 85);
}

TEST(WantedList, RefusesAColourWithoutANumber) {
  const auto list = writeWantedList(twoBeams(9999));
  ASSERT_FALSE(list.ok());
  EXPECT_NE(list.error().message.find("colour 9999 of part 32316"), std::string::npos);
}

TEST(WantedList, KeepsMarkupOfAPartNumberOut) {
  model::Model model = twoBeams(0);
  model.parts[0].part = "<a href=\"x\">&";
  model.parts.pop_back();
  const std::string list = writeWantedList(model).value();
  EXPECT_NE(list.find("<ITEMID>_a_href__x___</ITEMID>"), std::string::npos) << list;
}

TEST(PartsCsv, HasRebrickablesOwnColourNumbers) {
  EXPECT_EQ(writePartsCsv(twoBeams(330)), "Part,Color,Quantity\n32316,326,2\n");
}

TEST(Spreadsheet, HasNameNumberColourCountAndMass) {
  EXPECT_EQ(writeSpreadsheet(twoBeams(0), parts::Catalogue::builtIn()),
            "Name,Number,Colour,Count,Mass each (g),Mass (g),Mass is an estimate\n"
            "\"Technic Beam 5\",\"32316\",\"Black\",2,1.34,2.68,no\n"
            "Sum,,,2,,2.68,no\n");
}

TEST(Spreadsheet, MakesFormulasHarmless) {
  model::Model model = twoBeams(0);
  model.parts[0].part = "=1+\"2\"";
  model.parts.pop_back();
  const std::string table = writeSpreadsheet(model, parts::Catalogue::builtIn());
  EXPECT_NE(table.find("\"'=1+\"\"2\"\"\""), std::string::npos) << table;
}

}  // namespace
}  // namespace liftarm::exporters
