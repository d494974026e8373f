#include "robot/RobotModel.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "robot/ForwardKinematics.h"
#include "robot/LegKinematics.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

TEST(RobotModel, everyTypeHasTheLeaguesMass) {
  for (int type = 0; type < numSimsparkTypes(); ++type)
    EXPECT_NEAR(simsparkRobot(type).totalMass(), 4.6071, 1e-9) << type;
}

TEST(RobotModel, torsoHeightStandingStraight) {
  const double height[] = {0.385, 0.42164, 0.385, 0.440737, 0.385};
  for (int type = 0; type < numSimsparkTypes(); ++type)
    for (const Side side : {Side::left, Side::right}) {
      const RobotModel robot = simsparkRobot(type);
      const Pose3 sole = LegKinematics(robot, side).sole({});
      EXPECT_NEAR(sole.translation().z(), -height[type], 1e-6) << type;
    }
}

TEST(RobotModel, jointsOfTheTypes) {
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    const RobotModel robot = simsparkRobot(type);
    EXPECT_EQ(robot.links.size(), type == 4 ? 25u : 23u);
    for (int j = 0; j < numHumanoidJoints; ++j)
      EXPECT_EQ(robot.has(JointId(j)), type == 4 || (j != lToePitch && j != rToePitch)) << type << " " << j;
  }
}

TEST(RobotModel, signsAndLimitsAreTheNaos) {
  const RobotModel robot = simsparkRobot(2);
  const Link& knee = robot.linkMovedBy(lKneePitch);
  EXPECT_EQ(knee.name, "lShank");
  EXPECT_NEAR(knee.upper, fromDegrees(130), 1e-12);
  EXPECT_NEAR(robot.linkMovedBy(rHipPitch).lower, fromDegrees(-100), 1e-12);
  EXPECT_NEAR(robot.linkMovedBy(rAnklePitch).lower, fromDegrees(-75), 1e-12);
  EXPECT_NEAR(robot.linkMovedBy(lHipRoll).upper, fromDegrees(45), 1e-12);
  EXPECT_NEAR(robot.linkMovedBy(lShoulderRoll).upper, fromDegrees(95), 1e-12);
  EXPECT_NEAR(robot.linkMovedBy(rElbowRoll).upper, fromDegrees(90), 1e-12);
  EXPECT_DOUBLE_EQ(robot.linkMovedBy(rAnklePitch).maxSpeed, 8.80667);
  EXPECT_DOUBLE_EQ(robot.linkMovedBy(rAnkleRoll).maxSpeed, 3.47234);
}

TEST(RobotModel, bodiesStandWhereTheLeaguePutsThem) {
  // Sums of the league's centre-to-centre offsets, axes turned: right lower arm and left foot of type 0.
  const RobotModel robot = simsparkRobot(0);
  const ForwardKinematics fk(robot);
  const auto centre = [&](const char* name) {
    const int i = robot.linkIndex(name);
    return Vec3(fk.link(i) * robot.links[std::size_t(i)].com);
  };
  EXPECT_NEAR((centre("rLowerArm") - Vec3(0.14, -0.098, 0.084)).norm(), 0, 1e-12);
  EXPECT_NEAR((centre("lFoot") -
               Vec3(-0.01 + 0.01 + 0.005 - 0.01 + 0.03, 0.055, -0.115 - 0.04 - 0.125 - 0.055 - 0.04))
                  .norm(),
              0, 1e-12);
  EXPECT_NEAR((centre("head") - Vec3(0, 0, 0.155)).norm(), 0, 1e-12);
}

TEST(RobotModel, boxInertiaAndUnknownNames) {
  const RobotModel robot = simsparkRobot(0);
  EXPECT_NEAR(robot.links[0].inertia(2, 2), 1.2171 / 12 * (0.01 + 0.01), 1e-12);
  EXPECT_NEAR(robot.links[0].inertia(0, 0), 1.2171 / 12 * (0.01 + 0.0324), 1e-12);
  EXPECT_EQ(robot.linkIndex("tail"), -1);
  EXPECT_EQ(robot.joint("LKneePitch"), lKneePitch);
  EXPECT_EQ(robot.joint("LToePitch"), std::nullopt) << "type 0 has no toes";
  EXPECT_EQ(robot.jointName(lToePitch), "LToePitch");
  EXPECT_EQ(robot.jointName(static_cast<JointId>(30)), "?");
  EXPECT_EQ(robot.numJoints(), 22);
  EXPECT_EQ(robot.jointNames().back(), "RAnkleRoll");
  EXPECT_EQ(robot.joints().front(), headYaw);
  try {
    robot.requireJoint("LKneePich");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "robot simspark_type0 has no joint LKneePich; did you mean \"LKneePitch\"?");
  }
  EXPECT_EQ(humanoidJoint("LKneePitch"), lKneePitch);
  EXPECT_EQ(humanoidJoint("Tail"), noJoint);
}

}  // namespace
}  // namespace plumbline
