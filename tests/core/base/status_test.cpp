#include "base/status.h"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "base/run_control.h"

namespace liftarm::base {
namespace {

TEST(Result, HoldsItsValue) {
  const Result<std::string> result(std::string("beam"));
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value(), "beam");
}

TEST(Result, HoldsItsError) {
  const Result<int> result(Error{Status::kUnsupported, "lines[3]: no"});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().status, Status::kUnsupported);
  EXPECT_EQ(result.error().message, "lines[3]: no");
}

TEST(Result, GivesItsValueAway) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
  const std::unique_ptr<int> value = std::move(result).value();
  EXPECT_EQ(*value, 7);
}

TEST(ResultDeathTest, ReadingTheWrongSideIsABug) {
  const Result<int> good(1);
  const Result<int> bad(Error{Status::kInfeasible, "none"});
  EXPECT_DEATH((void)good.error(), "error\\(\\) of a good Result");
  EXPECT_DEATH((void)bad.value(), "value\\(\\) of a failed Result");
}

TEST(CheckDeathTest, NamesTheConditionAndItsPlace) {
  EXPECT_DEATH(LIFTARM_CHECK(1 + 1 == 3, "sums"), "status_test.cpp:[0-9]+: .*sums.*1 \\+ 1 == 3");
}

TEST(RunControl, RemembersTheRequestToStop) {
  RunControl control;
  EXPECT_FALSE(control.stopRequested());
  control.requestStop();
  EXPECT_TRUE(control.stopRequested());
}

}  // namespace
}  // namespace liftarm::base
