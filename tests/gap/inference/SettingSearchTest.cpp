#include "gap/inference/SettingSearch.h"

#include <gtest/gtest.h>

#include "../SomeRecordings.h"
#include "gap/inference/SetSearch.h"

namespace plumbline::gap {

using Names = std::vector<std::string>;

TEST(SettingSearch, aLimitIsProposedAtAStrengthBetweenTheStartsAndWithoutTheRecordingThatLackedIt) {
  const Mechanism arm = twoJointArm();
  const Groups groups(someRecordings({causeOfArm("acceleration_limit", "elbow", 17)}, "tuesday"));
  const std::vector<Cause> proposed = proposedSettings(Replayer(arm, groups, 1), {}, 2);
  ASSERT_EQ(proposed.size(), 2U);
  EXPECT_EQ(proposed[0].effect->id, "acceleration_limit");
  EXPECT_EQ(proposed[0].place.at, "elbow");
  EXPECT_NEAR(proposed[0].value, 17, 2.6);  // strengths are 15 % apart
  EXPECT_EQ(proposed[0].inactiveIn, Names{"tuesday"});
  EXPECT_NE(proposed[1].effect->id, "acceleration_limit") << "one of each effect";
}

TEST(SettingSearch, aSearchNamesASettingThatOneRecordingLacked) {
  const Mechanism arm = twoJointArm();
  const Groups groups(someRecordings({causeOfArm("acceleration_limit", "elbow", 17)}, "tuesday"));
  const Replayer replayer(arm, groups, 1);
  const BeamResult found = searchForSets({replayer, nullptr, &replayer}, {});
  const Explanation& causes = found.sets.front().causes();
  ASSERT_EQ(causes.size(), 1U);
  EXPECT_EQ(causes[0].effect->id, "acceleration_limit");
  EXPECT_NEAR(causes[0].value, 17, 0.5);
  EXPECT_EQ(causes[0].inactiveIn, Names{"tuesday"});
  EXPECT_EQ(found.lessOne.size(), 1U);
}

TEST(SettingSearch, aSettingTakesThePlaceOfAnotherCauseWhereNoMoreAreAllowed) {
  const Mechanism arm = twoJointArm();
  const Groups groups(someRecordings({causeOfArm("acceleration_limit", "elbow", 17)}, "tuesday"));
  const Replayer replayer(arm, groups, 1);
  SetSearchOptions one;
  one.mostCauses = 1;
  const BeamResult found = searchForSets({replayer, nullptr, &replayer}, one);
  ASSERT_EQ(found.sets.front().causes().size(), 1U);
  EXPECT_EQ(found.sets.front().causes()[0].inactiveIn, Names{"tuesday"});
}

}  // namespace plumbline::gap
