// Takes long; tests/gap/inference/SetSearchTest.cpp has a short search of the same kind.
#include "gap/inference/LinearSearch.h"

#include <gtest/gtest.h>

#include "gap/ThreeRecordings.h"
#include "gap/inference/WindowReplayer.h"

namespace plumbline::gap {

TEST(LinearSearch, proposesASetForEachNumberOfCausesWithTheValuesOfTheOtherGroups) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOf(arm, "coulomb_friction", "shoulder", 0.15)}, 3));
  WindowReplayer replayer(arm, groups, 1);
  std::vector<double> shares;
  LinearSearchOptions options;
  options.mostCauses = 3;
  options.progress = [&](double share) { shares.push_back(share); };
  const std::vector<SetProposal> proposals = proposedSets(replayer, options);
  ASSERT_GE(proposals.size(), 2U);
  EXPECT_LE(proposals.size(), 4U);
  EXPECT_TRUE(proposals[0].set.causes().empty());
  const SetProposal& one = proposals[1];
  ASSERT_EQ(one.set.causes().size(), 1U);
  EXPECT_EQ(one.set.causes()[0].effect->id, std::string("coulomb_friction"));
  EXPECT_NEAR(one.set.causes()[0].value, 0.15, 0.01);
  ASSERT_EQ(one.set.without.size(), 3U);
  for (const Explanation& without : one.set.without) EXPECT_NEAR(without[0].value, 0.15, 0.02);
  ASSERT_EQ(one.lessOne.size(), 1U);
  EXPECT_TRUE(one.lessOne[0].causes().empty());
  EXPECT_GT(one.set.score(), one.lessOne[0].score());
  ASSERT_FALSE(shares.empty());
  EXPECT_EQ(shares.back(), 1);
}

TEST(LinearSearch, goesOnWithoutCausesThatReplaysShowNothingOf) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOf(arm, "coulomb_friction", "shoulder", 0.15)}, 3));
  WindowReplayer replayer(arm, groups, 1);
  LinearSearchOptions options;
  options.mostCauses = 3;
  // Says it of everything but the friction that is there.
  options.idleCauses = [](const Explanation& causes) {
    std::vector<std::size_t> idle;
    for (std::size_t i = 0; i < causes.size(); ++i)
      if (causes[i].effect->id != std::string("coulomb_friction")) idle.push_back(i);
    return idle;
  };
  const std::vector<SetProposal> proposals = proposedSets(replayer, options);
  ASSERT_GE(proposals.size(), 2U);
  for (std::size_t i = 1; i < proposals.size(); ++i) {
    ASSERT_EQ(proposals[i].set.causes().size(), 1U);
    EXPECT_EQ(proposals[i].set.causes()[0].effect->id, std::string("coulomb_friction"));
    EXPECT_NEAR(proposals[i].set.causes()[0].value, 0.15, 0.01);
    EXPECT_EQ(proposals[i].lessOne.size(), 1U);
  }
}

}  // namespace plumbline::gap
