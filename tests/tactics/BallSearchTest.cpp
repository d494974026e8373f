#include "tactics/BallSearch.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(BallSearchTest, turnsAwayFromWhereTheBallWasBelievedWhenItWasLost) {
  BallSearch search;
  EXPECT_LT(search.turn({1, 0.5}, 10), 0);
  EXPECT_LT(search.turn({1, -0.5}, 10.02), 0) << "the robot has turned; the search goes on";
  EXPECT_GT(search.turn({1, -0.5}, 11), 0) << "the ball was there meanwhile";
}

TEST(BallSearchTest, turnsLeftWithoutABelief) {
  BallSearch search;
  EXPECT_GT(search.turn(Vec2::Zero(), 0), 0);
}

}  // namespace
}  // namespace plumbline
