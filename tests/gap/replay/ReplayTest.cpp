#include "gap/replay/Replay.h"

#include <gtest/gtest.h>

#include "../LegOnItsFoot.h"
#include "gap/effects/Effects.h"

namespace plumbline::gap {
namespace {

double largest(const std::vector<double>& a, const std::vector<double>& b, std::size_t from = 0) {
  double most = 0;
  for (std::size_t k = from; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

TEST(ReplayTest, stepsOfSecondOrder) {
  const Mechanism arm = twoJointArm();
  const Trial trial = armTrial(arm, 6, 0.05);  // small enough to stay below the torque limit
  const Plant plant = nominalPlant(arm);
  const auto at = [&](double step) {
    ReplayOptions options;
    options.step = step;
    return replay(plant, trial, options).values[0];
  };
  const auto exact = at(0.0001);
  const double coarse = largest(at(0.005), exact), fine = largest(at(0.0025), exact);
  EXPECT_LT(fine, 2e-4);
  EXPECT_GT(coarse / fine, 3.5);
}

/// The same motion as a log of so many cycles a second.
Trial loggedAt(double rate, const Trial& trial) {
  Trial log = trial;
  const double end = trial.time.back();
  log.time.clear();
  for (int k = 0; k / rate < end; ++k) log.time.push_back(k / rate);
  const auto sampled = [&](const std::vector<double>& values) {
    std::vector<double> at;
    for (const double t : log.time) {
      const auto k = static_cast<std::size_t>(t / 0.01);
      at.push_back(values[k] + (values[k + 1] - values[k]) * (t / 0.01 - static_cast<double>(k)));
    }
    return at;
  };
  for (std::vector<double>& command : log.command) command = sampled(command);
  for (Signal& signal : log.signals) signal.values = sampled(signal.values);
  return log;
}

TEST(ReplayTest, aLateImuReadsWhatTheTorsoDidWithinACycle) {
  // The same commands, logged once more in each cycle, 4 ms before the next: a sensor that is 4 ms late shows
  // that reading. On a line from cycle to cycle it would be off by what each command jerks the body with.
  Mechanism leg = legOnItsFoot();
  leg.hasImu = true;
  Trial trial = legTrial(true, 3);
  for (const SignalKind kind : {SignalKind::gyro, SignalKind::accelerometer}) {
    Signal& signal = trial.signals.emplace_back();
    signal.kind = kind;
    signal.axis = kind == SignalKind::gyro ? 1 : 0;
    signal.values.assign(trial.cycles(), 0);
  }
  Trial twice = trial;
  const auto doubled = [](const std::vector<double>& values, double shift) {
    std::vector<double> all;
    for (const double value : values) all.insert(all.end(), {value, value + shift});
    return all;
  };
  twice.time = doubled(trial.time, 0.006);
  for (std::vector<double>& command : twice.command) command = doubled(command, 0);
  for (Signal& signal : twice.signals) signal.values = doubled(signal.values, 0);
  Plant late = nominalPlant(leg);
  late.imu.delay = 0.004;
  const Prediction shown = replay(late, trial), within = replay(nominalPlant(leg), twice),
                   onTime = replay(nominalPlant(leg), trial);
  double offLine = 0;
  for (std::size_t k = 1; k < trial.cycles(); ++k) {
    EXPECT_NEAR(shown.values[2][k], within.values[2][2 * k - 1], 1e-9);
    EXPECT_NEAR(shown.values[3][k], within.values[3][2 * k - 1], 1e-9);
    const double line = 0.4 * onTime.values[3][k - 1] + 0.6 * onTime.values[3][k];
    offLine = std::max(offLine, std::abs(shown.values[3][k] - line));
  }
  EXPECT_GT(offLine, 0.1);  // [m/s^2]
}

TEST(ReplayTest, aStepSpansTheCyclesOfALogThatIsFaster) {
  const Mechanism arm = twoJointArm();
  const Trial trial = loggedAt(1000, armTrial(arm, 3, 0.2));
  Plant plant = nominalPlant(arm);
  plant.joints[0].coulomb = 0.05;
  plant.joints[1].commandDelay = 0.0035;
  const auto at = [&](double step) {
    ReplayOptions options;
    options.step = step;
    return replay(plant, trial, options).values;
  };
  const auto exact = at(0.0002), each = at(0.001), two = at(0.002);
  EXPECT_NE(two, each);
  for (std::size_t s = 0; s < 2; ++s) {
    for (const double value : two[s]) ASSERT_TRUE(std::isfinite(value));
    EXPECT_LT(largest(two[s], exact[s]), 1e-3);
  }
  // Steps of one cycle where they are as long, or where the log is slower.
  EXPECT_EQ(at(0.0015), each);
}

TEST(ReplayTest, longStepsNeedNotEndWithCycles) {
  const Mechanism arm = twoJointArm();
  const Trial trial = loggedAt(200, armTrial(arm, 3, 0.2));
  const Plant plant = nominalPlant(arm);
  ReplayOptions within = withLongSteps();
  within.acrossCycles = false;
  ReplayOptions fine;
  fine.step = 0.0002;
  const auto exact = replay(plant, trial, fine).values, across = replay(plant, trial, withLongSteps()).values,
             shorter = replay(plant, trial, within).values;
  for (std::size_t s = 0; s < 2; ++s) {
    for (const double value : across[s]) ASSERT_TRUE(std::isfinite(value));
    EXPECT_LT(largest(across[s], exact[s]), 4e-3);
    EXPECT_NE(across[s], shorter[s]);
  }
  // Where the body is read, and where efforts are, steps end with each cycle.
  Trial other = trial;
  other.signals[1].kind = SignalKind::torque;
  EXPECT_EQ(replay(plant, other, withLongSteps()).values[0], replay(plant, other, within).values[0]);
  other = trial;
  other.signals[1].joint = -1;
  other.signals[1].kind = SignalKind::gyro;
  EXPECT_EQ(replay(plant, other, withLongSteps()).values[0], replay(plant, other, within).values[0]);
}

TEST(ReplayTest, aTorqueOfAngleAndSpeedActsOnTheLink) {
  const Mechanism arm = twoJointArm();
  const Trial trial = armTrial(arm, 3);
  Plant biased = nominalPlant(arm), pushed = biased;
  biased.joints[1].biasForce = 0.2;
  pushed.joints[1].torques = {[](double, double) { return 0.15; }, [](double, double) { return 0.05; }};
  const auto byBias = replay(biased, trial).values, byTorques = replay(pushed, trial).values;
  for (std::size_t s = 0; s < byBias.size(); ++s) EXPECT_LT(largest(byBias[s], byTorques[s]), 1e-12);
  // Of the angle, a spring; of the speed, what viscous friction does.
  Plant sprung = nominalPlant(arm), damped = sprung;
  sprung.joints[0].torques = {[](double angle, double) { return -2 * angle; }};
  damped.joints[0].torques = {[](double, double speed) { return -0.2 * speed; }};
  Plant viscous = nominalPlant(arm);
  viscous.joints[0].viscous = 0.2;
  EXPECT_GT(largest(replay(sprung, trial).values[0], replay(nominalPlant(arm), trial).values[0]), 0.01);
  EXPECT_LT(largest(replay(damped, trial).values[0], replay(viscous, trial).values[0]), 0.002);
}

TEST(ReplayTest, aHeldPoseSagsByTorqueOverGain) {
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 3);
  for (auto& command : trial.command) std::fill(command.begin(), command.end(), 0.8);
  for (auto& signal : trial.signals) std::fill(signal.values.begin(), signal.values.end(), 0.8);
  const Prediction p = replay(nominalPlant(arm), trial);
  const double q0 = p.values[0].back(), q1 = p.values[1].back();
  const double elbow = 9.81 * 0.2 * 0.2 * std::sin(q0 + q1);
  const double shoulder = 9.81 * (0.3 * 0.2 + 0.2 * 0.2) * std::sin(q0) + elbow;
  EXPECT_NEAR(20 * (0.8 - q1), elbow, 1e-6);
  EXPECT_NEAR(20 * (0.8 - q0), shoulder, 1e-6);
}

TEST(ReplayTest, dryFrictionHoldsWhatIsBelowIt) {
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 3);
  for (std::size_t j = 0; j < 2; ++j) {
    std::fill(trial.command[j].begin(), trial.command[j].end(), 0.0);
    std::fill(trial.signals[j].values.begin(), trial.signals[j].values.end(), 0.0);
  }
  for (std::size_t k = 100; k < trial.cycles(); ++k) trial.command[1][k] = 0.01;  // asks for 0.2 N m
  Plant plant = nominalPlant(arm);
  plant.joints[1].coulomb = 0.3;
  EXPECT_NEAR(replay(plant, trial).values[1].back(), 0, 1e-9);
  plant.joints[1].coulomb = 0.1;
  EXPECT_GT(replay(plant, trial).values[1].back(), 0.003);
}

TEST(ReplayTest, whatSticksDoesNotCreepOnTheFoot) {
  const Mechanism leg = legOnItsFoot();
  Trial trial = legTrial(true, 12);
  std::fill(trial.command[1].begin(), trial.command[1].end(), 0.02);
  Plant plant = nominalPlant(leg);
  plant.joints[1].coulomb = 1.5;  // several times what the moving body asks of the knee
  const std::vector<double> knee = replay(plant, trial).values[1];
  EXPECT_LT(largest(knee, std::vector<double>(knee.size(), knee[0])), 1e-5);
}

TEST(ReplayTest, playShowsAtTheReversalOfTheLoad) {
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 6);
  Plant plant = nominalPlant(arm);
  plant.joints[1].backlash = 0.05;
  plant.joints[1].linkEncoder = true;  // sees the link, which leans on one flank and then the other
  for (int k = 0; k < 600; ++k) {
    trial.command[0][static_cast<std::size_t>(k)] = 0;
    trial.command[1][static_cast<std::size_t>(k)] = k < 300 ? 0.4 : -0.4;
  }
  for (auto& signal : trial.signals) std::fill(signal.values.begin(), signal.values.end(), 0.0);
  // The servo holds the link's angle: with the encoder at the motor the link would hang lower by half the
  // play.
  plant.joints[1].linkEncoder = false;
  const double motor = replay(plant, trial).values[1][290];
  EXPECT_NEAR(motor, replay(nominalPlant(arm), trial).values[1][290], 2e-3);
  EXPECT_LT(motor, 0.4);
}

TEST(ReplayTest, complianceStretchesByTorque) {
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 3);
  for (std::size_t j = 0; j < 2; ++j) {
    std::fill(trial.command[j].begin(), trial.command[j].end(), j ? 0.9 : 0.0);
    std::fill(trial.signals[j].values.begin(), trial.signals[j].values.end(), j ? 0.9 : 0.0);
  }
  Plant plant = nominalPlant(arm);
  plant.joints[1].compliance = 0.1;
  plant.joints[1].linkEncoder = true;
  const Prediction link = replay(plant, trial);
  plant.joints[1].linkEncoder = false;
  const Prediction motor = replay(plant, trial);
  // With the encoder on the motor, the torque there follows from its own error, and stretches the gear.
  const double torque = 20 * (0.9 - motor.values[1].back());
  EXPECT_NEAR(torque,
              9.81 * 0.2 * 0.2 * std::sin(motor.values[0].back() + motor.values[1].back() - 0.1 * torque),
              1e-3);
  EXPECT_GT(motor.values[1].back(), link.values[1].back());
}

TEST(ReplayTest, chainsOfAFixedBaseDoNotFeelEachOther) {
  const Mechanism nao = [] {
    Mechanism two = twoJointArm();
    Mechanism::Joint other = two.joints[0];
    other.name = "other";
    other.child = 3;
    two.links.push_back({"third", 0, 0.4, Vec3(0, 0, -0.1), Mat3::Identity() * 1e-4});
    two.joints.push_back(other);
    return two;
  }();
  const Trial trial = armTrial(nao, 4);
  ReplayOptions one;
  one.joints = {2};
  const Prediction whole = replay(nominalPlant(nao), trial), part = replay(nominalPlant(nao), trial, one);
  EXPECT_EQ(whole.values[2], part.values[2]);
  EXPECT_TRUE(part.values[0].empty());
}

TEST(ReplayTest, sameBytesEachTime) {
  const Mechanism arm = twoJointArm();
  const Trial trial = armTrial(arm, 4);
  Plant plant = nominalPlant(arm);
  plant.joints[0].coulomb = 0.1;
  plant.joints[1].backlash = 0.02;
  EXPECT_EQ(replay(plant, trial).values, replay(plant, trial).values);
}

}  // namespace
}  // namespace plumbline::gap
