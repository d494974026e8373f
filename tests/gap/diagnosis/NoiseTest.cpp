#include "gap/diagnosis/Noise.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

std::vector<double> wave(double noise, double step, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values;
  for (int k = 0; k < 2000; ++k) {
    double x = 0.5 * std::sin(2 * M_PI * 0.2 * 0.01 * k);
    if (step > 0) x = step * std::round(x / step);
    values.push_back(x + noise * random.gaussian());
  }
  return values;
}

TEST(NoiseTest, fastNoiseIsFoundDuringMotion) { EXPECT_NEAR(fastNoise(wave(1e-3, 0, 3)), 1e-3, 1e-4); }

TEST(NoiseTest, theEncodersGridIsFoundThroughNoise) {
  const double step = 2 * M_PI / 4096;
  EXPECT_DOUBLE_EQ(quantum(wave(3e-4, step, 4)), step);
  EXPECT_DOUBLE_EQ(quantum(wave(3e-4, 0, 5)), 0);
}

TEST(NoiseTest, repeatsTellTheNoise) {
  const Mechanism arm = twoJointArm();
  const Plant plant = nominalPlant(arm);
  const Trial a = recorded(plant, armTrial(arm), 2e-3, 1), b = recorded(plant, armTrial(arm), 2e-3, 2);
  EXPECT_TRUE(isRepeat(a, b));
  const auto noise = estimateNoise({a, b});
  EXPECT_TRUE(noise[0][0].repeated);
  EXPECT_NEAR(noise[0][0].sigma, 2e-3, 1e-4);
  Trial other = b;
  for (double& c : other.command[0]) c += 0.1;
  EXPECT_FALSE(isRepeat(a, other));
  Trial turned = b;
  turned.heading = M_PI;
  EXPECT_FALSE(isRepeat(a, turned));
}

TEST(NoiseTest, repeatsWereSentTheSameTorquesAndSpeeds) {
  const Mechanism arm = twoJointArm();
  Trial a = recorded(nominalPlant(arm), armTrial(arm), 2e-3, 1);
  a.commandTorque.resize(2);
  a.commandSpeed.resize(2);
  Trial b = a;
  b.commandTorque[1].assign(a.cycles(), 0.4);
  EXPECT_FALSE(isRepeat(a, b)) << "one was sent none";
  a.commandTorque[1].assign(a.cycles(), 0.4);
  EXPECT_TRUE(isRepeat(a, b));
  a.commandTorque[1].assign(a.cycles(), 0.41);
  EXPECT_FALSE(isRepeat(a, b));
  b = a;
  a.commandSpeed[0].assign(a.cycles(), 2);
  EXPECT_FALSE(isRepeat(a, b));
}

TEST(NoiseTest, repeatsAgreeUnlessSomethingCameByChance) {
  const Plant plant = nominalPlant(twoJointArm());
  EXPECT_TRUE(repeatsAgree(recordedTwice(plant, 5e-4, 0)));
  EXPECT_FALSE(repeatsAgree(recordedTwice(plant, 5e-4, 0.05)));
  EXPECT_FALSE(repeatsAgree({recordedTwice(plant, 5e-4, 0)[0]})) << "nothing was repeated";
}

}  // namespace
}  // namespace plumbline::gap
