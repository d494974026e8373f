#include "gap/run/CommandCheck.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../OneJoint.h"
#include "PendulumRun.h"

namespace plumbline::gap {
namespace {

/// What is said of a joint with that damping and no position gain, if a run has these columns.
std::string saidOfTorqueJoint(const std::vector<std::string>& columns, double kd = 0,
                              const ServoOverride& given = {}) {
  Mechanism robot = oneJoint();
  robot.joints[0].servo.kp = 0;
  robot.joints[0].servo.kd = kd;
  gap::Run run;
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

/// A run in which the pendulum swings and was sent these columns.
gap::Run wasSent(const std::vector<ChannelKind>& kinds) {
  gap::Run run = pendulumRun([](double t) { return 0.3 * std::sin(3 * t); },
                             [](double t) { return 0.3 * std::sin(3 * t - 0.1); });
  run.channels.erase("cmd.pendulum");
  for (const ChannelKind kind : kinds)
    for (const double t : run.t) run.channels[channelName(kind, "pendulum")].push_back(0.3 * std::sin(3 * t));
  return run;
}

TEST(CommandCheck, aDcMotorFollowsPositionsTorquesOrCurrents) {
  EXPECT_EQ(saidOf(wasSent({ChannelKind::commandTorque})), "");
  EXPECT_EQ(saidOf(wasSent({ChannelKind::commandCurrent})), "");
  EXPECT_EQ(
      saidOf(wasSent({ChannelKind::command, ChannelKind::commandCurrent})),
      "r: cmd_current.pendulum is left out: a DC motor that is sent positions has no use for it; without "
      "cmd.pendulum it follows torques or currents\n");
  EXPECT_EQ(saidOf(wasSent({ChannelKind::commandTorque, ChannelKind::commandCurrent})),
            "r: cmd_current.pendulum is left out: cmd_torque.pendulum is used\n");
  EXPECT_EQ(saidOf(wasSent({ChannelKind::commandSpeed})),
            "refused: r: no usable cmd column is left (cmd_vel.pendulum: a DC motor's law has none)");
}

TEST(CommandCheck, aPositionServoFollowsSpeedsAloneAndNoCurrentsWithoutItsConstant) {
  Mechanism robot = findMechanism("xl330_pendulum");
  robot.joints[0].servo = {};
  robot.joints[0].servo.kd = 0.2;
  std::vector<RunWarning> warnings;
  gap::Run run = wasSent({ChannelKind::commandSpeed, ChannelKind::commandCurrent});
  leaveOutUselessCommands(run, robot.joints[0], warnings);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].line("r"),
            "r: cmd_current.pendulum is left out: the robot's file gives no torque per ampere (servo.kt)");
  EXPECT_TRUE(wasSentSpeedOrTorque(run, "pendulum"));
  robot.joints[0].servo.kd = 0;
  leaveOutUselessCommands(run, robot.joints[0], warnings);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[1].line("r"),
            "r: cmd_vel.pendulum is left out: its servo has no damping (kd), so speeds do not drive it");
  EXPECT_FALSE(wasSentSpeedOrTorque(run, "pendulum"));
}

}  // namespace
}  // namespace plumbline::gap
