#include "gap/inference/SetSearch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

TEST(SetSearch, whereNothingIsMissingTheEmptySetIsTheAnswer) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}, 2));
  const Replayer replayer(arm, groups, 1);
  EXPECT_TRUE(searchForSets({replayer, nullptr, &replayer}, {}).sets.front().causes().empty());
}

}  // namespace plumbline::gap
