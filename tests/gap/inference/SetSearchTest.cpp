// Short searches; longer ones are in tests/diagnosis.
#include "gap/inference/SetSearch.h"

#include <gtest/gtest.h>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

TEST(SetSearch, ofShortRecordingsInWindows) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOf(arm, "servo_gain", "elbow", 0.7)}, 0.6));
  const Replayer replayer(arm, groups, 1);
  WindowReplayer windows(arm, groups, 1);
  SetSearchOptions options;
  options.mostCauses = 1;
  const BeamResult found = searchForSets({replayer, &windows}, options);
  ASSERT_EQ(found.sets.front().causes().size(), 1U);
  EXPECT_EQ(found.sets.front().causes()[0].effect->id, std::string("servo_gain"));
  EXPECT_NEAR(found.sets.front().causes()[0].value, 0.7, 0.02);
}

TEST(SetSearch, whereNothingIsMissingTheEmptySetIsTheAnswer) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}, 2));
  const Replayer replayer(arm, groups, 1);
  EXPECT_TRUE(searchForSets({replayer, nullptr, &replayer}, {}).sets.front().causes().empty());
}

TEST(SetSearch, setsFromElsewhereAreJudgedByTheSameScore) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOf(arm, "servo_gain", "elbow", 0.7)}, 0.6));
  const Replayer replayer(arm, groups, 1);
  SetSearchOptions few;
  few.mostCauses = 0;
  const BeamResult none = searchSets(replayer, few);
  ASSERT_TRUE(none.sets.front().causes().empty());

  const Explanation gain{causeOf(arm, "servo_gain", "elbow", 0.9)},
      other{causeOf(arm, "servo_gain", "shoulder", 0.99)};
  const BeamResult found = withOthers(replayer, none, {other, gain}, {});
  ASSERT_EQ(found.sets.front().causes().size(), 1U);
  EXPECT_EQ(found.sets.front().causes()[0].place.at, "elbow");
  EXPECT_NEAR(found.sets.front().causes()[0].value, 0.7, 0.02);
  ASSERT_EQ(found.lessOne.size(), 1U);
  EXPECT_TRUE(found.lessOne[0].causes().empty());
  for (std::size_t i = 1; i < found.sets.size(); ++i) EXPECT_GE(found.sets[0].score(), found.sets[i].score());

  const BeamResult same = withOthers(replayer, none, {other}, {});
  EXPECT_GE(same.sets.front().score(), none.sets.front().score());
}

}  // namespace plumbline::gap
