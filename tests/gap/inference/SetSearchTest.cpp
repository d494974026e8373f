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

}  // namespace plumbline::gap
