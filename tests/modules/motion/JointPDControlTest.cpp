#include "modules/motion/JointPDControl.h"

#include <gtest/gtest.h>

#include "ModuleUnderTest.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/LocalRobot.h"

namespace plumbline {
namespace {

struct Control : public JointPDControl {
  using JointPDControl::theFrameInfo;
  using JointPDControl::theJointData;
  using JointPDControl::theJointRequest;
  using JointPDControl::theRobotDescription;
};

class JointPDControlTest : public testing::TestWithParam<int> {
protected:
  JointPDControlTest() : control("JointPDControl"), robot(simsparkRobot(GetParam())) {
    control->theFrameInfo = &frame;
    control->theRobotDescription = &description;
    control->theJointData = &joints;
    control->theJointRequest = &request;
    description.model = simsparkRobot(GetParam());
    description.name = description.model.name;
    robot.restart(Pose3(translation(0, 0, 20)), JointArray{});
  }
  void cycle() {
    joints.angles = robot.sense().angle;
    control->update(&speeds);
    robot.act(speeds.speeds);
  }

  ModuleUnderTest<Control> control;
  simulation::LocalRobot robot;
  FrameInfo frame;
  RobotDescription description;
  JointData joints;
  JointRequest request;
  JointRequestWithSpeeds speeds;
};

TEST_P(JointPDControlTest, aNearTargetIsReachedInTwoCycles) {
  request.targets.setTo(lKneePitch, 0.1);
  request.targets.setTo(rHipPitch, -0.08);
  cycle();
  EXPECT_NEAR(robot.sense().angle[lKneePitch], 0, 1e-4) << "the delay";
  cycle();
  EXPECT_NEAR(robot.sense().angle[lKneePitch], 0.1, 1e-3);
  EXPECT_NEAR(robot.sense().angle[rHipPitch], -0.08, 1e-3);
  cycle();
  EXPECT_NEAR(robot.sense().angle[lKneePitch], 0.1, 1e-3) << "and not overshot";
}

TEST_P(JointPDControlTest, targetsBeyondTheStopsDoNotBounce) {
  request.targets.setTo(lKneePitch, 3.0);
  request.targets.setTo(rShoulderPitch, 3.0);
  const Link& knee = description.model.linkMovedBy(lKneePitch);
  double highest = 0;
  for (int i = 0; i < 40; ++i) {
    cycle();
    highest = std::max(highest, robot.sense().angle[lKneePitch]);
  }
  EXPECT_LT(highest, knee.upper);
  EXPECT_NEAR(robot.sense().angle[lKneePitch], knee.upper - 0.01, 2e-3);
}

TEST_P(JointPDControlTest, jointsWithoutARequestStay) {
  request.targets.setTo(lKneePitch, 0.5);
  for (int i = 0; i < 10; ++i) cycle();
  EXPECT_NEAR(robot.sense().angle[rKneePitch], 0, 1e-3);
  EXPECT_NEAR(robot.sense().angle[lShoulderPitch], 0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(AllTypes, JointPDControlTest, testing::Range(0, numSimsparkTypes()));

}  // namespace
}  // namespace plumbline
