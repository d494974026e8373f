#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "gap/LegOnItsFoot.h"
#include "gap/ThreeRecordings.h"
#include "gap/answer/Answer.h"
#include "gap/inference/AllJointFit.h"
#include "gap/inference/InferenceMark.h"
#include "gap/inference/InferenceMemory.h"
#include "gap/inference/LeftJson.h"

namespace plumbline::gap {
namespace {

/// A diagnosis that ends at once when so many parts are stored, as a kill would end it.
struct InferenceKilled {};

class InferenceResumeTest : public ::testing::Test {
protected:
  InferenceResumeTest() { std::filesystem::remove(path); }
  ~InferenceResumeTest() override { std::filesystem::remove(path); }

  /// All that the answer holds, numbers to the last bit. most: it is killed when it has stored so many parts;
  /// 0: never.
  std::string answer(const std::vector<Trial>& trials, std::size_t most, std::size_t* parts = nullptr) const {
    InferenceOptions options;
    options.mostCauses = 2;
    InferenceMemory memory(path, markOf(robot, trials, options), robot);
    options.memory = &memory;
    options.progress = [&](const std::string&, double) {
      if (most > 0 && memory.size() >= most) throw InferenceKilled();
    };
    const Inference found = infer(robot, trials, options);
    AllJointFit further;
    if (found.diagnosis.verdict == Verdict::unknown)
      further = fitOfAllJoints(robot, trials, found.diagnosis.explanation(), found.foundWithout,
                               found.leftOut, options);
    if (parts) *parts = memory.size();
    return textOf(found) + textOf(further);
  }

  static std::string textOf(const Explanation& causes) {
    nlohmann::json j = nlohmann::json::array();
    for (const Cause& cause : causes) j.push_back({describe(cause), cause.value, cause.variant});
    return j.dump() + "\n";
  }
  static std::string textOf(const std::vector<RecordingLeft>& left) {
    nlohmann::json j = nlohmann::json::array();
    for (const RecordingLeft& of : left) j.push_back(leftJson(of));
    return j.dump() + "\n";
  }
  static std::string textOf(const Inference& found) {
    std::string text = found.sentence() + " " + std::to_string(found.replays) + " replays\n";
    for (const Finding& finding : found.diagnosis.findings) {
      nlohmann::json rivals = nlohmann::json::array();
      for (const Rival& rival : finding.rivals) rivals.push_back({describe(rival.cause), rival.probability});
      text +=
          textOf(Explanation{finding.cause}) +
          nlohmann::json{
              finding.lower,     finding.upper, finding.probability, finding.closedAlone, finding.closedLast,
              *finding.evidence, rivals}
              .dump() +
          "\n";
    }
    text += textOf(found.diagnosis.jointValues);
    for (const Explanation& causes : found.foundWithout) text += textOf(causes);
    return text + nlohmann::json{found.claim.closed, found.claim.lower, found.claim.upper}.dump() +
           textOf(found.leftOut);
  }
  static std::string textOf(const AllJointFit& further) {
    return textOf(further.model) + textOf(further.leftOut) + nlohmann::json(further.closed).dump();
  }

  /// Killed at each part in turn, or at some of them, and gone on with every time.
  void expectTheSameAfterKills(const std::vector<Trial>& trials, std::size_t leastParts,
                               std::size_t step = 1) {
    std::size_t parts = 0;
    const std::string whole = answer(trials, 0, &parts);
    EXPECT_EQ(parts, leastParts) << whole;
    std::filesystem::remove(path);
    for (std::size_t n = 1; n <= parts; n += step) {
      try {
        answer(trials, n);
      } catch (const InferenceKilled&) {
      }
      InferenceOptions options;
      options.mostCauses = 2;
      EXPECT_EQ(InferenceMemory(path, markOf(robot, trials, options), robot).size(), n);
    }
    EXPECT_EQ(answer(trials, 0), whole);
  }

  Mechanism robot = twoJointArm();
  const std::string path = ::testing::TempDir() + "plumbline-inference-resume";
};

TEST_F(InferenceResumeTest, withACauseThatExplainsAll) {
  // With all recordings and without each of the three.
  expectTheSameAfterKills(recordings({causeOfArm("coulomb_friction", "elbow", 0.15)}, 3), 4);
}

TEST_F(InferenceResumeTest, withMoreMissingThanIsNamed) {
  // The same again for values in each joint, and for all values of all joints.
  expectTheSameAfterKills(
      recordings(
          {causeOfArm("coulomb_friction", "elbow", 0.15), causeOfArm("viscous_friction", "shoulder", 0.2),
           causeOfArm("servo_gain", "shoulder", 0.7), causeOfArm("backlash", "elbow", 0.05)},
          3),
      12);
}

TEST_F(InferenceResumeTest, withOneRecordingThatIsCutIntoStretches) {
  std::vector<Trial> one = recordings({causeOfArm("viscous_friction", "shoulder", 0.2)}, 4);
  one.resize(1);
  expectTheSameAfterKills(one, 5);
}

TEST_F(InferenceResumeTest, withLostCommandsThatAnotherCauseHides) {
  // A quick search finds the delay. Then the losses are decoded and searched with, until they stay: three
  // searches. At last without each motion.
  const std::size_t step = std::getenv("PLUMBLINE_SLOW") ? 1 : 3;  // each repeats what is decoded
  expectTheSameAfterKills(recordingsWithLosses({causeOfArm("command_delay", "*", 0.03)}, 3), 6, step);
}

TEST_F(InferenceResumeTest, withRecordingsHungUpAndOnTheFoot) {
  // Of the three hung up: with all and without each. Then one more for the foot.
  robot = legOnItsFoot();
  expectTheSameAfterKills(
      legRecordings({causeOf(robot, "coulomb_friction", "knee", 0.15), groundSlope(0.03)}, 2), 5);
}

}  // namespace
}  // namespace plumbline::gap
