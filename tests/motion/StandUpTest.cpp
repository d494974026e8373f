#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "StandUpTrial.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::motion {
namespace {

/// Robot type and direction of the fall: 1 forward, -1 backward, 0 to a side.
class StandUpTest : public testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(StandUpTest, isUpSoonAndWalksOn) {
  const auto [type, direction] = GetParam();
  MotionTrial trial(type);
  double soonest = HUGE_VAL;
  int trials = 0;
  for (unsigned seed = 1; trials < 7; ++seed) {
    const auto result = standUpTrial(trial, direction, seed);
    if (!result) continue;  // it did not fall
    ++trials;
    soonest = std::min(soonest, result->seconds);
    EXPECT_TRUE(result->up) << "seed " << seed;
    EXPECT_LT(result->seconds, 8) << "with two more tries, seed " << seed;
    EXPECT_TRUE(result->walked) << "seed " << seed;
  }
  // In 21 tries of each type 0.70 to 0.78 s from the front, 0.82 to 0.96 s from the back, and 1.3 to 1.6 s
  // from a side, if the first try succeeds. A sixth more shows.
  EXPECT_LT(soonest, direction > 0 ? 0.9 : direction < 0 ? 1.1 : 1.85);
}

INSTANTIATE_TEST_SUITE_P(AllTypes, StandUpTest,
                         testing::Combine(testing::Range(0, numSimsparkTypes()), testing::Values(1, -1, 0)));

/// How far the quick kick of each type carries: the least median of three times eight kicks [m].
constexpr std::array carried{3.39, 5.73, 4.07, 4.87, 6.20};

class KickTest : public testing::TestWithParam<int> {};

TEST_P(KickTest, carriesAsFarAsItDidAndDoesNotFall) {
  MotionTrial trial(GetParam());
  std::vector<double> distances;
  for (const Side foot : {Side::right, Side::left})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const KickResult result = kickTrial(trial, foot, 0.015, seed);
      distances.push_back(result.distance);
      EXPECT_FALSE(result.fell) << "seed " << seed;
      EXPECT_LE(result.seconds, 0.7);
      if (seed > 2) continue;  // a ball that lies 1.5 cm off may be touched badly
      EXPECT_GT(result.distance, 2.0) << "seed " << seed;
      EXPECT_LT(std::abs(result.angle), 0.25) << "seed " << seed;
    }
  std::ranges::sort(distances);
  const auto type = static_cast<std::size_t>(GetParam());
  const double reached = type < carried.size() ? carried[type] : std::ranges::min(carried);
  EXPECT_GT((distances[3] + distances[4]) / 2, 0.85 * reached);
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
