#include "gap/diagnosis/DiagnosisAttempts.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "framework/StopSignal.h"
#include "gap/TwoJointArm.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;

class DiagnosisAttemptsTest : public ::testing::Test {
protected:
  DiagnosisAttemptsTest() { removeFiles(); }
  ~DiagnosisAttemptsTest() override { removeFiles(); }

  void removeFiles() const {
    fs::remove(file);
    fs::remove(file + "2");
  }

  /// An arm with more friction than its model, recorded twice, which loses a share of its commands.
  static std::vector<Trial> trialsWith(double lostShare) {
    Plant plant = nominalPlant(twoJointArm());
    for (JointPlant& joint : plant.joints) joint.viscous += 1;
    return recordedTwice(plant, noise, lostShare);
  }

  static constexpr double noise = 5e-4;
  const Mechanism arm = twoJointArm();
  const std::string file = ::testing::TempDir() + "plumbline-attempts";
};

TEST_F(DiagnosisAttemptsTest, oneIsEnoughWhereRepeatsDifferByNoise) {
  DiagnosisAttempts attempts(arm, {}, file, {});
  const Diagnosis diagnosis = attempts.run(trialsWith(0));
  ASSERT_EQ(diagnosis.verdict, Verdict::effect);
  EXPECT_EQ(diagnosis.findings.front().cause.effect->id, "viscous_friction");
  EXPECT_TRUE(fs::exists(file));
  EXPECT_FALSE(fs::exists(file + "2"));
  attempts.forget();
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(DiagnosisAttemptsTest, theSecondFindsLostCommandsWithWhatTheFirstFound) {
  const std::vector<Trial> trials = trialsWith(0.1);
  const Evidence byRepeats(trials);
  DiagnosisAttempts attempts(arm, {}, file, {});
  const Diagnosis diagnosis = attempts.run(trials);
  EXPECT_TRUE(fs::exists(file + "2"));
  bool lost = false;
  for (const Finding& finding : diagnosis.findings)
    lost |= std::string(finding.cause.effect->id) == "command_dropout";
  EXPECT_TRUE(lost) << "not named among " << diagnosis.findings.size();
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_GT(byRepeats.noise(0, s).sigma, 5 * noise) << s;
    EXPECT_LT(attempts.evaluator().evidence().noise(0, s).sigma, 1.8 * noise) << s;
  }
  attempts.forget();
  EXPECT_FALSE(fs::exists(file));
  EXPECT_FALSE(fs::exists(file + "2"));
}

TEST_F(DiagnosisAttemptsTest, whoStopsOneLearnsWhereItGoesOn) {
  const std::vector<Trial> trials = trialsWith(0);
  std::vector<std::string> resumed;
  DiagnosisOptions options;
  options.progress = [&](const std::string&, double) {
    if (fs::exists(file)) throw Stopped();
  };
  const auto stoppedWith = [&] {
    try {
      DiagnosisAttempts(arm, options, file, {[&](const std::string& text) { resumed.push_back(text); }, {}})
          .run(trials);
    } catch (const Stopped& stopped) {
      return stopped.what();
    }
    return std::string("not stopped");
  };
  EXPECT_EQ(stoppedWith(), "stopped; the same command continues from " + file);
  EXPECT_TRUE(resumed.empty());
  options.progress = {};
  EXPECT_EQ(stoppedWith(), "not stopped");
  ASSERT_EQ(resumed.size(), 1u);
  EXPECT_EQ(resumed.front(), "continues from " + file + " (1 searches done)");
}

}  // namespace
}  // namespace plumbline::gap
