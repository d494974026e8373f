// Short searches; longer ones are in tests/diagnosis.
#include "gap/inference/Inference.h"

#include <gtest/gtest.h>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

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
