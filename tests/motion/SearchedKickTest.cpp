#include "motion/SearchedKick.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::motion {
namespace {

KeyframeMotion rightKick() {
  KeyframeMotion kick;
  kick.name = "some";
  kick.ball = Vec2(0.18, -0.05);
  kick.ballReach = Vec2(0.02, 0);
  kick.kick = KickEffect{.distance = 3, .direction = 0.1, .contact = 0.2};
  Keyframe frame;
  frame.seconds = 0.1;
  for (const JointId joint : {lHipPitch, rHipPitch}) {
    frame.angles[joint] = fromDegrees(-30);
    frame.set[joint] = true;
  }
  frame.ballGains.push_back({rHipPitch, Vec2(1, 0)});
  kick.keyframes.assign(2, frame);
  return kick;
}

TEST(SearchedKick, allAnglesAndTimesAndTheBallsPlaceAreNumbers) {
  const SearchedKick kick(rightKick(), simsparkRobot(0), Side::right);
  std::string names;
  for (const SearchedNumber& one : kick.list()) names += one.name + " ";
  EXPECT_EQ(names, "time1 LHipPitch1 RHipPitch1 time2 LHipPitch2 RHipPitch2 ballX ballY ");
  EXPECT_FALSE(kick.first().kick) << "what the first kick did is not what this one does";
  EXPECT_TRUE(kick.first().keyframes[0].ballGains.empty());
}

TEST(SearchedKick, isRoundedAsItsFileAndLosesWhatHasNoTime) {
  const SearchedKick kick(rightKick(), simsparkRobot(0), Side::right);
  Eigen::VectorXd x(8);
  x << 9.4, -31, -32, 120.4, -33.33, -34.36, 181.6, -52.3;
  const KeyframeMotion motion = kick.written(x, 0.02);
  ASSERT_EQ(motion.keyframes.size(), 1u) << "9 ms are less than half a cycle";
  EXPECT_DOUBLE_EQ(motion.keyframes[0].seconds, 0.12);
  EXPECT_DOUBLE_EQ(motion.keyframes[0].angles[lHipPitch], fromDegrees(-33.3));
  EXPECT_DOUBLE_EQ(motion.keyframes[0].angles[rHipPitch], fromDegrees(-34.4));
  EXPECT_DOUBLE_EQ(motion.ball.x(), 0.182);
  EXPECT_DOUBLE_EQ(motion.ball.y(), -0.052);
  x[0] = 10.4;
  EXPECT_EQ(kick.written(x, 0.02).keyframes.size(), 2u);
}

TEST(SearchedKick, theOtherFootsKickIsItsMirrorImage) {
  const SearchedKick kick(rightKick(), simsparkRobot(0), Side::left);
  EXPECT_DOUBLE_EQ(kick.first().ball.y(), 0.05);
  EXPECT_DOUBLE_EQ(kick.list().back().start, 50);
}

TEST(SearchedKick, aMotionWithoutABallIsRefused) {
  KeyframeMotion motion = rightKick();
  motion.ball = Vec2::Zero();
  try {
    SearchedKick(motion, simsparkRobot(0), Side::right);
    FAIL() << "taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "some is no kick: it has no ball");
  }
}

TEST(KickWish, costsAsFormula32SaysWithTheWayAsideAgainstIt) {
  const KickTry kick{.way = Vec2(9, -2), .height = 0.5, .milliseconds = 500, .error = 12};
  EXPECT_DOUBLE_EQ(KickWish().cost(kick), -30 * (9 - 2) - 120 * 0.5 + 12 + 0.08 * 500);
  const KickTry high{.way = Vec2(9, 0), .height = 3};
  EXPECT_DOUBLE_EQ(KickWish().cost(high), -30 * 9 - 120);
  const KickWish four{.distance = 4, .weight = 0, .steady = 2};
  EXPECT_DOUBLE_EQ(four.cost(kick), 30 * (5 + 2) + 2 * 12);
}

TEST(KickWish, underACeilingHeightIsWorthNothingAndMoreOfItCosts) {
  const KickWish shot{.weight = 0, .steady = 0, .ceiling = 0.8};
  EXPECT_DOUBLE_EQ(shot.cost({.way = Vec2(9, 0), .height = 0.7, .top = 0.75}), -30 * 9);
  EXPECT_DOUBLE_EQ(shot.cost({.way = Vec2(9, 0), .height = 1.2, .top = 1.1}), -30 * 9 + 60 + 300 * 0.3);
}

TEST(KickTry, aBallThatHardlyMovedHasNoDirection) {
  EXPECT_EQ((KickTry{.way = Vec2(-0.05, 0)}.direction()), 0);
  EXPECT_DOUBLE_EQ((KickTry{.way = Vec2(1, 1)}.direction()), pi / 4);
}

}  // namespace
}  // namespace plumbline::motion
