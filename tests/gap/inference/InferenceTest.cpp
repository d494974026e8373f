// Short searches; longer ones are in tests/diagnosis.
#include "gap/inference/Inference.h"

#include <gtest/gtest.h>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

TEST(Inference, theSurestCauseStandsFirstAndOfThoseAsSureWhatClosesMost) {
  std::vector<Finding> findings(3);
  const double probability[] = {0.351, 0.9, 0.349}, closedLast[] = {0.1, 0.05, 0.4};
  for (std::size_t i = 0; i < 3; ++i) {
    findings[i].probability = probability[i];
    findings[i].closedLast = closedLast[i];
  }
  sortByProbability(findings);
  EXPECT_EQ(findings[0].closedLast, 0.05);
  EXPECT_EQ(findings[1].closedLast, 0.4);
  EXPECT_EQ(findings[2].closedLast, 0.1);
}

TEST(Inference, nothingIsFoundWhereNothingIs) {
  const Inference found = infer(twoJointArm(), recordings({}), {});
  EXPECT_EQ(found.diagnosis.verdict, Verdict::none);
  EXPECT_TRUE(found.diagnosis.findings.empty());
}

TEST(Inference, ofShortRecordingsTheSameWithAnyNumberOfThreads) {
  const std::vector<Trial> trials = recordings({causeOfArm("coulomb_friction", "elbow", 0.15)}, 0.6);
  InferenceOptions one, three;
  three.jobs = 3;
  const Inference a = infer(twoJointArm(), trials, one), b = infer(twoJointArm(), trials, three);
  EXPECT_EQ(a.leftOut.size(), 3U);
  EXPECT_EQ(a.diagnosis.explanation(), b.diagnosis.explanation());
  EXPECT_EQ(a.claim.closed, b.claim.closed);
}

}  // namespace plumbline::gap
