#include "gap/inference/Posterior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

Scored setOf(Explanation causes, std::vector<double> gain, double price = 0) {
  Scored scored;
  scored.fitted.causes = std::move(causes);
  scored.gain = std::move(gain);
  scored.price = price;
  return scored;
}

Cause friction() { return causeOfArm("coulomb_friction", "elbow", 0.1); }
Cause gain() { return causeOfArm("servo_gain", "elbow", 0.9); }

TEST(Posterior, setsThatGainTheSameInEveryGroupAreWhatTheirScoresSay) {
  // All groups alike: whatever they count, the score is the sum, here 3 and 2 with prices 1 and 0.5.
  const std::vector<double> p =
      posterior({setOf({friction()}, {1, 1, 1}, 1), setOf({gain()}, {2.0 / 3, 2.0 / 3, 2.0 / 3}, 0.5)});
  EXPECT_NEAR(p[0] / p[1], std::exp(2 - 1.5), 1e-9);
  EXPECT_NEAR(p[0] + p[1], 1, 1e-12);
}

// One group decides for one set, two for another: with so few, nobody knows which motions are the usual ones.
TEST(Posterior, groupsThatDisagreeLeaveDoubt) {
  const std::vector<Scored> sets{setOf({friction()}, {60, 0, 0}), setOf({gain()}, {0, 20, 20})};
  const std::vector<double> p = posterior(sets);
  EXPECT_GT(p[1], 0.1) << "their sums alone leave it e^-20";
  EXPECT_GT(p[0], p[1]);
  EXPECT_NEAR(p[0] + p[1], 1, 1e-12);
}

TEST(Posterior, aSetThatIsBetterInEveryGroupByFarIsCertain) {
  const std::vector<double> p = posterior({setOf({friction()}, {30, 50, 40}), setOf({gain()}, {0, 20, 10})});
  EXPECT_GT(p[0], 0.999);
}

// The share of draws in which the first set is better, worked out: its group's weight is above a half, and of
// two groups with exponential weights the share is uniform.
TEST(Posterior, isAMeanOverHowMuchEachGroupCounts) {
  const std::vector<double> p = posterior({setOf({friction()}, {1e4, 0}), setOf({gain()}, {0, 1e4})});
  EXPECT_NEAR(p[0], 0.5, 4 * 0.5 / std::sqrt(400)) << "four standard errors of its draws";
  const std::vector<double> third = posterior({setOf({friction()}, {2e4, 0}), setOf({gain()}, {0, 1e4})});
  EXPECT_NEAR(third[0], 2.0 / 3, 4 * 0.47 / std::sqrt(400));
}

TEST(Posterior, theSameSeedGivesTheSameNumbers) {
  const std::vector<Scored> sets{setOf({friction()}, {9, 0, 2}), setOf({gain()}, {0, 7, 5})};
  EXPECT_EQ(posterior(sets, 3), posterior(sets, 3));
  EXPECT_NE(posterior(sets, 3), posterior(sets, 4));
  EXPECT_TRUE(posterior({}).empty());
}

TEST(Posterior, ofACauseIsThatOfAllSetsThatHoldIt) {
  Cause stronger = friction();
  stronger.value = 0.3;
  const std::vector<Scored> sets{setOf({friction()}, {1}), setOf({gain(), stronger}, {1}),
                                 setOf({gain()}, {1})};
  const std::vector<double> p{0.5, 0.3, 0.2};
  EXPECT_NEAR(probabilityOf(friction(), sets, p), 0.8, 1e-12) << "whatever its value";
  EXPECT_NEAR(probabilityOf(gain(), sets, p), 0.5, 1e-12);
  EXPECT_EQ(probabilityOf(causeOfArm("servo_gain", "shoulder", 0.9), sets, p), 0);
}

}  // namespace
}  // namespace plumbline::gap
