#include "framework/StepTimes.h"

#include <gtest/gtest.h>

#include <utility>

namespace plumbline {
namespace {

using std::chrono::milliseconds;
using Given = std::vector<std::pair<std::size_t, std::uint64_t>>;

class StepTimesTest : public testing::Test {
protected:
  /// A cycle of two steps that ends so long after the last.
  bool cycle(milliseconds passed) {
    times_.put(0, 10 * cycles_);
    times_.put(1, 10 * cycles_ + 1);
    ++cycles_;
    return times_.next(now_ += passed);
  }
  Given emptied() {
    Given given;
    times_.empty([&](std::size_t step, std::uint64_t time) { given.emplace_back(step, time); });
    return given;
  }
  /// The first cycles, in which rows are due at once.
  void begin() {
    while (cycle(milliseconds(1)) && cycles_ < 64) emptied();
    emptied();
  }

  StepTimes times_{2};
  StepTimes::Clock::time_point now_{milliseconds(1000)};
  std::uint64_t cycles_ = 0;
};

TEST_F(StepTimesTest, isDueInEachOfTheFirstCycles) {
  for (int i = 0; i < 64; ++i) {
    EXPECT_TRUE(cycle(milliseconds(1))) << i;
    EXPECT_EQ(emptied().size(), 2u);
  }
  EXPECT_FALSE(cycle(milliseconds(1)));
}

TEST_F(StepTimesTest, givesEachStepItsDurationsInTheirOrder) {
  begin();
  cycle(milliseconds(1));
  cycle(milliseconds(1));
  EXPECT_EQ(emptied(), (Given{{0, 640}, {0, 650}, {1, 641}, {1, 651}}));
  EXPECT_EQ(emptied(), Given{});
}

TEST_F(StepTimesTest, isDueWhenItIsFullAndWhenTheOldestIsHalfASecondOld) {
  begin();
  for (int i = 0; i < 63; ++i) EXPECT_FALSE(cycle(milliseconds(1))) << i;
  EXPECT_TRUE(cycle(milliseconds(1)));
  EXPECT_EQ(emptied().size(), 128u);
  EXPECT_FALSE(cycle(milliseconds(20)));
  EXPECT_FALSE(cycle(milliseconds(499)));
  EXPECT_TRUE(cycle(milliseconds(1)));
}

TEST_F(StepTimesTest, aCycleThatDidNotEndIsNotGiven) {
  begin();
  times_.put(0, 7);
  EXPECT_EQ(times_.of(0), 7u);
  EXPECT_EQ(emptied(), Given{});
}

}  // namespace
}  // namespace plumbline
