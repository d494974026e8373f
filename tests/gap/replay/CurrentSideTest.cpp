#include "gap/replay/CurrentSide.h"

#include <gtest/gtest.h>

#include "../DutyTrial.h"

namespace plumbline::gap {

namespace {

/// A pendulum on a DC motor whose unsigned current is the motor's or the supply's, and scaled.
Trial withCurrent(bool ofSupply, double scale) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const Explanation reality{causeOf(pendulum, "coulomb_friction", "pendulum", 0.05)};
  Trial trial = dutyTrial(reality, 6, 5e-4);
  Signal current;
  current.name = "current.pendulum";
  current.kind = SignalKind::current;
  current.joint = 0;
  current.unsignedValue = true;
  current.ofSupply = ofSupply;
  current.values.assign(trial.cycles(), 0);
  trial.signals.push_back(current);
  trial.signals.back().values = replay(plantOf(trial, reality), trial).values.back();
  for (double& value : trial.signals.back().values) value *= scale;
  trial.signals.back().ofSupply = false;
  return trial;
}

}  // namespace

TEST(CurrentSide, isFoundWhateverTheScale) {
  for (const double scale : {0.4, 0.6, 1.0, 1.7, 2.6}) {
    std::vector<Trial> trials{withCurrent(true, scale), withCurrent(true, scale)};
    findCurrentSide(trials);
    for (const Trial& trial : trials) EXPECT_TRUE(trial.signals.back().ofSupply) << scale;
    trials = {withCurrent(false, scale)};
    findCurrentSide(trials);
    EXPECT_FALSE(trials[0].signals.back().ofSupply) << scale;
  }
}

TEST(CurrentSide, aCurrentWithASignIsTheMotors) {
  std::vector<Trial> trials{withCurrent(true, 1)};
  trials[0].signals.back().unsignedValue = false;
  findCurrentSide(trials);
  EXPECT_FALSE(trials[0].signals.back().ofSupply);
}

TEST(CurrentSide, ofASupplyIsTheDutyTimesTheMotors) {
  const Trial motor = withCurrent(false, 1), supply = withCurrent(true, 1);
  for (std::size_t k = 20; k < motor.cycles(); k += 50) {
    const double amperes = motor.signals.back().values[k];
    const double rate = std::abs(rateAt(motor, motor.signals[0], k));
    if (rate > 0.01) continue;  // there, the duty is the current times R / vin
    const Servo& servo = motor.robot->joints[0].servo;
    EXPECT_NEAR(supply.signals.back().values[k], amperes * amperes * servo.R / servo.vin,
                0.02 * supply.signals.back().values[k] + 1e-4);
  }
}

}  // namespace plumbline::gap
