#include "walking/engine/BodyPosture.h"

#include <gtest/gtest.h>

#include "simspark/LeagueRobots.h"

namespace plumbline::walking {
namespace {

class BodyPostureOfType : public testing::TestWithParam<int> {};

TEST_P(BodyPostureOfType, putsTheCentreOfMassOverTheOriginAndTheFeetWhereTheyBelong) {
  const RobotModel robot = simsparkRobot(GetParam());
  BodyPosture posture(robot);
  JointArray angles{};
  angles[lShoulderPitch] = 1.2;
  angles[headYaw] = 0.5;
  std::array<FootPlacement, 2> feet;
  feet[0].ground = Pose2(0.03, 0.06, 0.1);
  feet[1] = {.ground = Pose2(-0.04, -0.07, -0.2), .height = 0.02, .pitch = 0.05, .roll = 0.02};
  const double hipHeight =
      0.85 * (posture.leg(Side::left).maxReach() + posture.leg(Side::left).ankleHeight());
  // Every call begins at the result of the last, as in consecutive cycles.
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(posture.solve(feet, {.hipHeight = hipHeight, .roll = 0.05, .pitch = 0.1}, angles));

  ForwardKinematics fk(robot);
  fk.update(angles);
  const Vec3 com = posture.torso() * fk.com();
  EXPECT_NEAR(com.head<2>().norm(), 0, 2e-5);
  const auto sole = [&](Side side) {
    const int foot = robot.linkOfJoint[static_cast<std::size_t>(firstLegJoint(side) + 5)];
    return Pose3(posture.torso() * fk.link(foot) * posture.leg(side).T_foot_sole());
  };
  const Pose3 left = sole(Side::left), right = sole(Side::right);
  EXPECT_NEAR((left.translation() - Vec3(0.03, 0.06, 0)).norm(), 0, 1e-4);
  EXPECT_NEAR((right.translation() - Vec3(-0.04, -0.07, 0.02)).norm(), 0, 1e-4);
  EXPECT_NEAR((left.linear() - rotationZ(0.1).linear()).norm(), 0, 1e-6);
  EXPECT_NEAR((right.linear() - (rotationZ(-0.2) * rotationY(0.05) * rotationX(0.02)).linear()).norm(), 0,
              1e-6);
  const Vec3 hips = posture.torso() * ((posture.leg(Side::left).hip() + posture.leg(Side::right).hip()) / 2);
  EXPECT_NEAR(hips.z(), hipHeight, 1e-9);
}

TEST_P(BodyPostureOfType, tellsWhenALegIsTooShort) {
  BodyPosture posture(simsparkRobot(GetParam()));
  JointArray angles{};
  std::array<FootPlacement, 2> feet;
  feet[0].ground = Pose2(0, 0.06);
  feet[1].ground = Pose2(0.3, -0.06);
  EXPECT_FALSE(posture.solve(feet, {.hipHeight = 0.25}, angles));
}

INSTANTIATE_TEST_SUITE_P(SimSpark, BodyPostureOfType, testing::Range(0, numSimsparkTypes()));

}  // namespace
}  // namespace plumbline::walking
