#include "gap/diagnosis/Diagnosis.h"

#include <gtest/gtest.h>

#include <array>

#include "gap/TwoJointArm.h"
#include "gap/diagnosis/CauseSearch.h"

namespace plumbline::gap {
namespace {

constexpr double noise = 5e-4;

/// The reality takes other, finer steps.
Trial madeOf(const Plant& reality, const Trial& trial, std::uint64_t seed) {
  ReplayOptions fineSteps;
  fineSteps.step = fineSteps.gearStep = 0.0003;
  return recorded(reality, trial, noise, seed, fineSteps);
}

Diagnosis diagnosisOf(const std::vector<Trial>& trials) {
  static const Mechanism arm = twoJointArm();
  const Evidence evidence(trials);
  Evaluator fine(arm, evidence);
  Evaluator coarse(arm, evidence, coarseSteps());
  return diagnose(fine, coarse, {});
}

/// Diagnoses two recordings of the arm with a cause in it.
Diagnosis diagnosisOf(const std::function<void(Plant&)>& change, double size = 0.5) {
  const Mechanism arm = twoJointArm();
  Plant reality = nominalPlant(arm);
  change(reality);
  std::vector<Trial> trials;
  for (const std::uint64_t seed : {11, 12}) trials.push_back(madeOf(reality, armTrial(arm, 6, size), seed));
  return diagnosisOf(trials);
}

void expectCause(const Diagnosis& diagnosis, std::string_view id, std::string_view at, double value,
                 double tolerance) {
  EXPECT_EQ(diagnosis.verdict, Verdict::effect);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].cause.effect->id, id);
  EXPECT_EQ(diagnosis.findings[0].cause.place.at, at);
  EXPECT_NEAR(diagnosis.findings[0].cause.value, value, tolerance);
  EXPECT_GT(diagnosis.findings[0].probability, 0.8);
  EXPECT_GT(diagnosis.gap.closed(), 0.9);
}

TEST(DiagnosisTest, nothingIsMissing) {
  const Diagnosis diagnosis = diagnosisOf([](Plant&) {});
  EXPECT_EQ(diagnosis.verdict, Verdict::none);
  EXPECT_TRUE(diagnosis.findings.empty());
  EXPECT_LT(diagnosis.worstBefore, 0.9);
}

TEST(DiagnosisTest, whatTheStepsOfAnotherEngineLeadByIsNotMissing) {
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials;
  for (const std::uint64_t seed : {11, 12}) {
    const Trial asked = armTrial(arm, 6, 1.5);
    Trial trial = recorded(nominalPlant(arm), asked, 2e-5, seed);
    const Prediction clean = replay(nominalPlant(arm), asked);
    for (std::size_t s = 0; s < trial.signals.size(); ++s)
      for (std::size_t k = 1; k < trial.cycles(); ++k)
        trial.signals[s].values[k] += 1.4e-4 * 100 * (clean.values[s][k] - clean.values[s][k - 1]);
    trials.push_back(std::move(trial));
  }
  const Diagnosis diagnosis = diagnosisOf(trials);
  EXPECT_EQ(diagnosis.verdict, Verdict::none);
  EXPECT_LT(diagnosis.worstBefore, 0.9);
}

TEST(DiagnosisTest, dryFriction) {
  expectCause(diagnosisOf([](Plant& plant) { plant.joints[1].coulomb = 0.08; }), "coulomb_friction", "elbow",
              0.08, 0.004);
}

TEST(DiagnosisTest, softServo) {
  expectCause(diagnosisOf([](Plant& plant) { plant.joints[0].servo.kp *= 0.8; }), "servo_gain", "shoulder",
              0.8, 0.01);
}

TEST(DiagnosisTest, servosOfOneTypeThatAreAllSofter) {
  expectCause(diagnosisOf([](Plant& plant) {
                for (auto& joint : plant.joints) joint.servo.kp *= 0.6;
              }),
              "servo_gain", "*", 0.6, 0.01);
}

/// One recording per limit of the servos' own profile (0: none), named after the days.
std::vector<Trial> limited(const std::vector<double>& limits, bool stillShoulder = false) {
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials;
  for (const double limit : limits) {
    Plant reality = nominalPlant(arm);
    for (auto& joint : reality.joints) joint.accelerationLimit = limit;
    static const std::array days = {"monday", "tuesday"};
    Trial trial = armTrial(arm, 3, 0.5 - 0.05 * static_cast<double>(trials.size()));
    if (stillShoulder) std::ranges::fill(trial.command[0], 0.1);
    trial.recording = days.at(trials.size());
    trial.motion += trial.recording;
    trials.push_back(madeOf(reality, trial, 11 + trials.size()));
  }
  return trials;
}

TEST(DiagnosisTest, whatIsSetInOneServoIsSetInAllUnlessTheDataSpeakAgainstIt) {
  const Diagnosis diagnosis = diagnosisOf(limited({30, 30}, true));
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(describe(diagnosis.findings[0].cause), "acceleration_limit at * = 30 rad/s^2");
  ASSERT_EQ(diagnosis.findings[0].rivals.size(), 1u) << "a shoulder that stands still does not tell";
  EXPECT_EQ(diagnosis.findings[0].rivals[0].cause.place.at, "elbow");
  expectCause(diagnosisOf([](Plant& plant) { plant.joints[1].accelerationLimit = 30; }), "acceleration_limit",
              "elbow", 30, 0.5);
}

