#include "walking/engine/BodyCommand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/ForwardKinematics.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::walking {
namespace {

class BodyCommandTest : public testing::Test {
protected:
  BodyCommandTest() {
    state.foot = {Pose2(0, 0.055), Pose2(0, -0.055)};
    p.posture.hipHeight = 0.22;
    p.feedback = {};
  }
  /// Some cycles of the same, in which the posture settles.
  const JointArray& command(bool stepping = false, double phase = 0, double lean = 0) {
    for (int i = 0; i < 6; ++i) body.update(state, stepping, swing, phase, lean, tilt, p, measured);
    return body.angles();
  }
  Vec3 sole(Side side) {
    ForwardKinematics kinematics(robot);
    kinematics.update(body.angles());
    const auto joint = static_cast<std::size_t>(firstLegJoint(side) + 5);
    return (kinematics.link(robot.linkOfJoint[joint]) * LegKinematics(robot, side).T_foot_sole())
        .translation();
  }
  RobotModel robot = simsparkRobot(0);
  BodyCommand body{robot};
  WalkState state;
  SwingTrajectory swing{.height = 0.03};
  TorsoTilt tilt;
  WalkParameters p;
  JointArray measured{};
};

TEST_F(BodyCommandTest, standsWithTheMassOverTheFeetAndTheHeadAsItIs) {
  measured[headYaw] = 0.4;
  const JointArray& angles = command();
  EXPECT_EQ(angles[headYaw], 0.4);
  EXPECT_NEAR(angles[lKneePitch], angles[rKneePitch], 1e-3);
  EXPECT_NEAR(sole(Side::left).z(), sole(Side::right).z(), 1e-3);
  EXPECT_NEAR(sole(Side::left).y() - sole(Side::right).y(), 0.11, 1e-3);
}

TEST_F(BodyCommandTest, theSwingFootIsLiftedByItsTrajectory) {
  state.support = Support::left;
  command(true, 0.5);
  EXPECT_NEAR(sole(Side::right).z() - sole(Side::left).z(), 0.03, 2e-3);
  command(true, 0);
  EXPECT_NEAR(sole(Side::right).z() - sole(Side::left).z(), 0, 2e-3);
}

TEST_F(BodyCommandTest, theArmsSwingAgainstTheLegs) {
  p.arms.swing = 2;
  p.arms.shoulderPitch = 1.5;
  state.foot[0].position.x() = 0.05;
  const JointArray& angles = command();
  EXPECT_NEAR(angles[lShoulderPitch], 1.5 + 2 * 0.05, 1e-12) << "the left foot is ahead, the left arm behind";
  EXPECT_NEAR(angles[rShoulderPitch], 1.5 - 2 * 0.05, 1e-12);
  EXPECT_EQ(angles[lShoulderRoll], -angles[rShoulderRoll]);
}

TEST_F(BodyCommandTest, hipsAndAnklesOfTheLegThatCarriesAnswerTheTilt) {
  p.feedback.hipPitchGain = 0.5;
  p.feedback.anklePitchRate = 0.1;
  state.support = Support::left;
  const JointArray before = command(true, 0.5);
  tilt.angle.y() = 0.1;
  tilt.rate.y() = 0.3;
  const JointArray& after = command(true, 0.5);
  EXPECT_NEAR(after[lHipPitch] - before[lHipPitch], 0.05, 1e-6);
  EXPECT_NEAR(after[lAnklePitch] - before[lAnklePitch], 0.03, 1e-6);
  EXPECT_NEAR(after[rHipPitch], before[rHipPitch], 1e-6) << "the leg in the air";
}

TEST_F(BodyCommandTest, leansAsPlannedAndResetForgets) {
  const JointArray upright = command();
  const Pose2 straight = body.torsoOnGround();
  const JointArray& leaning = command(false, 0, 0.2);
  EXPECT_LT(leaning[lHipPitch], upright[lHipPitch] - 0.15) << "the hips bend";
  EXPECT_GT((body.torsoOnGround().position - straight.position).norm(), 0.001);
  body.reset();
  EXPECT_NEAR(command()[lHipPitch], upright[lHipPitch], 1e-6);
}

TEST_F(BodyCommandTest, aFootOutOfReachComesAsNearAsItCan) {
  state.foot[0].position.x() = 5;
  for (const double angle : command()) EXPECT_TRUE(std::isfinite(angle));
}

}  // namespace
}  // namespace plumbline::walking
