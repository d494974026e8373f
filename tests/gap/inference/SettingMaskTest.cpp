#include "gap/inference/SettingMask.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../SomeRecordings.h"

namespace plumbline::gap {

using Names = std::vector<std::string>;

TEST(SettingMask, recordingsAreNamedOnceAndThoseLeftOutAreNot) {
  const Groups groups(someRecordings({}, ""));
  EXPECT_EQ(recordingsOf(groups), (Names{"monday", "tuesday", "friday"}));
  EXPECT_EQ(recordingsOf(groups.without(1)), (Names{"monday", "friday"}));
}

TEST(SettingMask, aMaskCostsAsManyAsThereAreOfItsSize) {
  const Names recordings{"monday", "tuesday", "friday"};
  Explanation causes{causeOfArm("acceleration_limit", "elbow", 20)};
  EXPECT_EQ(priceOfMasks(causes, recordings), 0);
  causes[0].inactiveIn = {"tuesday"};
  EXPECT_NEAR(priceOfMasks(causes, recordings), std::log(4 * 3), 1e-12);
  causes[0].inactiveIn = {"tuesday", "friday"};
  EXPECT_NEAR(priceOfMasks(causes, recordings), std::log(4 * 3), 1e-12);
  causes[0].inactiveIn = {"sunday"};
  EXPECT_EQ(priceOfMasks(causes, recordings), 0);
}

TEST(SettingMask, elsewhereASettingIsExpectedThatHalfOfTheRecordingsHad) {
  Explanation causes{causeOfArm("acceleration_limit", "elbow", 20), causeOfArm("dead_band", "elbow", 0.01)};
  causes[0].inactiveIn = {"monday"};
  causes[1].inactiveIn = {"monday", "tuesday"};
  const Explanation elsewhere = expectedElsewhere(causes, {"monday", "tuesday", "friday"});
  ASSERT_EQ(elsewhere.size(), 1U);
  EXPECT_EQ(elsewhere[0], causeOfArm("acceleration_limit", "elbow", 20));
  EXPECT_EQ(expectedElsewhere(causes, {"monday", "friday"}).size(), 2U);
}

TEST(SettingMask, aSettingIsInactiveWhereTheReadingsAreLikelierWithoutIt) {
  const Mechanism arm = twoJointArm();
  const Explanation truth{causeOfArm("acceleration_limit", "elbow", 20),
                          causeOfArm("coulomb_friction", "elbow", 0.08)};
  const Groups groups(someRecordings(truth, "tuesday"));
  const Replayer replayer(arm, groups, 1);
  const Explanation masked = withLikeliestMasks(replayer, truth);
  EXPECT_EQ(masked[0].inactiveIn, Names{"tuesday"});
  EXPECT_EQ(masked[1].inactiveIn, Names{});
  EXPECT_EQ(withLikeliestMasks(replayer, masked), masked);
}

TEST(SettingMask, whatEachRecordingHadIsActiveInAll) {
  const Mechanism arm = twoJointArm();
  Explanation truth{causeOfArm("acceleration_limit", "elbow", 20)};
  const Groups groups(someRecordings(truth, ""));
  const Replayer replayer(arm, groups, 1);
  EXPECT_EQ(withLikeliestMasks(replayer, truth), truth);
  Explanation wrong = truth;
  wrong[0].inactiveIn = {"friday"};
  EXPECT_EQ(withLikeliestMasks(replayer, wrong), truth);
}

}  // namespace plumbline::gap
