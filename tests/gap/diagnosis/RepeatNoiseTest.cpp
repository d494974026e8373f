#include "gap/diagnosis/RepeatNoise.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

constexpr double noise = 5e-4;

TEST(RepeatNoiseTest, whatRepeatsDifferBy) {
  const Evidence evidence = evidenceOf(recordedTwice(nominalPlant(twoJointArm()), noise, 0), 1);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_TRUE(evidence.noise(0, s).repeated);
    EXPECT_NEAR(evidence.noise(0, s).sigma, noise, 0.1 * noise);
  }
}

}  // namespace
}  // namespace plumbline::gap