TEST(DiagnosisTest, aLimitThatWasNotSetInOneRecording) {
  const Diagnosis diagnosis = diagnosisOf(limited({30, 0}));
  expectCause(diagnosis, "acceleration_limit", "*", 30, 0.5);
  ASSERT_FALSE(diagnosis.findings.empty());
  EXPECT_EQ(diagnosis.findings[0].cause.inactiveIn, std::vector<std::string>{"tuesday"});
}

TEST(DiagnosisTest, aGearAsSoftAsASpring) {
  expectCause(diagnosisOf([](Plant& plant) { plant.joints[1].compliance = 0.25; }), "joint_compliance",
              "elbow", 0.25, 0.01);
}

TEST(DiagnosisTest, aLinkThatSwingsInWidePlay) {
  expectCause(diagnosisOf([](Plant& plant) {
                plant.joints[1].backlash = 0.18;
                plant.joints[1].toothStiffness = 3000;
                plant.joints[1].toothDamping = 0.8;
              }),
              "backlash", "elbow", 0.18, 0.02);
}

TEST(DiagnosisTest, aHeavierLink) {
  expectCause(diagnosisOf([](Plant& plant) { plant.mechanism.links[2].mass += 0.05; }, 0.25), "link_mass",
              "lower", 0.05, 0.004);
}

TEST(DiagnosisTest, lateCommands) {
  expectCause(diagnosisOf([](Plant& plant) {
                for (auto& joint : plant.joints) joint.commandDelay = 0.008;
              }),
              "command_delay", "*", 0.008, 0.0004);
}

TEST(DiagnosisTest, whatTheLibraryDoesNotHaveIsUnknown) {
  // A spring that pulls the elbow to one place, and grows with the cube: no effect of the library does that
  // alone.
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials;
  for (const std::uint64_t seed : {21, 22}) {
    Trial trial = recorded(nominalPlant(arm), armTrial(arm, 4), noise, seed);
    for (std::size_t k = 0; k < trial.cycles(); ++k)
      trial.signals[1].values[k] += 0.006 * std::sin(23 * trial.command[1][k]);
    trials.push_back(std::move(trial));
  }
  const Evidence evidence(trials);
  Evaluator fine(arm, evidence), coarse(arm, evidence);
  const Diagnosis diagnosis = diagnose(fine, coarse, {});
  EXPECT_EQ(diagnosis.verdict, Verdict::unknown);
  EXPECT_LT(diagnosis.knownProbability, 0.2);
}

/// Two recordings of the arm on a base that is fixed and carries an accelerometer, which reads `acceleration`
/// on average, with noise of 0.06 m/s^2.
Diagnosis withAccelerometer(const Vec3& acceleration) {
  static Mechanism arm = twoJointArm();
  arm.hasImu = true;
  std::vector<Trial> trials;
  for (const std::uint64_t seed : {31, 32}) {
    Trial trial = recorded(nominalPlant(arm), armTrial(arm, 4), noise, seed);
    Random random(seed + 10);
    for (int axis = 0; axis < 3; ++axis) {
      Signal signal;
      signal.name = std::string("acc.") + "xyz"[axis];
      signal.kind = SignalKind::accelerometer;
      signal.axis = axis;
      for (std::size_t k = 0; k < trial.cycles(); ++k)
        signal.values.push_back(acceleration[axis] + 0.06 * random.gaussian());
      trial.signals.push_back(std::move(signal));
    }
    trials.push_back(std::move(trial));
  }
  const Evidence evidence(trials);
  Evaluator fine(arm, evidence), coarse(arm, evidence);
  return diagnose(fine, coarse, {});
}

TEST(DiagnosisTest, aTurnedAccelerometerStillReadsGravity) {
  const Diagnosis diagnosis = withAccelerometer(9.81 * Vec3(std::sin(0.08), 0, std::cos(0.08)));
  EXPECT_EQ(diagnosis.verdict, Verdict::effect);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].cause.effect->id, "imu_misalignment");
  EXPECT_NEAR(std::abs(diagnosis.findings[0].cause.value), 0.08, 0.001);
  EXPECT_EQ(diagnosis.sensorOff, "");
}

TEST(DiagnosisTest, anAccelerometerWithABiasIsNotTurned) {
  const Diagnosis diagnosis = withAccelerometer(9.81 * Vec3(std::sin(0.08), 0, 1));
  EXPECT_EQ(diagnosis.verdict, Verdict::unknown);
  EXPECT_EQ(diagnosis.sensorOff, "acc.z");
  EXPECT_NEAR(diagnosis.sensorOffBy, 9.81 * (1 - std::cos(0.08)) / 0.06, 0.1);
}

}  // namespace
}  // namespace plumbline::gap
