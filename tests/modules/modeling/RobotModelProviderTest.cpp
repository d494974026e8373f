#include "modules/modeling/RobotModelProvider.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "robot/MechanismFile.h"
#include "support/ModuleHarness.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class RobotModelProviderTest : public testing::Test {
protected:
  test::ModuleHarness<RobotModelProvider> harness;
  PlayerInfo& player = harness.input<PlayerInfo>();
  JointData& joints = harness.input<JointData>();
  const RobotDescription& robot = harness.output<RobotDescription>();
  const FKModel& body = harness.output<FKModel>();
};

TEST_F(RobotModelProviderTest, findsTheRobotAndItsLinks) {
  player.robot = "simspark_type0";
  harness.cycle();
  EXPECT_TRUE(robot.known());
  EXPECT_EQ(robot.name, "simspark_type0");
  EXPECT_EQ(body.T_torso_link.size(), robot.model.links.size());
  EXPECT_GT(body.T_torso_head.translation().z(), 0.1);
  const Vec3 left = body.T_torso_leftSole.translation(), right = body.T_torso_rightSole.translation();
  EXPECT_NEAR(left.z(), right.z(), 1e-9);
  EXPECT_NEAR(left.y(), -right.y(), 1e-9);
  EXPECT_LT(left.z(), -0.3) << "with straight legs";
  EXPECT_NEAR(body.com.y(), 0, 1e-3);
}

TEST_F(RobotModelProviderTest, theLinksFollowTheMeasuredAngles) {
  player.robot = "simspark_type0";
  harness.cycle();
  const double straight = body.T_torso_leftSole.translation().z();
  const Vec3 right = body.T_torso_rightSole.translation();
  joints.angles[lKneePitch] = 1;
  harness.cycle();
  EXPECT_GT(body.T_torso_leftSole.translation().z(), straight + 0.02);
  EXPECT_EQ(body.T_torso_rightSole.translation(), right);
  joints.angles[headYaw] = pi / 2;
  harness.cycle();
  EXPECT_NEAR(body.T_torso_head.linear().col(0).y(), 1, 1e-9) << "it looks to the left";
}

TEST_F(RobotModelProviderTest, takesAnotherRobotWhenItsNameChanges) {
  player.robot = "simspark_type0";
  harness.cycle();
  const double before = body.T_torso_leftSole.translation().z();
  player.robot = "simspark_type1";
  harness.cycle();
  EXPECT_EQ(robot.name, "simspark_type1");
  EXPECT_LT(body.T_torso_leftSole.translation().z(), before - 0.01) << "its legs are longer";
}

TEST_F(RobotModelProviderTest, aNameThatIsNoRobotEndsTheAgent) {
  player.robot = "simspark_typ0";
  const std::string error = thrownBy([&] { harness.cycle(); });
  EXPECT_TRUE(error.starts_with("config/robots: no robot simspark_typ0; there are ")) << error;
  EXPECT_NE(error.find("simspark_type0, "), std::string::npos) << error;
}

TEST_F(RobotModelProviderTest, untilTheRobotIsNamedNothingIsKnown) {
  harness.cycle();
  EXPECT_FALSE(robot.known());
  EXPECT_TRUE(body.T_torso_link.empty());
}

}  // namespace
}  // namespace plumbline
