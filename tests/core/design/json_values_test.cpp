#include "design/json_values.h"

#include <cmath>

#include <gtest/gtest.h>

#include "model/number_text.h"

namespace liftarm::design {
namespace {

TEST(JsonValues, RoundAsTheTextOfAFileDoes) {
  for (const double value : {0.1234565, -2.5000005, 1.0 / 3.0, -1e-7, 123456.7890125, 4e-10}) {
    for (const int decimals : {1, 6, 9}) {
      const double read = std::stod(model::numberText(value, decimals));
      EXPECT_EQ(rounded(value, decimals), read) << value << " to " << decimals;
      EXPECT_FALSE(std::signbit(rounded(value, decimals)) && read == 0.0) << value;
    }
  }
}

TEST(JsonValues, LeaveNumbersAloneThatAreTooLargeToBeRounded) {
  EXPECT_EQ(rounded(1.5e12, 9), 1.5e12);
}

TEST(JsonValues, GivePointsAsLists) {
  EXPECT_EQ(pointJson({1, -0.0, 0.12345678}).dump(), "[1.0,0.0,0.123457]");
}

}  // namespace
}  // namespace liftarm::design
