// Short searches; longer ones are in tests/diagnosis.
#include "gap/inference/Inference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

TEST(Inference, theCauseWithTheMostEvidenceStandsFirst) {
  std::vector<Finding> findings(3);
  const double evidence[] = {12, 300, 40};
  for (std::size_t i = 0; i < 3; ++i) findings[i].evidence = evidence[i];
  findings[0].probability = 1;
  sortByEvidence(findings);
  EXPECT_EQ(findings[0].evidence, 300);
  EXPECT_EQ(findings[1].evidence, 40);
  EXPECT_EQ(findings[2].evidence, 12);
}

TEST(Inference, nothingIsFoundWhereNothingIs) {
  std::vector<Trial> trials = recordings({});
  trials[1].unused = {"temperature.* is not used: no model here predicts it"};
  const Inference found = infer(twoJointArm(), trials, {});
  ASSERT_EQ(found.notUsed.size(), 1u);
  EXPECT_EQ(found.notUsed[0], "temperature.* is not used: no model here predicts it");
  EXPECT_EQ(found.diagnosis.verdict, Verdict::none);
  EXPECT_TRUE(found.diagnosis.findings.empty());
}

TEST(Inference, whereRepeatsDifferTheVerdictIsNotNone) {
  // Two recordings of one motion in which different commands were lost: the shoulder was elsewhere by up to
  // 20 mrad, and no model of the robot can say where.
  std::vector<Trial> trials = recordings({});
  trials.push_back(trials[0]);
  trials[3].recording = trials[3].name = "again";
  for (std::size_t k = 0; k < trials[3].cycles(); ++k) {
    trials[0].signals[0].values[k] += 0.01 * std::sin(0.11 * static_cast<double>(k));
    trials[3].signals[0].values[k] -= 0.01 * std::sin(0.11 * static_cast<double>(k));
  }
  const Inference found = infer(twoJointArm(), trials, {});
  EXPECT_TRUE(found.diagnosis.findings.empty());
  EXPECT_EQ(found.diagnosis.verdict, Verdict::unknown);
  EXPECT_EQ(found.repeatsSignal, "pos.shoulder");
  EXPECT_GT(found.repeatsDiffer, 5);
}

TEST(Inference, saysWhatIsLeftHungUpAndOnTheFeet) {
  Inference found;
  found.diagnosis.verdict = Verdict::effect;
  found.diagnosis.findings.emplace_back().cause = causeOfArm("coulomb_friction", "elbow", 0.15);
  found.diagnosis.findings[0].probability = 0.98;
  const std::string cause =
      "Missing from the model: coulomb_friction at elbow = 0.15 N m (98 %); what is left is within ";
  EXPECT_EQ(found.sentence().find(cause + "the noise. "), 0U) << found.sentence();
  found.bound = leastUnexplainedOnFeet;
  found.diagnosis.worstAfter = 2;
  EXPECT_EQ(found.sentence().find(cause + "what engines differ by on the feet. "), 0U) << found.sentence();
}

TEST(Inference, saysWhatChangesFromRunToRun) {
  Inference found;
  found.diagnosis.verdict = Verdict::unknown;
  found.repeatsDiffer = 16.6;
  found.repeatsSignal = "pos.elbow";
  EXPECT_EQ(
      found.sentence(),
      "The nominal model explains these runs only as far as repeats of one motion agree, and those differ by "
      "16.6 times the readings' noise in pos.elbow.");
  EXPECT_EQ(
      found.runToRun(),
      "Something changes from run to run: repeats of one motion differ by 16.6 times the readings' noise in "
      "pos.elbow. No lost commands were found that explain it; "
      "what is "
      "missing within that is not seen.");
  found.lost.seen = {100};
  found.lost.found = {10};
  EXPECT_NE(found.runToRun().find(". Lost commands explain a part of it; what is missing"),
            std::string::npos);
  found.repeatsDiffer = 0.9;
  EXPECT_EQ(found.runToRun(), "");
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
