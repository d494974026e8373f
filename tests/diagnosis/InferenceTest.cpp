// Whole searches for sets of causes in recordings of the two-joint arm whose truth is known.
#include "gap/inference/Inference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gap/DutyTrial.h"
#include "gap/ThreeRecordings.h"
#include "gap/inference/LeaveOut.h"

namespace plumbline::gap {

TEST(LeaveOut, theSetIsChosenWithoutTheGroup) {
  // A cause that one recording alone has: what is found without that one does not hold it.
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials = recordings({});
  trials[1] = recordings({causeOfArm("coulomb_friction", "elbow", 0.2)})[1];
  const Groups groups(trials);
  const Replayer replayer(arm, groups, 2);
  const std::vector<FoundWithout> found = findWithoutEach({replayer}, {});
  ASSERT_EQ(found.size(), 3);
  EXPECT_TRUE(found[1].causes.empty());
  EXPECT_NEAR(leftWithout(groups, found)[1].closed(), 0, 1e-9);
}

TEST(Inference, findsTheCauseAndClaimsWhatItCloses) {
  const Mechanism arm = twoJointArm();
  const Inference found = infer(arm, recordings({causeOfArm("coulomb_friction", "elbow", 0.15)}), {});
  ASSERT_EQ(found.diagnosis.findings.size(), 1);
  const Finding& finding = found.diagnosis.findings.front();
  EXPECT_EQ(finding.cause.effect->id, "coulomb_friction");
  EXPECT_EQ(finding.cause.place.at, "elbow");
  EXPECT_LE(finding.lower, 0.15);
  EXPECT_GE(finding.upper, 0.15);
  EXPECT_GT(finding.probability, 0.5);
  EXPECT_EQ(found.diagnosis.verdict, Verdict::effect);
  ASSERT_EQ(found.leftOut.size(), 3);
  const double measured =
      meanClosed({leftIn(recordings({causeOfArm("coulomb_friction", "elbow", 0.15)}, 5)[1],
                         {{0, found.diagnosis.explanation()}})});
  EXPECT_NEAR(meanClosed(found.leftOut), measured, 0.1);
}

TEST(Inference, aFilterOfCommandsIsNoDelayAndADelayIsNoFilter) {
  const Mechanism arm = twoJointArm();
  for (const char* id : {"command_lag", "command_delay"}) {
    const Inference found = infer(arm, recordings({causeOfArm(id, "elbow", 0.012)}), {});
    ASSERT_EQ(found.diagnosis.findings.size(), 1) << id;
    const Finding& finding = found.diagnosis.findings.front();
    EXPECT_EQ(finding.cause.effect->id, id);
    EXPECT_EQ(finding.cause.place.at, "elbow");
    EXPECT_NEAR(finding.cause.value, 0.012, 0.0012) << id;
    EXPECT_GT(finding.probability, 0.9) << id;
    EXPECT_EQ(found.diagnosis.verdict, Verdict::effect) << id;
  }
}

TEST(Inference, commandsThatTheServoTakesInStepsAreOutsideTheLibrary) {
  // command_resolution of blind sets: neither a dead band nor a play is like it.
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials;
  for (const Trial& asked : recordings({})) {
    Trial taken = asked;
    for (double& command : taken.command[1]) command = std::round(command / 0.03) * 0.03;
    taken = recorded(plantOf(arm, {}), taken, 5e-4, 13 + trials.size());
    taken.command = asked.command;
    trials.push_back(std::move(taken));
  }
  EXPECT_EQ(infer(arm, std::move(trials), {}).diagnosis.verdict, Verdict::unknown);
}

TEST(Inference, aMotorThatIsSentTorquesShowsItsFriction) {
  // Positions were never commanded, so the motions differ in nothing but torques, and are no repeats.
  Mechanism pendulum = findMechanism("xl330_pendulum");
  pendulum.joints[0].servo.followsTorque = true;
  const Plant reality = plantOf(pendulum, {causeOf(pendulum, "coulomb_friction", "pendulum", 0.05)});
  std::vector<Trial> trials;
  for (const double rate : {2.0, 3.1}) {
    Trial trial = armTrial(pendulum, 6, 0);
    trial.commandTorque.resize(1);
    for (const double t : trial.time)
      trial.commandTorque[0].push_back(0.25 * std::sin(rate * t) + 0.1 * std::sin(2.6 * rate * t));
    trial.recording = trial.name = "run" + std::to_string(trials.size());
    trials.push_back(recorded(reality, trial, 5e-4, 3 + trials.size()));
  }
  const Inference found = infer(pendulum, std::move(trials), {});
  ASSERT_EQ(found.diagnosis.findings.size(), 1) << found.sentence();
  EXPECT_EQ(found.diagnosis.findings[0].cause.effect->id, "coulomb_friction");
  EXPECT_NEAR(found.diagnosis.findings[0].cause.value, 0.05, 0.002);
  EXPECT_EQ(found.diagnosis.verdict, Verdict::effect);
}

TEST(Inference, sameAnswerWithAnyNumberOfThreads) {
  const Mechanism arm = twoJointArm();
  const std::vector<Trial> trials = recordings({causeOfArm("backlash", "shoulder", 0.03)}, 3);
  InferenceOptions one, three;
  three.jobs = 3;
  const Inference a = infer(arm, trials, one), b = infer(arm, trials, three);
  EXPECT_EQ(a.diagnosis.explanation(), b.diagnosis.explanation());
  EXPECT_EQ(a.claim.closed, b.claim.closed);
  ASSERT_EQ(a.diagnosis.findings.size(), b.diagnosis.findings.size());
  for (std::size_t i = 0; i < a.diagnosis.findings.size(); ++i)
    EXPECT_EQ(a.diagnosis.findings[i].probability, b.diagnosis.findings[i].probability);
}

TEST(Inference, aGainIsSeparatedFromAFrictionByTheDuty) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const Explanation reality{causeOf(pendulum, "servo_gain", "pendulum", 0.8),
                            causeOf(pendulum, "coulomb_friction", "pendulum", 0.05)};
  const Inference found =
      infer(pendulum, {dutyTrial(reality, 6, 5e-4, 3), dutyTrial(reality, 6, 5e-4, 4, 0.3)}, {});
  const auto& findings = found.diagnosis.findings;
  const auto gain = std::ranges::find_if(
      findings, [](const Finding& finding) { return finding.cause.effect->id == "servo_gain"; });
  ASSERT_NE(gain, findings.end());
  EXPECT_NEAR(gain->cause.value, 0.8, 0.005);
  EXPECT_GT(gain->probability, 0.9);
}

TEST(Inference, commandsThatWereLostAreFoundBesideAnotherCause) {
  const Cause friction = causeOfArm("coulomb_friction", "elbow", 0.15);
  const Inference found = infer(twoJointArm(), recordingsWithLosses({friction}, 6), {});
  EXPECT_EQ(found.diagnosis.verdict, Verdict::effect);
  ASSERT_EQ(found.diagnosis.findings.size(), 2U);
  EXPECT_EQ(found.diagnosis.findings[1].cause.effect->id, "command_dropout");
  EXPECT_NEAR(found.diagnosis.findings[1].cause.value, 0.1, 0.02);
  EXPECT_GT(found.diagnosis.findings[1].probability, 0.99);
  EXPECT_TRUE(found.diagnosis.findings[0].cause.sameKind(friction));
  EXPECT_NEAR(found.diagnosis.findings[0].cause.value, 0.15, 0.005);
  // A forecast knows the mean of what losses do alone.
  ASSERT_EQ(found.leftOut.size(), 3U);
  for (const RecordingLeft& left : found.leftOut) EXPECT_LT(left.closed(), 0.9) << left.folder;
  EXPECT_NE(found.sentence().find(" No model knows which commands will be lost"), std::string::npos);
}

}  // namespace plumbline::gap
