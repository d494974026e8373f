#include "robot/ForwardKinematics.h"

#include <gtest/gtest.h>

#include "math/Random.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

TEST(ForwardKinematics, kneeAndShoulderTurnTheRightWay) {
  const RobotModel robot = simsparkRobot(0);
  ForwardKinematics fk(robot);
  JointArray angles{};
  angles[lKneePitch] = 1;
  angles[rShoulderPitch] = 1.5;
  fk.update(angles);
  const Vec3 foot = fk.link(robot.linkIndex("lFoot")).translation();
  EXPECT_NEAR(foot.x(), -0.005 - 0.105 * std::sin(1.0), 1e-3) << "a bent knee draws the foot back";
  const Vec3 hand = fk.link(robot.linkIndex("rLowerArm")).translation();
  EXPECT_LT(hand.z(), 0) << "a positive shoulder pitch lowers the arm";
}

TEST(ForwardKinematics, comIsTheMeanOfTheLinks) {
  const RobotModel robot = simsparkRobot(3);
  ForwardKinematics fk(robot);
  JointArray angles{};
  for (std::size_t j = 0; j < maxJoints; ++j) angles[j] = 0.05 * double(j) - 0.4;
  fk.update(angles);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    sum += robot.links[i].mass * (fk.link(int(i)) * robot.links[i].com);
  EXPECT_NEAR((fk.com() - sum / 4.6071).norm(), 0, 1e-12);
}

TEST(ForwardKinematics, standingComOfTypeZero) {
  const RobotModel robot = simsparkRobot(0);
  const ForwardKinematics fk(robot);
  EXPECT_NEAR(fk.com().y(), 0, 1e-12);
  EXPECT_NEAR(fk.com().x(), 0.0169, 2e-3);
}

/// What has moved is worked out, whatever was there before, and to the bit.
TEST(ForwardKinematics, isTheSameAfterOtherAngles) {
  const RobotModel robot = simsparkRobot(4);
  ForwardKinematics used(robot);
  Random random(5);
  JointArray angles{};
  for (int i = 0; i < 200; ++i) {
    for (int changes = i % 4; changes > 0; --changes)
      angles[static_cast<std::size_t>(random.uniform(0, maxJoints))] = random.uniform(-1, 1);
    if (i == 100) angles.fill(-0.0);
    used.update(angles);
    ForwardKinematics fresh(robot);
    fresh.update(angles);
    for (int link = 0; link < static_cast<int>(robot.links.size()); ++link)
      ASSERT_TRUE(used.link(link).matrix() == fresh.link(link).matrix()) << link;
    ASSERT_TRUE(used.com() == fresh.com());
  }
}

TEST(ForwardKinematics, refusesTooManyLinks) {
  RobotModel robot = simsparkRobot(0);
  robot.links.resize(ForwardKinematics::maxLinks + 1);
  EXPECT_THROW(ForwardKinematics{robot}, std::invalid_argument);
}

}  // namespace
}  // namespace plumbline
