#include <gtest/gtest.h>

#include "StandUpTrial.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::motion {
namespace {

/// Robot type and direction of the fall: 1 forward, -1 backward, 0 to a side.
class StandUpTest : public testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(StandUpTest, isUpSoonAndWalksOn) {
  const auto [type, direction] = GetParam();
  MotionTrial trial(type);
  int trials = 0;
  for (unsigned seed = 1; trials < 2; ++seed) {
    const auto result = standUpTrial(trial, direction, seed);
    if (!result) continue;  // it did not fall
    ++trials;
    EXPECT_TRUE(result->up) << "seed " << seed;
    EXPECT_LT(result->seconds, 8) << "seed " << seed;
    EXPECT_TRUE(result->walked) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(AllTypes, StandUpTest,
                         testing::Combine(testing::Range(0, numSimsparkTypes()), testing::Values(1, -1, 0)));

class KickTest : public testing::TestWithParam<int> {};

TEST_P(KickTest, carriesTwoMetresAndDoesNotFall) {
  MotionTrial trial(GetParam());
  for (const Side foot : {Side::right, Side::left})
    for (unsigned seed = 1; seed <= 2; ++seed) {
      const KickResult result = kickTrial(trial, foot, 0.015, seed);
      EXPECT_FALSE(result.fell) << "seed " << seed;
      EXPECT_GT(result.distance, 2.0) << "seed " << seed;
      EXPECT_LT(std::abs(result.angle), 0.25) << "seed " << seed;
      EXPECT_LE(result.seconds, 1.0);
    }
}

INSTANTIATE_TEST_SUITE_P(AllTypes, KickTest, testing::Range(0, numSimsparkTypes()));

/// The skills stand where a kick's file says; a type without one could not play.
TEST(KickTest, everyTypeHasKicksThatSayWhereTheyWantTheBall) {
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    const MotionTrial trial(type);
    EXPECT_TRUE(trial.motion("kickRight").kick) << type;
    for (const KeyframeMotion& motion : trial.motions) {
      if (!motion.kick) continue;
      EXPECT_GT(motion.ball.x(), 0.1) << type << " " << motion.name;
      EXPECT_LT(motion.ball.x(), 0.3) << type << " " << motion.name;
    }
  }
}

}  // namespace
}  // namespace plumbline::motion
