#include "gap/replay/Playback.h"

#include <gtest/gtest.h>

#include "../DutyTrial.h"

namespace plumbline::gap {
namespace {

class PlaybackTest : public ::testing::Test {
protected:
  static std::vector<double> valuesOf(const std::vector<Playback::Shown>& shown) {
    std::vector<double> values;
    for (const auto& [signal, cycle, value] : shown) values.push_back(value);
    return values;
  }

  const Mechanism arm = twoJointArm();
  const Plant plant = nominalPlant(arm);
  const Trial trial = armTrial(arm, 2);
};

TEST_F(PlaybackTest, readingsFallDueOncePerSignalAndCycle) {
  Playback playback(plant, trial, {});
  std::vector<std::size_t> next(2, 0);
  const auto count = [&](const std::vector<Playback::Shown>& shown) {
    for (const auto& [signal, cycle, value] : shown) EXPECT_EQ(cycle, next[signal]++);
  };
  count(playback.settle());
  for (std::size_t k = 0; k < trial.cycles(); ++k) count(playback.play(k));
  EXPECT_EQ(next, std::vector<std::size_t>(2, trial.cycles()));
}

TEST_F(PlaybackTest, aStepSpansNoCyclesWhoseCommandIsAskedFor) {
  ReplayOptions options;
  options.step = 0.025;  // cycles are 10 ms
  const Playback positions(plant, trial, options);
  EXPECT_EQ(positions.lastInStep(0), 1u);
  EXPECT_EQ(positions.lastInStep(trial.cycles() - 3), trial.cycles() - 2);
  EXPECT_EQ(positions.lastInStep(trial.cycles() - 1), trial.cycles() - 1);
  EXPECT_EQ(Playback(plant, trial, {}).lastInStep(0), 0u);
  Trial withTorque = trial;
  withTorque.signals[1].kind = SignalKind::torque;
  EXPECT_EQ(Playback(plant, withTorque, options).lastInStep(0), 0u);
}

TEST_F(PlaybackTest, whatATrialKnowsToBeLostIsNotPlayedUnlessAsSent) {
  std::vector<std::uint8_t> lost(trial.cycles(), 0);
  for (const std::size_t k : {20, 21, 40}) lost[k] = 1;
  Trial knows = trial;
  knows.lost = lost;
  ReplayOptions given, asSent;
  given.lostCycles = &lost;
  asSent.asSent = true;
  EXPECT_EQ(replay(plant, knows).values, replay(plant, trial, given).values);
  EXPECT_NE(replay(plant, knows).values, replay(plant, trial).values);
  EXPECT_EQ(replay(plant, knows, asSent).values, replay(plant, trial).values);
}

TEST_F(PlaybackTest, aCopyGoesOnByItself) {
  Playback one(plant, trial, {});
  one.settle();
  for (std::size_t k = 0; k < 50; ++k) one.play(k);
  Playback same = one, other = one;
  const std::vector<std::uint8_t> lost(trial.cycles(), 1);
  other.lose(&lost);
  std::vector<double> first, second, third;
  for (std::size_t k = 50; k < 60; ++k) {
    first = valuesOf(one.play(k));
    second = valuesOf(same.play(k));
    third = valuesOf(other.play(k));
    EXPECT_EQ(first, second) << k;
  }
  EXPECT_GT(std::abs(first[0] - third[0]), 0.01);
}

TEST_F(PlaybackTest, jointsThatAreNotPlayedAreNotRead) {
  ReplayOptions options;
  options.joints = {0};
  const Playback playback(plant, trial, options);
  EXPECT_TRUE(playback.reads(0));
  EXPECT_FALSE(playback.reads(1));
}

/// Largest difference of what is measured and what the nominal model predicts.
double mostOff(const Trial& trial, std::size_t signal) {
  const Prediction nominal = replay(plantOf(trial, {}), trial);
  double most = 0;
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const double off = std::abs(trial.signals[signal].values[k] - nominal.values[signal][k]);
    if (std::isfinite(off)) most = std::max(most, off);
  }
  return most;
}

TEST_F(PlaybackTest, aDutyTellsOfTheServoAndNotOfWhatItMoves) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const Trial heavy = dutyTrial(
      {causeOf(pendulum, "link_mass", "arm", 0.2), causeOf(pendulum, "coulomb_friction", "pendulum", 0.05)},
      3, 0);
  EXPECT_GT(mostOff(heavy, 0), 0.05) << "its position is another";
  EXPECT_LT(mostOff(heavy, 1), 1e-9);
  const Trial stiff = dutyTrial({causeOf(pendulum, "servo_gain", "pendulum", 1.2)}, 3, 0);
  EXPECT_GT(mostOff(stiff, 1), 0.02);
  const Trial late = dutyTrial({causeOf(pendulum, "command_delay", "pendulum", 0.02)}, 3, 0);
  EXPECT_GT(mostOff(late, 1), 0.02);
}

