#include "walking/estimation/ContactVelocity.h"

#include <gtest/gtest.h>

#include "simspark/LeagueRobots.h"

namespace plumbline::walking {
namespace {

/// A robot whose left hip swings its leg by a little from cycle to cycle.
class ContactVelocityTest : public testing::Test {
protected:
  static FootContact contact(double newtons) { return {Vec3::Zero(), Vec3(0, 0, newtons)}; }
  /// Where the middle of the foot is about the centre of mass for this pitch of the hip.
  Vec3 foot(double pitch, Side side = Side::left) {
    move(pitch);
    const int link = robot.linkIndex(side == Side::left ? "lFoot" : "rFoot");
    return kinematics.link(link) * robot.links[static_cast<std::size_t>(link)].com - kinematics.com();
  }
  void move(double pitch) {
    JointArray angles{};
    angles[lHipPitch] = pitch;
    kinematics.update(angles);
  }
  VelocityEvidence after(double pitch, double turn = 0) {
    move(pitch);
    return velocity.update(kinematics, Mat3::Identity(), turn, feet, dt);
  }
  static constexpr double dt = 0.02;
  RobotModel robot = simsparkRobot(0);
  ForwardKinematics kinematics{robot};
  ContactVelocity velocity{robot};
  FootSensors feet;
};

TEST_F(ContactVelocityTest, theMassMovesAgainstTheFootThatStands) {
  feet.foot[0] = contact(45);
  EXPECT_FALSE(after(0).seen) << "nothing before it";
  const Vec2 expected = (foot(0) - foot(0.05)).head<2>() / dt;
  const VelocityEvidence evidence = after(0.05);
  ASSERT_TRUE(evidence.seen);
  EXPECT_GT(expected.norm(), 0.1);
  EXPECT_NEAR((*evidence.seen - expected).norm(), 0, 1e-9);
}

TEST_F(ContactVelocityTest, feetCountByTheirLoadAndAPullIsNone) {
  feet.foot = {contact(30), contact(10)};
  after(0);
  const Vec2 left = (foot(0) - foot(0.05)).head<2>(),
             right = (foot(0, Side::right) - foot(0.05, Side::right)).head<2>();
  EXPECT_NEAR((*after(0.05).seen - (0.75 * left + 0.25 * right) / dt).norm(), 0, 1e-3);
  feet.foot = {contact(-5), {}};
  EXPECT_FALSE(after(0).seen);
}

TEST_F(ContactVelocityTest, theForcesAccelerateTheMass) {
  feet.foot[0] = FootContact{Vec3::Zero(), Vec3(9, -3, 45)};
  const VelocityEvidence evidence = after(0);
  ASSERT_TRUE(evidence.change);
  EXPECT_NEAR((*evidence.change - Vec2(9, -3) * dt / robot.totalMass()).norm(), 0, 1e-9);
  feet.shear = false;
  EXPECT_FALSE(after(0).change) << "only the force across the sole is measured";
}

TEST_F(ContactVelocityTest, aTurnInPlaceMovesNothingInTheMiddle) {
  feet.foot = {contact(20), contact(20)};
  after(0);
  // The feet stay on the ground; seen from the turned robot they went round it by 0.1 rad.
  const VelocityEvidence evidence = after(0, 0.1);
  ASSERT_TRUE(evidence.seen);
  const Vec2 middle = 0.5 * (foot(0) + foot(0, Side::right)).head<2>();
  EXPECT_NEAR((*evidence.seen - (Eigen::Rotation2Dd(-0.1) * middle - middle) / dt).norm(), 0, 1e-9);
}

TEST_F(ContactVelocityTest, inTheAirAndAfterAResetNothingIsSeen) {
  after(0);
  EXPECT_FALSE(after(0.05).seen);
  EXPECT_EQ(*after(0.05).change, Vec2(0, 0)) << "nothing pushes";
  feet.foot[0] = contact(45);
  after(0.05);
  velocity.reset();
  EXPECT_FALSE(after(0).seen);
}

}  // namespace
}  // namespace plumbline::walking
