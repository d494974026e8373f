#include "gap/replay/TrialOf.h"

#include <gtest/gtest.h>

#include "../OneJoint.h"
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

/// A run of one joint over two seconds.
gap::Run runWith(const std::string& column, const std::function<double(double)>& sent) {
  gap::Run run;
  run.folder = "r";
  run.robot = "one_joint";
  for (int k = 0; k < 200; ++k) {
    run.t.push_back(0.01 * k);
    run.channels[column].push_back(sent(run.t.back()));
    run.channels["pos.joint"].push_back(0);
  }
  return run;
}

std::vector<double> replayed(const Mechanism& robot, const gap::Run& run) {
  const Trial trial = trialOf(run, robot);
  return replay(nominalPlant(*trial.robot), trial).values.at(0);
}

TEST(TrialOfTest, aJointWithoutAPositionGainIsDrivenBySpeedsAlone) {
  Mechanism robot = oneJoint();
  robot.joints[0].servo.kp = 0;
  const std::vector<double> positions = replayed(robot, runWith("cmd_vel.joint", [](double) { return 1.5; }));
  const double rate = (positions[190] - positions[90]) / 1;
  EXPECT_NEAR(rate, 1.5, 0.01) << "as soon as it has reached its speed";
}

TEST(TrialOfTest, theFrictionOfTheRobotsFileHoldsAJointThatTakesTorques) {
  const auto moved = [](double friction, double damping) {
    Mechanism robot = oneJoint();
    robot.joints[0].servo.kp = 0;
    robot.joints[0].servo.kd = 0;
    robot.joints[0].friction = friction;
    robot.joints[0].damping = damping;
    const std::vector<double> positions =
        replayed(robot, runWith("cmd_torque.joint", [](double) { return 0.1; }));
    return positions[199];
  };
  // 0.1 N m on 0.02 kg m^2 over two seconds.
  EXPECT_NEAR(moved(0, 0), 0.5 * 5 * 1.99 * 1.99, 0.1);
  EXPECT_NEAR(moved(0.05, 0), 0.5 * 2.5 * 1.99 * 1.99, 0.1);
  EXPECT_NEAR(moved(0.15, 0), 0, 1e-3);
  EXPECT_LT(moved(0, 0.1), 2) << "at most 1 rad/s";
}

TEST(TrialOfTest, anEffectAddsToTheFrictionOfTheRobotsFile) {
  Mechanism robot = oneJoint();
  robot.joints[0].friction = 0.05;
  EXPECT_DOUBLE_EQ(nominalPlant(robot).joints[0].coulomb, 0.05);
  EXPECT_DOUBLE_EQ(plantWith(robot, "coulomb_friction", "joint", 0.02).joints[0].coulomb, 0.07);
  robot.joints[0].damping = 0.3;
  EXPECT_DOUBLE_EQ(plantWith(robot, "viscous_friction", "joint", 0.1).joints[0].viscous, 0.4);
}

}  // namespace
}  // namespace plumbline::gap
