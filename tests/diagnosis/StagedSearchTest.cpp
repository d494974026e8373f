// Searches in two stages: a leg that was hung up and stood on its foot.
#include "gap/inference/StagedSearch.h"

#include <gtest/gtest.h>

#include "gap/LegOnItsFoot.h"

namespace plumbline::gap {

TEST(StagedSearch, hungRecordingsSayWhatTheyCanAndTheFeetTheRest) {
  const Mechanism leg = legOnItsFoot();
  const Cause friction = causeOf(leg, "coulomb_friction", "knee", 0.15);
  const Cause slope = groundSlope(0.03);
  const Inference found = infer(leg, legRecordings({friction, slope}), {});
  ASSERT_EQ(found.diagnosis.findings.size(), 2U);
  for (const Finding& finding : found.diagnosis.findings) {
    const Cause& right = finding.cause.effect == friction.effect ? friction : slope;
    EXPECT_TRUE(finding.cause.sameKind(right)) << describe(finding.cause);
    EXPECT_NEAR(finding.cause.value, right.value, 0.1 * right.value);
    EXPECT_LE(finding.lower, right.value);
    EXPECT_GE(finding.upper, right.value);
    EXPECT_GT(finding.probability, 0.5);
  }
  EXPECT_EQ(found.diagnosis.verdict, Verdict::effect);
  ASSERT_EQ(found.foundWithout.size(), 5U);
  ASSERT_EQ(found.leftOut.size(), 5U);
  // Each hung recording is closed by the friction alone, each on the foot by both.
  for (const RecordingLeft& left : found.leftOut) EXPECT_GT(left.closedToNoise(), 0.8) << left.folder;
}

TEST(StagedSearch, nothingIsFoundOnTheFootWhereNothingIs) {
  const Inference found = infer(legOnItsFoot(), legRecordings({}), {});
  EXPECT_TRUE(found.diagnosis.findings.empty());
  EXPECT_EQ(found.diagnosis.verdict, Verdict::none);
}

TEST(StagedSearch, oneHungRecordingIsNotKnownWithoutItself) {
  std::vector<Trial> trials = legRecordings({causeOf(legOnItsFoot(), "coulomb_friction", "knee", 0.15)});
  trials.erase(trials.begin(), trials.begin() + 2);
  const Inference found = infer(legOnItsFoot(), std::move(trials), {});
  ASSERT_EQ(found.foundWithout.size(), 3U);
  EXPECT_TRUE(found.foundWithout[0].empty());
  EXPECT_EQ(found.foundWithout[1].size(), 1U);
}

}  // namespace plumbline::gap
