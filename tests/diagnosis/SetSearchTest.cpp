// Those of tests/gap/inference/SetSearchTest.cpp that take longer.
#include "gap/inference/SetSearch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gap/ThreeRecordings.h"

namespace plumbline::gap {

TEST(SetSearch, withWindowsTheAnswerIsNoWorseByTheOneScore) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOf(arm, "coulomb_friction", "shoulder", 0.15)}, 2));
  const Replayer replayer(arm, groups, 1);
  WindowReplayer windows(arm, groups, 1);
  SetSearchOptions options;
  options.mostCauses = 2;
  const BeamResult free = searchForSets({replayer}, options),
                   both = searchForSets({replayer, &windows}, options);
  EXPECT_GE(both.sets.front().score(), free.sets.front().score());
  ASSERT_EQ(both.sets.front().causes().size(), 1U);
  EXPECT_EQ(both.sets.front().causes()[0].effect->id, std::string("coulomb_friction"));
  ASSERT_EQ(both.lessOne.size(), 1U);
  EXPECT_TRUE(both.lessOne[0].causes().empty());
  for (const Scored& set : both.sets)
    for (const Cause& cause : set.causes()) EXPECT_FALSE(doesNothing(arm, cause)) << describe(cause);
}

TEST(SetSearch, ofManyKindsDerivativesProposeAndTheOneScoreChooses) {
  const Mechanism arm = twoJointArm();
  const Explanation truth{causeOf(arm, "coulomb_friction", "shoulder", 0.15),
                          causeOf(arm, "servo_gain", "elbow", 0.7)};
  const Groups groups(recordings(truth, 3));
  const Replayer replayer(arm, groups, 1);
  for (const bool quick : {false, true}) {
    SetSearchOptions options;
    options.mostCauses = 3;
    options.quick = quick;
    const BeamResult found = searchForSets({replayer, nullptr, &replayer}, options);
    const Explanation& causes = found.sets.front().causes();
    ASSERT_EQ(causes.size(), 2U);
    for (const Cause& cause : truth) {
      const auto same = std::ranges::find_if(causes, [&](const Cause& c) { return c.sameKind(cause); });
      ASSERT_NE(same, causes.end()) << describe(cause);
      EXPECT_NEAR(same->value, cause.value, 0.05 * cause.value);
    }
    EXPECT_EQ(found.lessOne.size(), 2U);
    for (const Scored& rest : found.lessOne) EXPECT_LT(rest.score(), found.sets.front().score());
    EXPECT_EQ(found.sets.front().without.size(), 3U);
  }
}

}  // namespace plumbline::gap
