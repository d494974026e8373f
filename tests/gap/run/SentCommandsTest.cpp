#include "gap/run/SentCommands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "PendulumRun.h"

namespace plumbline::gap {
namespace {

/// A run in which the pendulum swings and was sent these columns.
gap::Run wasSent(const std::vector<ChannelKind>& kinds) {
  gap::Run run = pendulumRun([](double t) { return 0.3 * std::sin(3 * t); },
                             [](double t) { return 0.3 * std::sin(3 * t - 0.1); });
  run.channels.erase("cmd.pendulum");
  for (const ChannelKind kind : kinds)
    for (const double t : run.t) run.channels[channelName(kind, "pendulum")].push_back(0.3 * std::sin(3 * t));
  return run;
}

TEST(SentCommandsTest, aDcMotorFollowsPositionsTorquesOrCurrents) {
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

TEST(SentCommandsTest, aPositionServoFollowsSpeedsAloneAndNoCurrentsWithoutItsConstant) {
  Mechanism robot = findMechanism("xl330_pendulum");
  robot.joints[0].servo = {};
  robot.joints[0].servo.kd = 0.2;
  std::vector<RunWarning> warnings;
  gap::Run run = wasSent({ChannelKind::commandSpeed, ChannelKind::commandCurrent});
  leaveOutUselessCommands(run, robot.joints[0], warnings);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].line("r"),
            "r: cmd_current.pendulum is left out: the robot's file gives no torque per ampere (servo.kt)");
  EXPECT_TRUE(isSentEfforts(run, robot.joints[0]));
  robot.joints[0].servo.kd = 0;
  leaveOutUselessCommands(run, robot.joints[0], warnings);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[1].line("r"),
            "r: cmd_vel.pendulum is left out: its servo has no damping (kd), so speeds do not drive it");
  EXPECT_FALSE(isSentEfforts(run, robot.joints[0]));
}

}  // namespace
}  // namespace plumbline::gap
