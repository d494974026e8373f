#include "gap/replay/CommandPath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

struct CommandPathTest : testing::Test {
  CommandPathTest() {
    trial.robot = std::make_shared<Mechanism>(arm);
    for (int k = 0; k < 10; ++k) trial.time.push_back(0.01 * k);
    trial.command.assign(2, std::vector<double>(10, 0.0));
    for (std::size_t k = 5; k < 10; ++k) trial.command[0][k] = 1;
    trial.stiffness.resize(2);
    trial.voltage.resize(2);
    trial.commandAt.assign(2, 0);
    trial.positionAt = trial.velocityAt = trial.commandAt;
  }
  Mechanism arm = twoJointArm();
  Trial trial;
  JointPlant plant;
};

TEST_F(CommandPathTest, aChangeWithinAStepCountsByItsShare) {
  CommandPath path(plant, trial, 0, nullptr);
  EXPECT_DOUBLE_EQ(path.over(0, 0.04), 0);
  EXPECT_NEAR(path.over(0.04, 0.06), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(path.over(0.06, 0.07), 1);
}

TEST_F(CommandPathTest, atTheEndOfAStepTheLastCommandIsInForceWhateverTheStep) {
  for (const double step : {0.02, 0.001}) {
    CommandPath path(plant, trial, 0, nullptr);
    path.over(0.04, 0.0505 - step);
    path.over(0.0505 - step, 0.0505);
    EXPECT_EQ(path.atEnd(), 1);
  }
}

TEST_F(CommandPathTest, atTheEndOfAStepAStraightLineIsWhereItHasCome) {
  trial.linearCommands = true;
  CommandPath path(plant, trial, 0, nullptr);
  path.over(0, 0.0425);
  EXPECT_NEAR(path.atEnd(), 0.25, 1e-12);
}

TEST_F(CommandPathTest, atTheEndOfAStepAProfileIsWhereItHasCome) {
  plant.profileSpeed = 20;  // [rad/s]
  CommandPath path(plant, trial, 0, nullptr);
  path.over(0, 0.05);
  path.over(0.05, 0.06);
  EXPECT_NEAR(path.atEnd(), 0.2, 1e-9);
}

TEST_F(CommandPathTest, aDelayShiftsIt) {
  plant.commandDelay = 0.0075;
  CommandPath path(plant, trial, 0, nullptr);
  EXPECT_NEAR(path.over(0.05, 0.06), 0.25, 1e-9);
}

TEST_F(CommandPathTest, ofCommandsThatAreLostByChanceTheMeanActs) {
  // With a fifth lost, 80 % of the robots have the step's first command, 96 % the first or the second.
  CommandPath path(plant, trial, 0, nullptr, 0.2);
  EXPECT_DOUBLE_EQ(path.over(0.04, 0.05), 0);
  EXPECT_NEAR(path.over(0.05, 0.06), 0.8, 1e-12);
  EXPECT_NEAR(path.over(0.06, 0.07), 0.96, 1e-12);
  const std::vector<std::uint8_t> none(10, 0);
  CommandPath known(plant, trial, 0, &none, 0.2);
  EXPECT_DOUBLE_EQ(known.over(0.05, 0.06), 1);
}

TEST_F(CommandPathTest, lostCyclesAndLostSamplesHoldTheLastCommand) {
  std::vector<std::uint8_t> lost(10, 0);
  lost[5] = 1;
  trial.command[0][6] = std::numeric_limits<double>::quiet_NaN();
  CommandPath path(plant, trial, 0, &lost);
  EXPECT_DOUBLE_EQ(path.over(0.04, 0.069), 0);
  EXPECT_DOUBLE_EQ(path.over(0.071, 0.08), 1);
}

TEST_F(CommandPathTest, aJointWithoutCommandsFollowsAndLosesNothing) {
  trial.followed = {trial.command[0], {}};
  trial.command[0].clear();
  const std::vector<std::uint8_t> lost(10, 1);
  CommandPath path(plant, trial, 0, &lost);
  EXPECT_DOUBLE_EQ(path.over(0, 0.04), 0);
  EXPECT_DOUBLE_EQ(path.over(0.06, 0.07), 1);
}

TEST_F(CommandPathTest, anAccelerationLimitTakesItsTime) {
  plant.accelerationLimit = 100;  // 1 rad: speeds up for 0.1 s and slows down for 0.1 s
  for (int k = 10; k < 100; ++k) trial.time.push_back(0.01 * k);
  trial.command[0].resize(100, 1.0);
  CommandPath path(plant, trial, 0, nullptr);
  double half = 0, before = 0, end = 0;
  for (double t = 0; t < 0.5; t += 0.001) {
    const double x = path.over(t, t + 0.001);
    if (x >= 0.5 && half == 0) half = t;
    if (t < 0.05) before = x;
    end = x;
  }
  EXPECT_NEAR(before, 0, 1e-9);
  EXPECT_NEAR(half - 0.05, 0.1, 0.003);
  EXPECT_NEAR(end, 1, 1e-6);
}

TEST_F(CommandPathTest, aLagComesNearExponentially) {
  plant.commandLag = 0.02;
  for (const double step : {0.003, 0.0125, 0.05}) {
    CommandPath path(plant, trial, 0, nullptr);
    double sum = 0;
    for (double t = 0; t < 0.0999; t += step) {
      const double to = std::min(0.1, t + step);
      sum += path.over(t, to) * (to - t);
      EXPECT_NEAR(path.atEnd(), to < 0.05 ? 0 : 1 - std::exp(-(to - 0.05) / 0.02), 1e-12) << step;
    }
    // The command's 0.05 rad s, less what it is behind in the end.
    EXPECT_NEAR(sum, 0.05 - 0.02 * (1 - std::exp(-2.5)), 1e-12) << step;
  }
}

TEST_F(CommandPathTest, behindAStraightLineItIsLateByItsTimeConstant) {
  trial.linearCommands = true;
  plant.commandLag = 0.001;
  CommandPath path(plant, trial, 0, nullptr);
  path.over(0, 0.047);
  const double mean = path.over(0.047, 0.049);
  EXPECT_NEAR(mean, 0.7, 1e-3);
  EXPECT_NEAR(path.atEnd(), 0.8, 1e-3);
}

TEST_F(CommandPathTest, aDelayAndAProfileGoWithALag) {
  plant.commandDelay = 0.01;
  plant.commandLag = 0.02;
  CommandPath path(plant, trial, 0, nullptr);
  path.over(0, 0.06);
  EXPECT_DOUBLE_EQ(path.atEnd(), 0);
  path.over(0.06, 0.08);
  EXPECT_NEAR(path.atEnd(), 1 - std::exp(-1), 1e-12);
  plant.profileSpeed = 5;
  CommandPath slow(plant, trial, 0, nullptr);
  slow.over(0, 0.1);
  EXPECT_NEAR(slow.atEnd(), 5 * 0.04, 2e-3) << "the profile is the slower one";
}

TEST_F(CommandPathTest, straightLinesGoFromCommandToCommand) {
  trial.linearCommands = true;
  for (std::size_t k = 0; k < 10; ++k) trial.command[0][k] = k < 5 ? 0 : 0.1 * static_cast<double>(k - 4);
  CommandPath path(plant, trial, 0, nullptr);
  EXPECT_DOUBLE_EQ(path.over(0, 0.02), 0);
  EXPECT_NEAR(path.over(0.02, 0.05), 0.1 / 2 / 3, 1e-12) << "0 until 0.04 s, then up to 0.1";
  EXPECT_NEAR(path.over(0.05, 0.07), 0.2, 1e-12);
  EXPECT_NEAR(path.over(0.07, 0.075), 0.325, 1e-12);
  EXPECT_NEAR(path.over(0.075, 0.09), 0.425, 1e-12);
  EXPECT_NEAR(path.over(0.09, 0.2), 0.5, 1e-12) << "the last one holds";
}

TEST_F(CommandPathTest, aLineGoesOverALostCommandToTheNext) {
  trial.linearCommands = true;
  for (std::size_t k = 0; k < 10; ++k) trial.command[0][k] = k == 1 ? 5 : 0.1 * static_cast<double>(k);
  std::vector<std::uint8_t> lost(10, 0);
  lost[1] = 1;
  CommandPath path(plant, trial, 0, &lost);
  EXPECT_NEAR(path.over(0, 0.02), 0.1, 1e-12);
}

TEST_F(CommandPathTest, speedsAndTorquesSentWithPositionsAreThoseOfTheLastCycle) {
  trial.commandSpeed.resize(2);
  trial.commandTorque = {std::vector<double>(10, 0.0), {}};
  for (std::size_t k = 5; k < 10; ++k) trial.commandTorque[0][k] = 0.7;
  CommandPath path(plant, trial, 0, nullptr);
  path.over(0, 0.045);
  EXPECT_EQ(path.torqueSent(), 0);
  path.over(0.045, 0.055);
  EXPECT_EQ(path.torqueSent(), 0.7);
  EXPECT_EQ(path.speedSent(), 0);
}

}  // namespace
}  // namespace plumbline::gap
