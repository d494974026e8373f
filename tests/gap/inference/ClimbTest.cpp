#include "gap/inference/Climb.h"

#include <gtest/gtest.h>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

class Climb : public testing::Test {
protected:
  Explanation climbedFrom(const Explanation& start) const {
    return climbed({replayer_, nullptr, &replayer_}, start, 100).causes();
  }

  const Mechanism arm_ = twoJointArm();
  const Groups groups_{recordings({causeOfArm("servo_gain", "elbow", 0.7)}, 2)};
  const Replayer replayer_{arm_, groups_, 1};
};

TEST_F(Climb, valuesBecomeThoseOfTheRobot) {
  const Explanation causes = climbedFrom({causeOfArm("servo_gain", "elbow", 0.9)});
  ASSERT_EQ(causes.size(), 1U);
  EXPECT_NEAR(causes[0].value, 0.7, 0.01);
}

TEST_F(Climb, whatTheRobotDoesNotHaveGoesOut) {
  const Explanation causes =
      climbedFrom({causeOfArm("coulomb_friction", "shoulder", 0.05), causeOfArm("servo_gain", "elbow", 0.8),
                   causeOfArm("viscous_friction", "shoulder", 0.02)});
  ASSERT_EQ(causes.size(), 1U);
  EXPECT_EQ(causes[0].effect->id, "servo_gain");
  EXPECT_NEAR(causes[0].value, 0.7, 0.01);
}

TEST_F(Climb, ofARobotLikeItsModelNothingIsLeft) {
  const Groups groups(recordings({}, 2));
  const Replayer replayer(arm_, groups, 1);
  const Explanation start{causeOfArm("coulomb_friction", "elbow", 0.05),
                          causeOfArm("servo_gain", "elbow", 0.99)};
  EXPECT_TRUE(climbed({replayer, nullptr, &replayer}, start, 100).causes().empty());
  EXPECT_TRUE(climbed({replayer, nullptr, &replayer}, {}, 100).causes().empty());
}

TEST_F(Climb, theCauseNeededLeastIsTheOneThatExplainsLeast) {
  const Explanation causes{causeOfArm("servo_gain", "elbow", 0.7),
                           causeOfArm("coulomb_friction", "shoulder", 1e-3)};
  const Shares shares = sharesOf(groups_, replayer_.residuals(causes));
  EXPECT_EQ(leastNeeded(replayer_, score(replayer_, shares, causes, 100, 0)), 1U);
}

TEST_F(Climb, aSetWithoutEachOfItsCausesHasTheOthersFittedAnew) {
  const Explanation causes{causeOfArm("servo_gain", "elbow", 0.8),
                           causeOfArm("coulomb_friction", "shoulder", 0.05)};
  const Shares shares = sharesOf(groups_, replayer_.residuals(causes));
  const SetProposal of = withLessOne(replayer_, score(replayer_, shares, causes, 100, 0), 100);
  EXPECT_EQ(of.set.causes().size(), 2U);
  ASSERT_EQ(of.lessOne.size(), 2U);
  EXPECT_EQ(of.lessOne[0].causes()[0].effect->id, "coulomb_friction");
  EXPECT_NEAR(of.lessOne[1].causes()[0].value, 0.7, 0.01);
}

TEST_F(Climb, causesThatDoNothingAreIdle) {
  const Explanation causes{causeOfArm("servo_gain", "shoulder", 1), causeOfArm("servo_gain", "elbow", 0.7),
                           causeOfArm("coulomb_friction", "shoulder", 1e-5)};
  EXPECT_EQ(idleCauses(replayer_, causes), (std::vector<std::size_t>{0, 2}));
}

}  // namespace plumbline::gap
