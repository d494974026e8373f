#include "motion/KeyframePlayer.h"

#include <gtest/gtest.h>

namespace plumbline::motion {
namespace {

KeyframeMotion twoFrames() {
  KeyframeMotion motion;
  motion.keyframes.resize(2);
  motion.keyframes[0].seconds = 0.1;
  motion.keyframes[0].angles[lKneePitch] = 1.0;
  motion.keyframes[0].set[lKneePitch] = true;
  motion.keyframes[1].seconds = 0.03;
  motion.keyframes[1].angles[rKneePitch] = -0.3;
  motion.keyframes[1].set[rKneePitch] = true;
  return motion;
}

TEST(KeyframePlayerTest, interpolatesInStraightLines) {
  KeyframePlayer player;
  JointArray from{};
  from[lKneePitch] = 0.5;
  from[lShoulderPitch] = 0.7;
  player.start(twoFrames(), from);
  for (int i = 1; i <= 4; ++i) {
    player.step(0.02, false);
    EXPECT_NEAR(player.angles()[lKneePitch], 0.5 + 0.1 * i, 1e-12);
    EXPECT_FALSE(player.joints()[rKneePitch]);
  }
  player.step(0.02, false);
  EXPECT_NEAR(player.angles()[lKneePitch], 1.0, 1e-12);
  EXPECT_TRUE(player.joints()[rKneePitch]);
  EXPECT_FALSE(player.finished());
  player.step(0.02, false);
  EXPECT_NEAR(player.angles()[rKneePitch], -0.2, 1e-12);
  player.step(0.02, false);
  EXPECT_NEAR(player.angles()[rKneePitch], -0.3, 1e-12);
  EXPECT_TRUE(player.finished());
  EXPECT_DOUBLE_EQ(player.angles()[lShoulderPitch], 0.7);
  EXPECT_FALSE(player.joints()[lShoulderPitch]);
  player.step(0.02, false);
  EXPECT_NEAR(player.angles()[rKneePitch], -0.3, 1e-12);
}

TEST(KeyframePlayerTest, timesNeedNotBeWholeCycles) {
  KeyframeMotion motion = twoFrames();
  motion.keyframes[0].seconds = 0.05;
  KeyframePlayer player;
  player.start(motion, {});
  player.step(0.02, false);
  player.step(0.02, false);
  EXPECT_NEAR(player.angles()[lKneePitch], 0.8, 1e-12);
  // 10 ms of this cycle are the second keyframe's.
  player.step(0.02, false);
  EXPECT_NEAR(player.angles()[lKneePitch], 1.0, 1e-12);
  EXPECT_NEAR(player.angles()[rKneePitch], -0.1, 1e-12);
  player.step(0.02, false);
  EXPECT_TRUE(player.finished());
}

TEST(KeyframePlayerTest, waitsUntilStillOrTheTimeIsUp) {
  KeyframeMotion motion = twoFrames();
  motion.keyframes[0].settleSeconds = 0.06;
  KeyframePlayer player;
  player.start(motion, {});
  for (int i = 0; i < 7; ++i) player.step(0.02, false);
  EXPECT_EQ(player.keyframe(), 0u);
  player.step(0.02, false);
  EXPECT_EQ(player.keyframe(), 1u);
  player.start(motion, {});
  for (int i = 0; i < 4; ++i) player.step(0.02, true);
  EXPECT_EQ(player.keyframe(), 0u) << "still does not cut the movement short";
  player.step(0.02, true);
  EXPECT_EQ(player.keyframe(), 1u);
}

TEST(KeyframePlayerTest, noKeyframesIsFinished) {
  KeyframePlayer player;
  EXPECT_TRUE(player.finished());
  JointArray from{};
  from[headYaw] = 0.3;
  player.start({}, from);
  player.step(0.02, true);
  EXPECT_TRUE(player.finished());
  EXPECT_DOUBLE_EQ(player.angles()[headYaw], 0.3);
}

}  // namespace
}  // namespace plumbline::motion