TEST_F(PlaybackTest, effortsReadAfterTheCommandAreThoseOfTheCommand) {
  Trial trial = dutyTrial({}, 3, 0);
  const double perError = trial.robot->joints[0].servo.kpFirmware * trial.robot->joints[0].servo.errorGain;
  trial.effortAt = {1e-4};
  const Prediction after = replay(plantOf(trial, {}), trial);
  trial.effortAt = {-1e-4};
  const Prediction before = replay(plantOf(trial, {}), trial);
  const auto changed = perError * (trial.command[0][51] - trial.command[0][50]);
  EXPECT_NEAR(after.values[1][51] - before.values[1][51], changed, 0.02 * std::abs(changed));
}

TEST_F(PlaybackTest, torqueAndCurrentFollowFromTheMeasuredAngleToo) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const auto efforts = [&](const Explanation& reality) {
    Trial trial = dutyTrial(reality, 3, 0);
    for (const SignalKind kind : {SignalKind::torque, SignalKind::current}) {
      Signal effort;
      effort.name = kind == SignalKind::torque ? "torque.pendulum" : "current.pendulum";
      effort.kind = kind;
      effort.joint = 0;
      effort.values.assign(trial.cycles(), 0);
      trial.signals.push_back(effort);
    }
    const Prediction shown = replay(plantOf(trial, reality), trial);
    for (const std::size_t s : {2, 3}) trial.signals[s].values = shown.values[s];
    return trial;
  };
  const Trial heavy = efforts({causeOf(pendulum, "link_mass", "arm", 0.2)});
  EXPECT_GT(mostOff(heavy, 0), 0.02) << "its position is another";
  for (const std::size_t s : {2, 3}) EXPECT_LT(mostOff(heavy, s), 1e-9);
  const double kt = pendulum.joints[0].servo.kt;
  EXPECT_NEAR(heavy.signals[3].values[50], heavy.signals[2].values[50] / kt, 1e-12);
  const Trial stiff = efforts({causeOf(pendulum, "servo_gain", "pendulum", 1.2)});
  for (const std::size_t s : {2, 3}) EXPECT_GT(mostOff(stiff, s), 0.01);
}

TEST_F(PlaybackTest, aMotorThatIsOffHasNoDutyToPredict) {
  Trial trial = dutyTrial({}, 1, 0);
  trial.stiffness[0].assign(trial.cycles(), 1);
  trial.stiffness[0][40] = 0;
  const Prediction nominal = replay(plantOf(trial, {}), trial);
  EXPECT_TRUE(std::isnan(nominal.values[1][40]));
  EXPECT_TRUE(std::isfinite(nominal.values[1][39]));
}

TEST_F(PlaybackTest, aDutyIsReadAtAnotherMomentThanThePosition) {
  // The position is read 2 ms before the cycle's time: the angle at that time lies between two readings.
  Trial trial = dutyTrial({}, 3, 0);
  const double at0 = replay(plantOf(trial, {}), trial).values[1][100];
  trial.positionAt[0] = -0.002;
  const std::vector<double>& angle = trial.signals[0].values;
  const double moved = 0.2 * (angle[101] - angle[100]);
  EXPECT_NEAR(replay(plantOf(trial, {}), trial).values[1][100], at0 - 400 * 0.00287738 * moved, 1e-9);
}

}  // namespace
}  // namespace plumbline::gap
