#include "robot/LegKinematics.h"

#include <gtest/gtest.h>

#include <random>

#include "robot/ForwardKinematics.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

class LegKinematicsOfType : public testing::TestWithParam<int> {};

TEST_P(LegKinematicsOfType, roundTripOverTheJointSpace) {
  const RobotModel robot = simsparkRobot(GetParam());
  ForwardKinematics fk(robot);
  std::mt19937 random(7);
  for (const Side side : {Side::left, Side::right}) {
    const LegKinematics leg(robot, side);
    const int first = firstLegJoint(side);
    const int foot = robot.linkOfJoint[std::size_t(first + 5)];
    for (int n = 0; n < 5000; ++n) {
      JointArray angles{};
      for (int i = 0; i < 6; ++i) {
        const Link& link = robot.linkMovedBy(JointId(first + i));
        angles[std::size_t(first + i)] = std::uniform_real_distribution(link.lower, link.upper)(random);
      }
      fk.update(angles);
      const Pose3 sole = fk.link(foot) * leg.T_foot_sole();
      const LegSolution solution = leg.solve(sole);
      const Pose3 reached = leg.sole(solution.angles);
      ASSERT_TRUE(solution.reachable) << n;
      ASSERT_LT((reached.matrix() - sole.matrix()).norm(), 1e-10) << n;
      for (int i = 0; i < 6; ++i)
        ASSERT_NEAR(solution.angles[std::size_t(i)], angles[std::size_t(first + i)], 1e-7) << n << " " << i;
    }
  }
}

TEST_P(LegKinematicsOfType, tooFarIsReachedAsNearAsTheLegIsLong) {
  const RobotModel robot = simsparkRobot(GetParam());
  const LegKinematics leg(robot, Side::left);
  const Pose3 straight = leg.sole({});
  const LegSolution far = leg.solve(translation(0, 0, -0.1) * straight);
  EXPECT_FALSE(far.reachable);
  EXPECT_NEAR(far.angles[3], robot.linkMovedBy(lKneePitch).lower, 1e-9);
  const Pose3 reached = leg.sole(far.angles);
  EXPECT_NEAR((reached.linear() - straight.linear()).norm(), 0, 1e-9) << "the foot keeps its direction";
  EXPECT_LT(reached.translation().z(), straight.translation().z() + 1e-9);
  EXPECT_GT(reached.translation().z(), straight.translation().z() - 0.001);
}

TEST_P(LegKinematicsOfType, jointLimitsAreKept) {
  const RobotModel robot = simsparkRobot(GetParam());
  const LegKinematics leg(robot, Side::right);
  // The hip yaw pitch turns the toes outward only.
  const Pose3 inward = translation(0, 0, 0.02) * leg.sole({}) * rotationZ(0.3);
  const LegSolution solution = leg.solve(inward);
  EXPECT_FALSE(solution.reachable);
  EXPECT_NEAR(solution.angles[0], robot.linkMovedBy(rHipYawPitch).upper, 1e-12);
  const LegSolution outward = leg.solve(translation(0, 0, 0.02) * leg.sole({}) * rotationZ(-0.3));
  EXPECT_TRUE(outward.reachable);
}

INSTANTIATE_TEST_SUITE_P(SimSpark, LegKinematicsOfType, testing::Range(0, numSimsparkTypes()));

TEST(LegKinematics, soleOfFootAndToe) {
  const RobotModel plain = simsparkRobot(0), toed = simsparkRobot(4);
  const LegKinematics a(plain, Side::left), b(toed, Side::left);
  EXPECT_NEAR(a.soleHalfSize().x(), 0.08, 1e-9);
  EXPECT_NEAR(b.soleHalfSize().x(), 0.08, 1e-6);
  EXPECT_NEAR((a.sole({}).translation() - b.sole({}).translation()).norm(), 0, 1e-6);
}

TEST(LegKinematics, theRobotsGeometryDecidesHowALegIsSolved) {
  RobotModel robot = simsparkRobot(0);
  EXPECT_TRUE(LegKinematics(robot, Side::left).closedForm());
  robot.links[std::size_t(robot.linkOfJoint[lHipPitch])].origin.z() = -0.01;
  const LegKinematics apart(robot, Side::left);
  EXPECT_FALSE(apart.closedForm()) << "the hip's axes do not meet";
  const Pose3 wanted = apart.sole({-0.3, 0.1, -0.5, 0.9, -0.4, 0.05});
  EXPECT_LT((apart.sole(apart.solve(wanted).angles).matrix() - wanted.matrix()).norm(), 1e-8);
}

TEST(LegKinematics, aSharedHipMotorOverAnAnkleWhoseAxesDoNotMeetIsSolvedByIteration) {
  RobotModel robot = simsparkRobot(0);
  robot.links[std::size_t(robot.linkOfJoint[lAnkleRoll])].origin.z() = -0.01;
  EXPECT_TRUE(LegKinematics(robot, Side::left).closedForm());
  robot.sharedHipYawPitch = true;
  EXPECT_FALSE(LegKinematics(robot, Side::left).closedForm());
}

TEST(LegKinematics, refusesALegWithFewerJoints) {
  RobotModel robot = simsparkRobot(0);
  robot.linkOfJoint[lKneePitch] = -1;
  EXPECT_THROW(LegKinematics(robot, Side::left), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline
