#include "gap/inference/SetChoice.h"

#include <gtest/gtest.h>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

namespace {

Scored scored(const Explanation& causes, double score) {
  Scored set;
  set.fitted.causes = causes;
  set.gain = {score};
  return set;
}

}  // namespace

TEST(SetChoice, setsHaveTheSameKindsWhateverTheirOrderAndValues) {
  const Cause gain = causeOfArm("servo_gain", "elbow", 0.7), less = causeOfArm("servo_gain", "elbow", 0.5),
              other = causeOfArm("servo_gain", "shoulder", 0.7),
              friction = causeOfArm("coulomb_friction", "elbow", 0.1);
  EXPECT_TRUE(sameKinds({gain, friction}, {friction, less}));
  EXPECT_FALSE(sameKinds({gain}, {other}));
  EXPECT_FALSE(sameKinds({gain}, {gain, friction}));
  EXPECT_TRUE(sameKinds({}, {}));
}

TEST(SetChoice, theBestIsTheAnswerAndComesWithItsParts) {
  const Cause gain = causeOfArm("servo_gain", "elbow", 0.7),
              friction = causeOfArm("coulomb_friction", "elbow", 0.1);
  const std::vector<SetProposal> answers{
      {scored({}, 0), {}}, {scored({gain, friction}, 9), {scored({friction}, 2), scored({gain}, 5)}}};
  const BeamResult result = chosen(answers, {scored({gain}, 4)}, 50);
  EXPECT_EQ(result.kinds, 50U);
  EXPECT_EQ(result.lessOne.size(), 2U);
  ASSERT_EQ(result.sets.size(), 4U);
  EXPECT_EQ(result.sets[0].causes(), (Explanation{gain, friction}));
  EXPECT_EQ(result.sets[1].score(), 5) << "of two sets with the same causes the better one stays";
  EXPECT_EQ(result.sets[2].causes(), Explanation{friction});
  EXPECT_TRUE(result.sets[3].causes().empty());
}

TEST(SetChoice, proposalsAreScoredByReplays) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOfArm("servo_gain", "elbow", 0.7)}, 1));
  const Replayer replayer(arm, groups, 1);
  Scored set = scored({causeOfArm("servo_gain", "elbow", 0.7)}, -1);
  set.without.assign(groups.count(), set.causes());
  std::vector<SetProposal> answers;
  addScored(replayer, {{set, {}}}, 100, answers);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].set.gain.size(), groups.count());
  EXPECT_GT(answers[0].set.score(), 100);
  EXPECT_DOUBLE_EQ(answers[0].set.price, priceOf(1, 100));
}

}  // namespace plumbline::gap
