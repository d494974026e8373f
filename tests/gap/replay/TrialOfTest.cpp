#include "gap/replay/TrialOf.h"

#include <gtest/gtest.h>

#include "../run/PendulumRun.h"
#include "gap/run/RunFile.h"

namespace plumbline::gap {
namespace {

/// A pendulum without commands, but for a column of this kind.
Run drivenBy(ChannelKind kind, double value) {
  Run run = pendulumRun([](double) { return 0.0; }, [](double t) { return 0.1 * t; });
  run.channels.erase("cmd.pendulum");
  run.channels[channelName(kind, "pendulum")].assign(run.t.size(), value);
  return run;
}

Mechanism positionServo() {
  Mechanism robot = findMechanism("xl330_pendulum");
  robot.joints[0].servo = {};
  robot.joints[0].servo.kp = 3;
  robot.joints[0].servo.kd = 0.2;
  return robot;
}

TEST(TrialOfTest, aJointThatIsSentSpeedsAloneIsDampedToThem) {
  const Trial trial = trialOf(drivenBy(ChannelKind::commandSpeed, 1.5), positionServo());
  EXPECT_EQ(trial.commandSpeed[0][3], 1.5);
  EXPECT_TRUE(trial.commandTorque[0].empty());
  EXPECT_EQ(trial.robot->joints[0].servo.kp, 0);
  EXPECT_EQ(trial.robot->joints[0].servo.kd, 0.2);
  EXPECT_EQ(trial.signals.size(), 1U) << "its position counts";
}

TEST(TrialOfTest, aJointThatIsSentTorquesAloneHasNoServo) {
  const Trial trial = trialOf(drivenBy(ChannelKind::commandTorque, 0.7), positionServo());
  EXPECT_EQ(trial.commandTorque[0][3], 0.7);
  EXPECT_EQ(trial.robot->joints[0].servo.kp, 0);
  EXPECT_EQ(trial.robot->joints[0].servo.kd, 0);
  EXPECT_FALSE(trial.robot->joints[0].servo.followsTorque);
}

TEST(TrialOfTest, currentsAreTorquesOfTheMotor) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const Trial trial = trialOf(drivenBy(ChannelKind::commandCurrent, 0.5), pendulum);
  EXPECT_DOUBLE_EQ(trial.commandTorque[0][3], 0.5 * pendulum.joints[0].servo.kt);
  EXPECT_TRUE(trial.robot->joints[0].servo.followsTorque);
}

TEST(TrialOfTest, aDcMotorThatIsSentPositionsFollowsThem) {
  auto run = drivenBy(ChannelKind::commandCurrent, 0.5);
  run.channels["cmd.pendulum"].assign(run.t.size(), 0.2);
  const Trial trial = trialOf(run, findMechanism("xl330_pendulum"));
  EXPECT_TRUE(trial.commandTorque[0].empty());
  EXPECT_FALSE(trial.robot->joints[0].servo.followsTorque);
}

TEST(TrialOfTest, columnsWithoutAModelAreNamed) {
  auto run = drivenBy(ChannelKind::command, 0.2);
  run.channels["temperature.pendulum"].assign(run.t.size(), 40);
  run.channels["voltage.pendulum"].assign(run.t.size(), 7.1);
  EXPECT_EQ(trialOf(run, findMechanism("xl330_pendulum")).unused,
            std::vector<std::string>{"temperature.* is not used: no model here predicts it"});
  EXPECT_EQ(trialOf(run, positionServo()).unused.back(),
            "voltage.* is not used: the law of a position servo has no supply");
}

TEST(TrialOfTest, effortsAreReadAtATimeOfTheirOwn) {
  auto run = drivenBy(ChannelKind::command, 0.2);
  run.timing["*"].effortAt = 2e-3;
  EXPECT_EQ(trialOf(run, positionServo()).effortAt, std::vector<double>{2e-3});
}

}  // namespace
}  // namespace plumbline::gap
