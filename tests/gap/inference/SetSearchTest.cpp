#include "gap/inference/SetSearch.h"

#include <gtest/gtest.h>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

TEST(SetSearch, aSetIsJudgedByItsValuesWithoutEachGroup) {
  const Mechanism arm = twoJointArm();
  const Cause truth = causeOf(arm, "coulomb_friction", "shoulder", 0.15);
  Cause off = truth;
  off.value = 0.4;
  const Groups groups(recordings({truth}, 2));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({truth}));
  Scored set;
  set.fitted.causes = {truth};
  set.without = {{truth}, {off}, {truth}};
  set.price = 3;
  const Scored of = judged(replayer, shares, set);
  const std::vector<double> right = densities(groups, replayer.residuals({truth}), shares);
  ASSERT_EQ(of.density.size(), 3U);
  EXPECT_EQ(of.density[0], right[0]);
  EXPECT_EQ(of.density[2], right[2]);
  EXPECT_LT(of.density[1], right[1]);
  EXPECT_EQ(of.price, 3);
}

TEST(SetSearch, withWindowsTheAnswerIsNoWorseByTheOneScore) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOf(arm, "coulomb_friction", "shoulder", 0.15)}, 2));
  const Replayer replayer(arm, groups, 1);
  const WindowReplayer windows(arm, groups, 1);
  BeamOptions options;
  options.mostCauses = 2;
  const BeamResult free = searchBothWays(replayer, nullptr, options),
                   both = searchBothWays(replayer, &windows, options);
  const Scored before = judged(replayer, both.shares, free.sets.front());
  EXPECT_GE(both.sets.front().score(), before.score());
  ASSERT_EQ(both.sets.front().causes().size(), 1U);
  EXPECT_EQ(both.sets.front().causes()[0].effect->id, std::string("coulomb_friction"));
  ASSERT_EQ(both.lessOne.size(), 1U);
  EXPECT_TRUE(both.lessOne[0].causes().empty());
}

}  // namespace plumbline::gap
