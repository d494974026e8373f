#include "robot/JointVelocityControl.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

constexpr double dt = 0.02;

/// A joint that moves with the speed answered to the message before.
struct DelayedJoints {
  JointArray angles{}, pending{};
  void act(const JointArray& speeds) {
    for (std::size_t j = 0; j < maxJoints; ++j) angles[j] += pending[j] * dt;
    pending = speeds;
  }
};

TEST(JointVelocityControl, reachesATargetInTheSecondMessageAndStaysThere) {
  const RobotModel robot = simsparkRobot(0);
  JointVelocityControl control(robot);
  DelayedJoints joints;
  JointArray targets{};
  targets[lKneePitch] = 0.1;
  joints.act(control.update(joints.angles, targets, dt));
  EXPECT_DOUBLE_EQ(joints.angles[lKneePitch], 0);
  for (int i = 0; i < 5; ++i) {
    joints.act(control.update(joints.angles, targets, dt));
    EXPECT_NEAR(joints.angles[lKneePitch], 0.1, 1e-12) << i;
  }
}

TEST(JointVelocityControl, followsARampOneCycleBehindTheCommand) {
  const RobotModel robot = simsparkRobot(0);
  JointVelocityControl control(robot);
  DelayedJoints joints;
  JointArray targets{};
  for (int i = 1; i <= 20; ++i) {
    const double before = targets[rHipPitch];
    targets[rHipPitch] = -0.05 * i;
    joints.act(control.update(joints.angles, targets, dt));
    EXPECT_NEAR(joints.angles[rHipPitch], before, 1e-12) << i;
  }
}

TEST(JointVelocityControl, keepsSpeedsAndStops) {
  const RobotModel robot = simsparkRobot(2);
  JointVelocityControl control(robot);
  JointArray targets{}, zero{};
  targets[lAnkleRoll] = 1;
  targets[headPitch] = -9;
  const JointArray speeds = control.update(zero, targets, dt);
  EXPECT_DOUBLE_EQ(speeds[lAnkleRoll], 3.47234);
  EXPECT_DOUBLE_EQ(speeds[headPitch], -fromDegrees(351.77));
  EXPECT_DOUBLE_EQ(speeds[lToePitch], 0) << "type 2 has no toe";
  JointArray nearStop{};
  nearStop[headPitch] = -0.785;
  control.reset();
  EXPECT_GT(control.update(nearStop, targets, dt)[headPitch], 0) << "keeps away from the stop at -45 degrees";
}

}  // namespace
}  // namespace plumbline
