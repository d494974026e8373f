#include "gap/inference/Channels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../DutyTrial.h"

namespace plumbline::gap {

TEST(Channels, stepOfAnEncoderIsTheSmallestDifferenceThatOccurs) {
  const double step = 2 * M_PI / 4096;
  std::vector<double> values;
  for (int k = 0; k < 400; ++k) values.push_back(step * std::round(0.4 * std::sin(0.05 * k) / step));
  EXPECT_NEAR(smallestStep(values), step, 1e-9);
}

TEST(Channels, aJointThatRestsAtRoundPosesKeepsItsFineStep) {
  // Poses on multiples of 16 counts for most of the time, fine counts between them.
  const double step = 2 * M_PI / 4096;
  std::vector<double> values;
  for (int pose = 0; pose < 8; ++pose) {
    for (int k = 0; k < 200; ++k) values.push_back(16 * step * pose);
    for (int k = 1; k < 16; ++k) values.push_back(step * (16 * pose + k));
  }
  EXPECT_NEAR(smallestStep(values), step, 1e-9);
}

TEST(Channels, readingsRoundedToFiveDigitsKeepTheStep) {
  const double step = 2 * M_PI / 4096;
  std::vector<double> values;
  for (int k = 0; k < 800; ++k)
    values.push_back(std::round(1e5 * step * std::round(0.4 * std::sin(0.05 * k) / step)) / 1e5);
  EXPECT_NEAR(smallestStep(values), step, 0.02 * step);
}

TEST(Channels, readingsWithoutAGridHaveNoStep) {
  Random random(3);
  std::vector<double> values;
  for (int k = 0; k < 500; ++k) values.push_back(random.gaussian());
  EXPECT_EQ(smallestStep(values), 0);
}

TEST(Channels, noiseOfARecordingIsFoundAndSpeedIsNotUsed) {
  const Mechanism arm = twoJointArm();
  Trial trial = recorded(nominalPlant(arm), armTrial(arm, 6), 1e-3, 7);
  Signal speed = trial.signals[0];
  speed.name = "vel.shoulder";
  speed.kind = SignalKind::velocity;
  trial.signals.push_back(speed);
  const auto uses = channelUses({trial});
  EXPECT_TRUE(uses[0][0].used);
  EXPECT_NEAR(uses[0][0].noise, 1e-3, 2e-4);
  EXPECT_FALSE(uses[0][2].used);
  EXPECT_EQ(uses[0][2].why, "it is the derivative of the position, which is used");
}

TEST(Channels, whatRepeatsDifferByIsNoiseAndSeparateFromThatOfTheReadings) {
  const Mechanism arm = twoJointArm();
  Trial first = recorded(nominalPlant(arm), armTrial(arm, 6), 1e-3, 7), again = first;
  again.recording = "again";
  for (double& value : again.signals[0].values) value += 0.02;
  const auto uses = channelUses({first, again});
  EXPECT_NEAR(uses[0][0].noise, 0.02 / std::sqrt(2), 5e-4);
  EXPECT_NEAR(uses[0][0].readingNoise, 1e-3, 2e-4);
  EXPECT_EQ(uses[0][1].noise, uses[0][1].readingNoise);
}

TEST(Channels, aJointThatRestsIsReadOnTheGridOfTheOthers) {
  const double step = 2 * M_PI / 4096;
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 6);
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const double angle = 0.4 * std::sin(0.05 * static_cast<double>(k));
    trial.signals[0].values[k] = step * std::round(angle / step);
    trial.signals[1].values[k] = 100 * step;
  }
  const auto uses = channelUses({trial});
  EXPECT_NEAR(uses[0][1].noise, step / std::sqrt(12), 0.05 * step);
  // Without a grid anywhere nothing is known of its readings.
  for (double& value : trial.signals[0].values) value += 1e-3 * std::sin(value * 1e7);
  EXPECT_LT(channelUses({trial})[0][1].noise, 1e-6);
}

TEST(Channels, motionIsNoNoise) {
  // 0.3 rad at 2 Hz, read at 100 Hz: second differences alone would give 1e-3 of noise.
  Trial trial;
  trial.robot = std::make_shared<Mechanism>(twoJointArm());
  Random random(3);
  Signal signal;
  signal.name = "pos.shoulder";
  signal.joint = 0;
  for (int k = 0; k < 1000; ++k) {
    trial.time.push_back(0.01 * k);
    signal.values.push_back(0.3 * std::sin(2 * M_PI * 2 * 0.01 * k) + 2e-4 * random.gaussian());
  }
  trial.signals.push_back(signal);
  // 0.1 ms of jitter at 2.7 rad/s is 2.7e-4.
  EXPECT_NEAR(channelUses({trial})[0][0].noise, std::hypot(2e-4, 2.7e-4), 0.5e-4);
}

TEST(Channels, aDutyIsUsedWhereTheServosLawIsKnown) {
  Trial trial = dutyTrial({}, 6, 1e-3);
  const auto uses = channelUses({trial});
  EXPECT_TRUE(uses[0][1].used);
  EXPECT_GT(uses[0][1].noise, 0.5e-3) << "what the angle's noise makes of it";
  trial.robot = std::make_shared<Mechanism>(twoJointArm());
  EXPECT_EQ(channelUses({trial})[0][1].why, "the robot's file gives no law of the servo's duty");
}

TEST(Channels, whatAModelPredictsOfADifferenceBetweenRepeatsIsNoNoise) {
  const Plant plant = nominalPlant(twoJointArm());
  const std::vector<Trial> trials = recordedTwice(plant, 1e-3, 0.2);
  EXPECT_GT(channelUses(trials)[0][0].noise, 5e-3);
  std::vector<Prediction> predicted;
  for (const std::uint64_t seed : {11, 12}) {  // of recordedTwice
    const std::vector<std::uint8_t> lost = drawnLosses(trials[0].cycles(), 0.2, seed);
    ReplayOptions options;
    options.lostCycles = &lost;
    predicted.push_back(replay(plant, trials[0], options));
  }
  const ChannelUse use = channelUses(trials, predicted)[0][0];
  EXPECT_NEAR(use.noise, 1e-3, 2e-4);
  EXPECT_NEAR(use.readingNoise, 1e-3, 2e-4);
}

}  // namespace plumbline::gap
