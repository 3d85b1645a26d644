#include "base/plain_text.h"

#include <gtest/gtest.h>

namespace liftarm::base {
namespace {

TEST(PlainText, LeavesWordsOfAnyScriptAlone) {
  EXPECT_EQ(plainText("Brücke 橋 ~ \xF0\x9F\xA7\xB1"), "Brücke 橋 ~ \xF0\x9F\xA7\xB1");
}

TEST(PlainText, TakesControlCharactersOut) {
  EXPECT_EQ(plainText("a\x1B[31mb\nc\x7F"), "a [31mb c ");
  EXPECT_EQ(plainText("a\xC2\x9B"
                      "b"),
            "a b");  // C1, as UTF-8
}

TEST(PlainText, TakesMarksThatTurnTheWritingOut) {
  EXPECT_EQ(plainText("a\xE2\x80\xAE"
                      "b\xE2\x80\xA8"),
            "a b ");
}

TEST(PlainText, ShowsBytesThatAreNoTextAsQuestions) {
  EXPECT_EQ(plainText("a\x9B\xC2"), "a??");
  EXPECT_EQ(plainText("\xE2\x80"), "??");
}

}  // namespace
}  // namespace liftarm::base
