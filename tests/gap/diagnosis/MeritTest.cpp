#include "gap/diagnosis/Merit.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

constexpr double noise = 5e-4;

/// An arm whose elbow is pulled three times the noise away, and whose shoulder is off by 2.9 times the noise
/// for no reason that the library knows.
struct MeritTest : ::testing::Test {
  static std::vector<Trial> trials() {
    std::vector<Trial> result;
    for (const std::uint64_t seed : {1, 2}) {
      result.push_back(recorded(plantOf(twoJointArm(), {pull()}), armTrial(twoJointArm(), 8), noise, seed));
      for (double& value : result.back().signals[0].values) value += 2.9 * noise;
    }
    return result;
  }
  static Cause pull() { return causeOfArm("bias_force", "elbow", 0.03); }

  const Mechanism arm = twoJointArm();
  const Evidence evidence{trials()};
  Evaluator evaluator{arm, evidence};
};

TEST_F(MeritTest, whereLittleIsLeftACauseMayTellInTheWorstChannelAlone) {
  const AcceptanceTest before(evaluator);
  const double unexplained = excess(evaluator), judging = evaluator.baseFit().judging;
  evaluator.setBase({pull()});
  const double part = (judging - evaluator.baseFit().judging) / unexplained;
  EXPECT_GT(part, 0.4);
  EXPECT_LT(part, 0.6) << "of all that is left";
  EXPECT_TRUE(before.passes(evaluator, 0));
  EXPECT_TRUE(before.passes(evaluator, 0.6));
}

TEST_F(MeritTest, notAtAJointThatHasACause) {
  const Cause damping = causeOfArm("viscous_friction", "elbow", 1e-6);
  evaluator.setBase({damping});
  const AcceptanceTest before(evaluator);
  evaluator.setBase({damping, pull()});
  EXPECT_TRUE(before.passes(evaluator, 0));
  EXPECT_FALSE(before.passes(evaluator, 0.6));
}

TEST_F(MeritTest, whatIsLeftIsSharedByTheDirectionsOfAllChannels) {
  evaluator.setBase({pull()});
  EXPECT_NEAR(leftPerDirection(evaluator), excess(evaluator) / (2 * 2 * 2), 1e-9);
  EXPECT_GT(leftPerDirection(evaluator), 100);
}

}  // namespace
}  // namespace plumbline::gap
