#include "motion/Keyframes.h"

#include <gtest/gtest.h>

namespace plumbline::motion {
namespace {

TEST(KeyframesTest, mirroringTwiceGivesTheSameJoint) {
  for (int j = 0; j < maxJoints; ++j) {
    const auto joint = static_cast<JointId>(j);
    EXPECT_EQ(mirrored(mirrored(joint)), joint);
    EXPECT_EQ(mirrorSign(joint), mirrorSign(mirrored(joint)));
    if (joint > headPitch && joint < numHumanoidJoints) {
      const std::string_view name = humanoidJointNames[joint], other = humanoidJointNames[mirrored(joint)];
      EXPECT_EQ(name.substr(1), other.substr(1));
      EXPECT_NE(name.front(), other.front());
    }
  }
}

TEST(KeyframesTest, ownJointsAreMirroredByTheirRange) {
  const auto expectMirrored = [](int joint, int partner, double sign) {
    EXPECT_EQ(mirrored(static_cast<JointId>(joint)), partner);
    EXPECT_EQ(mirrorSign(static_cast<JointId>(joint)), sign) << joint;
  };
  expectMirrored(24, 24, 1);   // in the middle, pitch
  expectMirrored(36, 36, -1);  // in the middle, yaw or roll
  expectMirrored(44, 49, 1);   // pairs, pitch
  expectMirrored(53, 48, 1);
  expectMirrored(54, 59, -1);  // pairs, yaw or roll
  expectMirrored(63, 58, -1);
}

KeyframeMotion kick() {
  KeyframeMotion motion;
  motion.ball = Vec2(0.2, -0.05);
  motion.ballReach = Vec2(0.03, 0.02);
  Keyframe frame;
  frame.seconds = 0.1;
  frame.angles[rHipRoll] = 0.2;
  frame.set[rHipRoll] = true;
  frame.angles[lKneePitch] = 0.5;
  frame.set[lKneePitch] = true;
  frame.ballGains.push_back({rHipRoll, Vec2(0.5, 4)});
  motion.keyframes.assign(2, frame);
  return motion;
}

TEST(KeyframesTest, mirroredMotion) {
  const KeyframeMotion left = mirrored(kick());
  EXPECT_DOUBLE_EQ(left.ball.y(), 0.05);
  EXPECT_DOUBLE_EQ(left.keyframes[1].angles[lHipRoll], -0.2);
  EXPECT_TRUE(left.keyframes[1].set[lHipRoll]);
  EXPECT_FALSE(left.keyframes[1].set[rHipRoll]);
  EXPECT_DOUBLE_EQ(left.keyframes[1].angles[rKneePitch], 0.5);
  // The ball moves 1 cm to the left of its place: mirrored, 1 cm to the right.
  const KeyframeMotion a = mirrored(shiftedToBall(kick(), Vec2(0.21, -0.04)));
  const KeyframeMotion b = shiftedToBall(left, Vec2(0.21, 0.04));
  EXPECT_NEAR(a.keyframes[0].angles[lHipRoll], b.keyframes[0].angles[lHipRoll], 1e-15);
}

TEST(KeyframesTest, ballShiftsTheAnglesWithinReach) {
  const double near = shiftedToBall(kick(), Vec2(0.21, -0.06)).keyframes[0].angles[rHipRoll];
  EXPECT_NEAR(near, 0.2 + 0.5 * 0.01 - 4 * 0.01, 1e-12);
  const double far = shiftedToBall(kick(), Vec2(0.5, -0.5)).keyframes[0].angles[rHipRoll];
  EXPECT_NEAR(far, 0.2 + 0.5 * 0.03 - 4 * 0.02, 1e-12);
  EXPECT_DOUBLE_EQ(kick().seconds(), 0.2);
}

}  // namespace
}  // namespace plumbline::motion
