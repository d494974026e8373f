#include "gap/run/CommandCheck.h"

#include <gtest/gtest.h>

#include "../OneJoint.h"

namespace plumbline::gap {
namespace {

/// What is said of a joint with that damping and no position gain, if a run has these columns.
std::string saidOfTorqueJoint(const std::vector<std::string>& columns, double kd = 0,
                              const ServoOverride& given = {}) {
  Mechanism robot = oneJoint();
  robot.joints[0].servo.kp = 0;
  robot.joints[0].servo.kd = kd;
  Run run;
  run.folder = "r";
  run.servo["joint"] = given;
  for (const std::string& column : columns) run.channels[column] = {0, 0};
  try {
    checkCommands(run, robot);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

const std::string noGain = "r: joint joint has no position gain in the file of one_joint, ";

TEST(CommandCheck, aJointThatTakesTorquesNeedsThem) {
  EXPECT_EQ(saidOfTorqueJoint({"cmd_torque.joint", "pos.joint"}), "");
  EXPECT_EQ(saidOfTorqueJoint({"pos.joint"}),
            noGain + "and there is no cmd_torque.joint; record it, 0 while the motor is off");
  EXPECT_EQ(saidOfTorqueJoint({"cmd_vel.joint", "pos.joint"}),
            noGain + "and there is no cmd_torque.joint; record it, 0 while the motor is off");
}

TEST(CommandCheck, whereItHasDampingSpeedsDriveItToo) {
  EXPECT_EQ(saidOfTorqueJoint({"cmd_vel.joint", "pos.joint"}, 0.4), "");
  EXPECT_EQ(
      saidOfTorqueJoint({"pos.joint"}, 0.4),
      noGain + "and there is no cmd_torque.joint or cmd_vel.joint; record it, 0 while the motor is off");
}

TEST(CommandCheck, positionsNeedTheGainsOfTheirController) {
  const std::vector<std::string> columns = {"cmd.joint", "cmd_torque.joint", "pos.joint"};
  EXPECT_EQ(saidOfTorqueJoint(columns),
            noGain +
                "but cmd.joint was sent; give kp and kd of its controller under servo in run.json, or "
                "record cmd_torque.joint instead");
  ServoOverride controller;
  controller.kp = 30;
  EXPECT_EQ(saidOfTorqueJoint(columns, 0, controller), "");
}

TEST(CommandCheck, aServoWithAGainNeedsNothing) {
  gap::Run run;
  run.channels["pos.joint"] = {0, 0};
  EXPECT_NO_THROW(checkCommands(run, oneJoint()));
}

}  // namespace
}  // namespace plumbline::gap
