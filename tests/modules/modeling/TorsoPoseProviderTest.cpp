#include "modules/modeling/TorsoPoseProvider.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/ForwardKinematics.h"
#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

class TorsoPoseProviderTest : public testing::Test {
protected:
  TorsoPoseProviderTest() {
    robot.model = simsparkRobot(0);
    robot.name = robot.model.name;
    ForwardKinematics kinematics(robot.model);
    kinematics.update({});
    for (std::size_t i = 0; i < robot.model.links.size(); ++i)
      harness.input<FKModel>().T_torso_link.push_back(kinematics.link(static_cast<int>(i)));
    contact.contact = true;
    harness.input<FrameInfo>().cycleSeconds = 0.1;
  }
  double height() { return pose.T_ground_torso.translation().z(); }
  void lean(double roll, double pitch) {
    harness.input<TorsoAngles>().roll = roll;
    harness.input<TorsoAngles>().pitch = pitch;
    harness.input<UprightVec>().up = (rotationY(pitch) * rotationX(roll)).linear().row(2);
    harness.cycle();
  }
  test::ModuleHarness<TorsoPoseProvider> harness;
  RobotDescription& robot = harness.input<RobotDescription>();
  GroundContactState& contact = harness.input<GroundContactState>();
  const TorsoPose& pose = harness.output<TorsoPose>();
};

TEST_F(TorsoPoseProviderTest, theLowestPointOfTheFeetIsOnTheGround) {
  lean(0, 0);
  EXPECT_TRUE(pose.valid);
  const double straight = height();
  EXPECT_NEAR(straight, 0.385, 0.01);
  lean(0.1, 0.2);
  EXPECT_TRUE(pose.T_ground_torso.linear().isApprox((rotationY(0.2) * rotationX(0.1)).linear()));
  EXPECT_LT(std::abs(height() - straight), 0.03);
}

TEST_F(TorsoPoseProviderTest, aRobotThatLiesTouchesTheGroundWithItsBody) {
  lean(0, -1.5);
  EXPECT_FALSE(pose.valid);
  EXPECT_GT(height(), 0.03);
  EXPECT_LT(height(), 0.12);
}

TEST_F(TorsoPoseProviderTest, withoutLoadOnTheFeetItStandsForAMoment) {
  lean(0, 0);
  contact.contact = false;
  harness.cycle(2);
  EXPECT_TRUE(pose.valid);
  harness.cycle(2);
  EXPECT_FALSE(pose.valid) << "it hangs";
  contact.contact = true;
  harness.cycle();
  EXPECT_TRUE(pose.valid);
}

TEST_F(TorsoPoseProviderTest, aRobotThatIsNotKnownHasNoHeight) {
  robot.name.clear();
  lean(0, 0.2);
  EXPECT_FALSE(pose.valid);
  EXPECT_TRUE(pose.T_ground_torso.isApprox(Pose3::Identity()));
}

}  // namespace
}  // namespace plumbline
