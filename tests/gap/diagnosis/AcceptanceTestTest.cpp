#include "gap/diagnosis/AcceptanceTest.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

constexpr double noise = 5e-4;

/// An arm whose elbow is pulled three times the noise away, and whose shoulder is off by 2.9 times the noise
/// for no reason that the library knows.
struct AcceptanceTestTest : ::testing::Test {
  static std::vector<Trial> trials() {
    std::vector<Trial> result;
    for (const std::uint64_t seed : {1, 2}) {
      result.push_back(recorded(plantOf(twoJointArm(), {pull()}), armTrial(twoJointArm(), 8), noise, seed));
      for (double& value : result.back().signals[0].values) value += 2.9 * noise;
    }
    return result;
  }
  static Cause pull() { return causeOfArm("bias_force", "elbow", 0.03); }
  /// Share of the squares beyond noise under the present base that another base explains, which it then has.
  double partExplainedBy(const Explanation& causes) {
    const double unexplained = excess(evaluator), before = evaluator.baseFit().judging;
    evaluator.setBase(causes);
    return (before - evaluator.baseFit().judging) / unexplained;
  }

  const Mechanism arm = twoJointArm();
  const Evidence evidence{trials()};
  Evaluator evaluator{arm, evidence};
};

TEST_F(AcceptanceTestTest, whereLittleIsLeftACauseMayPassInTheWorstChannelAlone) {
  const AcceptanceTest acceptance(evaluator);
  const double part = partExplainedBy({pull()});
  EXPECT_LT(part, 0.8) << "what is wrong with the shoulder stays";
  EXPECT_TRUE(acceptance.passes(evaluator, part / 2));
  EXPECT_TRUE(acceptance.passes(evaluator, 1.2 * part)) << "it explains the whole of the worst channel";
  // A quarter of the force explains less than half of anything.
  evaluator.setBase({causeOfArm("bias_force", "elbow", pull().value / 4)});
  EXPECT_TRUE(acceptance.passes(evaluator, 0));
  EXPECT_FALSE(acceptance.passes(evaluator, 1.2 * part));
}

TEST_F(AcceptanceTestTest, notAtAJointThatHasACause) {
  const Cause damping = causeOfArm("viscous_friction", "elbow", 1e-6);
  evaluator.setBase({damping});
  const AcceptanceTest acceptance(evaluator);
  const double part = partExplainedBy({damping, pull()});
  EXPECT_TRUE(acceptance.passes(evaluator, part / 2));
  EXPECT_FALSE(acceptance.passes(evaluator, 1.2 * part));
}

TEST_F(AcceptanceTestTest, whatIsLeftIsSharedByTheDirectionsOfAllChannels) {
  evaluator.setBase({pull()});
  EXPECT_NEAR(leftPerDirection(evaluator), excess(evaluator) / (2 * 2 * 2), 1e-9);
  EXPECT_GT(leftPerDirection(evaluator), 100);
}

}  // namespace
}  // namespace plumbline::gap
