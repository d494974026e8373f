#include "modules/motion/PositionServoControl.h"

#include <gtest/gtest.h>

#include "ModuleUnderTest.h"
#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

struct Control : public PositionServoControl {
  using PositionServoControl::theFrameInfo;
  using PositionServoControl::theJointData;
  using PositionServoControl::theJointRequest;
  using PositionServoControl::theRobotDescription;
  using PositionServoControl::theTorsoAngles;
  using PositionServoControl::theWalkingEngineOutput;
};

class PositionServoControlTest : public testing::Test {
protected:
  PositionServoControlTest() : control("PositionServoControl", {"config", "config/robots/nao_v5"}) {
    control->theFrameInfo = &frame;
    control->theJointData = &joints;
    control->theRobotDescription = &robot;
    control->theTorsoAngles = &torso;
    control->theJointRequest = &request;
    control->theWalkingEngineOutput = &walk;
    frame.cycleSeconds = 0.01;
    robot.model = Humanoid(findMechanism("nao_v5")).model();
    robot.name = robot.model.name;
    joints.angles[lKneePitch] = 0.5;
  }

  ModuleUnderTest<Control> control;
  FrameInfo frame;
  JointData joints;
  RobotDescription robot;
  TorsoAngles torso;
  JointRequest request;
  WalkingEngineOutput walk;
  ServoRequest servos;
};

TEST_F(PositionServoControlTest, jointsWithoutARequestStayWhereTheyWereAtTheStart) {
  control->update(&servos);
  joints.angles[lKneePitch] = 0.9;
  control->update(&servos);
  EXPECT_NEAR(servos.angles[lKneePitch], 0.5, 0.05) << "but for the load";
  frame.restarted = true;
  control->update(&servos);
  EXPECT_NEAR(servos.angles[lKneePitch], 0.9, 0.05);
}

TEST_F(PositionServoControlTest, stiffnessGoesToTheServos) {
  request.targets.setTo(headYaw, 0.3);
  request.targets.stiffness[headYaw] = 0.4;
  control->update(&servos);
  EXPECT_EQ(servos.stiffness[headYaw], 0.4);
  EXPECT_EQ(servos.stiffness[rKneePitch], 1);
}

TEST_F(PositionServoControlTest, theFootThatCarriesMoreIsLedMore) {
  for (const JointId joint : {lKneePitch, rKneePitch}) request.targets.setTo(joint, 0.8);
  for (const JointId joint : {lHipPitch, rHipPitch, lAnklePitch, rAnklePitch})
    request.targets.setTo(joint, -0.4);
  walk.leftShare = 1;
  for (int i = 0; i < 10; ++i) control->update(&servos);
  EXPECT_GT(std::abs(servos.angles[lKneePitch] - 0.8), 3 * std::abs(servos.angles[rKneePitch] - 0.8));
}

TEST_F(PositionServoControlTest, withoutARobotNothingIsCommanded) {
  robot = RobotDescription();
  control->update(&servos);
  EXPECT_EQ(servos.angles, JointArray{});
}

}  // namespace
}  // namespace plumbline
