#include "walking/engine/LegLoad.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/ForwardKinematics.h"
#include "robot/LegKinematics.h"
#include "simspark/LeagueRobots.h"
#include "walking/StandingAngles.h"

namespace plumbline::walking {
namespace {

/// A robot that stands with bent knees; statics by hand.
class LegLoadTest : public testing::Test {
protected:
  RobotModel robot = simsparkRobot(0);
  LegLoad load{robot};
  const JointArray standing = standingAngles(robot, 0.22);
  const double weight = robot.totalMass() * 9.81;
};

TEST_F(LegLoadTest, bothLegsShareTheWeight) {
  const JointArray& torque = load.update(standing, Vec2::Zero(), {0.5, 0.5}, Vec2::Zero());
  for (const int i : {2, 3, 4})
    EXPECT_NEAR(torque[static_cast<std::size_t>(lHipYawPitch + i)],
                torque[static_cast<std::size_t>(rHipYawPitch + i)], 1e-6);
  EXPECT_NEAR(torque[lHipRoll], -torque[rHipRoll], 1e-6);
  // The thigh leans back: the knee is before the line of the force, by its sine.
  EXPECT_GT(std::abs(torque[lKneePitch]), 0.5);
}

TEST_F(LegLoadTest, theLegThatCarriesAloneHasTwiceTheLoadAndTheOtherHangs) {
  const double half = load.update(standing, Vec2::Zero(), {0.5, 0.5}, Vec2::Zero())[lKneePitch];
  const JointArray& torque = load.update(standing, Vec2::Zero(), {1, 0}, Vec2::Zero());
  EXPECT_GT(torque[lKneePitch] / half, 1.7);
  EXPECT_LT(torque[rKneePitch] * half, 0) << "it holds the shank up";
  EXPECT_LT(std::abs(torque[rKneePitch]), 0.3);
}

TEST_F(LegLoadTest, thePointOfPressureMovesTheAnklesTorque) {
  const double middle = load.update(standing, Vec2::Zero(), {0.5, 0.5}, Vec2::Zero())[lAnklePitch];
  const double forward = load.update(standing, Vec2::Zero(), {0.5, 0.5}, Vec2(0.02, 0))[lAnklePitch];
  // 2 cm under half of the weight; the force leans back to the mass and takes some of it off.
  EXPECT_NEAR(std::abs(forward - middle), 0.02 * 0.5 * weight, 0.25 * 0.02 * 0.5 * weight);
}

TEST_F(LegLoadTest, armsAreHeldAgainstGravity) {
  JointArray ahead = standing;
  ahead[lShoulderPitch] = 0;
  ahead[rShoulderPitch] = pi / 2;
  const JointArray& torque = load.update(ahead, Vec2::Zero(), {0.5, 0.5}, Vec2::Zero());
  EXPECT_GT(std::abs(torque[lShoulderPitch]), 0.1) << "stretched out ahead";
  EXPECT_LT(std::abs(torque[rShoulderPitch]), 0.1 * std::abs(torque[lShoulderPitch])) << "it hangs down";
  EXPECT_NEAR(torque[headYaw], 0, 1e-9);
}

TEST_F(LegLoadTest, aShoulderHoldsTheWeightOfItsArmTimesHowFarItReaches) {
  JointArray ahead = standing;
  ahead[lShoulderPitch] = 0;
  ForwardKinematics kinematics(robot);
  kinematics.update(ahead);
  const int shoulder = robot.linkOfJoint[lShoulderPitch];
  const Vec3 joint = kinematics.link(shoulder).translation();
  double moment = 0;
  for (int i = 0; i < static_cast<int>(robot.links.size()); ++i) {
    int above = i;
    while (above > 0 && above != shoulder) above = robot.links[static_cast<std::size_t>(above)].parent;
    const Link& link = robot.links[static_cast<std::size_t>(i)];
    if (above == shoulder) moment += link.mass * 9.81 * (kinematics.link(i) * link.com - joint).x();
  }
  EXPECT_NEAR(std::abs(load.update(ahead, Vec2::Zero(), {0.5, 0.5}, Vec2::Zero())[lShoulderPitch]), moment,
              1e-3 * moment);
}

// A robot that falls lies when its mass is some 5 cm above its soles: before that its legs carry it.
TEST_F(LegLoadTest, aRobotThatFallsIsCarriedUntilItLies) {
  ForwardKinematics kinematics(robot);
  kinematics.update(standing);
  const LegKinematics leg(robot, Side::left);
  const Vec3 sole = kinematics.link(robot.linkOfJoint[lAnkleRoll]) * leg.T_foot_sole().translation();
  const Vec3 toMass = kinematics.com() - sole;
  // The lean about y at which the mass is so high above the left sole.
  const auto kneeAt = [&](double height) {
    double lean = 0;
    while (lean < pi && (rotationY(lean).linear() * toMass).z() > height) lean += 1e-4;
    return load.update(standing, Vec2(0, lean), {1, 0}, Vec2::Zero())[lKneePitch];
  };
  EXPECT_GT(std::abs(kneeAt(0.06)), 5 * std::abs(kneeAt(0.04)));
}

TEST_F(LegLoadTest, aMassThatIsNotAboveItsFeetIsNotPushed) {
  // Head down the soles are above the mass: nothing pushes, what hangs is still held.
  const JointArray& torque = load.update(standing, Vec2(pi, 0), {0.5, 0.5}, Vec2::Zero());
  for (const double value : torque) EXPECT_TRUE(std::isfinite(value));
  EXPECT_LT(std::abs(torque[lKneePitch]), 0.5);
}

}  // namespace
}  // namespace plumbline::walking
