#include "gap/diagnosis/Evidence.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

TEST(EvidenceTest, weightsAreMultipliedByChannel) {
  const Mechanism arm = twoJointArm();
  const Evidence evidence({recorded(nominalPlant(arm), armTrial(arm, 1.5), 5e-4, 3)});
  const Evidence other =
      evidence.weightedBy([](std::size_t, std::size_t signal) { return signal == 1 ? 0.25 : 1; });
  const std::size_t last = evidence.trials()[0].cycles() - 1;
  ASSERT_GT(evidence.weights(0, 1)[last], 0);
  EXPECT_DOUBLE_EQ(other.weights(0, 0)[last], evidence.weights(0, 0)[last]);
  EXPECT_DOUBLE_EQ(other.weights(0, 1)[last], 0.25 * evidence.weights(0, 1)[last]);
  EXPECT_EQ(other.weights(0, 1).front(), 0) << "what does not count still does not";
}

}  // namespace
}  // namespace plumbline::gap
