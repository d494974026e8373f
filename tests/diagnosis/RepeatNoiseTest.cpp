// Those of tests/gap/diagnosis/RepeatNoiseTest.cpp that take longer.
#include "gap/diagnosis/RepeatNoise.h"

#include <gtest/gtest.h>

#include "gap/TwoJointArm.h"

namespace plumbline::gap {
namespace {

constexpr double noise = 5e-4;

TEST(RepeatNoiseTest, lostCommandsAreNoNoiseWithAnotherCauseEither) {
  Plant plant = nominalPlant(twoJointArm());
  plant.joints[1].coulomb += 0.1;
  const std::vector<Trial> trials = recordedTwice(plant, noise, 0.1);
  const Evidence evidence = evidenceOf(trials, 1), byRepeats(trials);
  for (std::size_t s = 0; s < 2; ++s)
    EXPECT_LT(evidence.noise(0, s).sigma, byRepeats.noise(0, s).sigma / 4) << s;
}

TEST(RepeatNoiseTest, withAStrongCauseOnceItIsKnown) {
  Plant plant = nominalPlant(twoJointArm());
  for (JointPlant& joint : plant.joints) joint.viscous += 1;
  const Evidence byRepeats(recordedTwice(plant, noise, 0.1));
  EXPECT_FALSE(evidenceWithoutLosses(byRepeats, {}, 1)) << "nothing tells losses from the rest";
  const Explanation causes = {causeOfArm("viscous_friction", "shoulder", 1),
                              causeOfArm("viscous_friction", "elbow", 1)};
  const std::optional<Evidence> evidence = evidenceWithoutLosses(byRepeats, causes, 1);
  ASSERT_TRUE(evidence);
  for (std::size_t s = 0; s < 2; ++s) EXPECT_NEAR(evidence->noise(0, s).sigma, noise, 0.15 * noise) << s;
  EXPECT_FALSE(evidenceWithoutLosses(*evidence, causes, 1)) << "known already";
}

TEST(RepeatNoiseTest, lostCommandsAreNoNoise) {
  const std::vector<Trial> trials = recordedTwice(nominalPlant(twoJointArm()), noise, 0.1);
  const Evidence evidence = evidenceOf(trials, 1), byRepeats(trials);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_GT(byRepeats.noise(0, s).sigma, 5 * noise);
    // Losses too small to be seen stay in it.
    EXPECT_LT(evidence.noise(0, s).sigma, 1.8 * noise);
    EXPECT_GE(evidence.noise(0, s).sigma, 0.9 * noise);
  }
}

TEST(RepeatNoiseTest, whatElseRepeatsDifferByStays) {
  // A robot that is warmer the second time: no commands were lost.
  Plant warm = nominalPlant(twoJointArm());
  std::vector<Trial> trials = recordedTwice(warm, noise, 0);
  warm.joints[0].viscous += 0.3;
  warm.joints[1].viscous += 0.3;
  trials[1] = recordedTwice(warm, noise, 0)[1];
  const Evidence evidence = evidenceOf(trials, 1), byRepeats(trials);
  for (std::size_t s = 0; s < 2; ++s) EXPECT_EQ(evidence.noise(0, s).sigma, byRepeats.noise(0, s).sigma);
}

}  // namespace
}  // namespace plumbline::gap
