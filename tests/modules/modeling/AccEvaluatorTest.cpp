#include "modules/modeling/AccEvaluator.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"
#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

/// A robot of which only the feet's links matter; the torso moves over a left foot that stands.
class AccEvaluatorTest : public testing::Test {
protected:
  AccEvaluatorTest() {
    robot.model = simsparkRobot(0);
    links.resize(robot.model.links.size(), Pose3::Identity());
    sensors.leftFoot.contact = true;
    sensors.leftFoot.force = Vec3(0, 0, 45);
    walk.odometry = Pose2(0.5, 0, 0.1);
  }
  /// A cycle in which the torso has come so far forward.
  const Pose2& at(double x) {
    links[static_cast<std::size_t>(robot.model.linkIndex("lFoot"))] = translation(-x, 0, -0.35);
    harness.cycle();
    return odometry.step;
  }
  test::ModuleHarness<AccEvaluator> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  SensorData& sensors = harness.input<SensorData>();
  RobotDescription& robot = harness.input<RobotDescription>();
  std::vector<Pose3>& links = harness.input<FKModel>().T_torso_link;
  TorsoAngles& angles = harness.input<TorsoAngles>();
  FallState& fall = harness.input<FallState>();
  WalkingEngineOutput& walk = harness.input<WalkingEngineOutput>();
  const Odometry& odometry = harness.output<Odometry>();
};

TEST_F(AccEvaluatorTest, theTorsoGoesOverTheFootThatCarries) {
  EXPECT_EQ(at(0).x(), 0);
  EXPECT_NEAR(at(0.01).x(), 0.01, 1e-12);
  EXPECT_NEAR(at(0.03).x(), 0.02, 1e-12);
  EXPECT_NEAR(odometry.total.x(), 0.03, 1e-12);
}

TEST_F(AccEvaluatorTest, aRobotWhoseFileNamesItsFeetInItsOwnWayMovesAsWell) {
  robot.model = Humanoid(findMechanism("nao_v5")).model();
  links.assign(robot.model.links.size(), Pose3::Identity());
  const auto foot = static_cast<std::size_t>(robot.model.linkIndex("l_ankle"));
  harness.cycle();
  links[foot] = translation(-0.01, 0, 0);
  harness.cycle();
  EXPECT_NEAR(odometry.step.x(), 0.01, 1e-12);
}

TEST_F(AccEvaluatorTest, theTurnIsTheGyroscopesFromTheSecondCycleOn) {
  angles.heading = 3.1;
  EXPECT_EQ(at(0).heading, 0) << "nothing is known before";
  angles.heading = -3.1;
  EXPECT_NEAR(at(0).heading, 2 * pi - 6.2, 1e-12) << "past half a turn";
}

TEST_F(AccEvaluatorTest, aFootWithoutContactShowsNothingAndALyingRobotStays) {
  at(0);
  sensors.leftFoot.contact = false;
  harness.module().airborneSeconds = 0;
  harness.module().parametersChanged();
  EXPECT_EQ(at(0.02).x(), 0);
  sensors.leftFoot.contact = true;
  fall.posture = Posture::onFront;
  EXPECT_EQ(at(0.04).x(), 0);
  fall.posture = Posture::upright;
  EXPECT_NEAR(at(0.06).x(), 0.02, 1e-12);
}

TEST_F(AccEvaluatorTest, theSourceMayBeTheWalkAsPlanned) {
  harness.module().source = "walkingEngine";
  at(0);
  EXPECT_EQ(at(0.01).x(), 0.5);
  EXPECT_EQ(odometry.step.heading, 0) << "but not its turn";
}

TEST_F(AccEvaluatorTest, aRestartBeginsAnew) {
  at(0);
  angles.heading = 1;
  frame.restarted = true;
  EXPECT_EQ(at(0.5).x(), 0);
  EXPECT_EQ(odometry.step.heading, 0);
}

}  // namespace
}  // namespace plumbline
