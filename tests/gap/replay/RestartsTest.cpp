#include "gap/replay/Restarts.h"

#include <gtest/gtest.h>

#include <limits>

#include "../LegOnItsFoot.h"
#include "gap/replay/Stepper.h"

namespace plumbline::gap {
namespace {

/// A leg and its like: enough to tell which foot is loaded.
Mechanism twoFeet() {
  Mechanism robot = legOnItsFoot();
  robot.feet[0].sensors.emplace_back();
  robot.feet.push_back(robot.feet[0]);
  return robot;
}

/// Stands for a second, then steps from foot to foot every 0.3 s, for so many seconds; its joints turn at
/// 0.4 rad/s.
Trial walked(double seconds, double begins = 1) {
  Trial trial = armTrial(twoFeet(), seconds);
  trial.freeBase = true;
  for (Signal& signal : trial.signals)
    for (std::size_t k = 0; k < trial.cycles(); ++k) signal.values[k] = 0.4 * trial.time[k];
  for (const int foot : {0, 1}) {
    Signal signal{"fsr", SignalKind::force, -1, foot, 0, false, {}};
    for (const double t : trial.time) {
      const bool on = static_cast<int>((t - begins) / 0.3) % 2 == foot;
      signal.values.push_back(t < begins ? 20 : on ? 38 : 2);
    }
    trial.signals.push_back(std::move(signal));
  }
  return trial;
}

TEST(RestartsTest, atTheStartAndInTheMiddleOfAStepAboutEverySecond) {
  Trial trial = walked(4);
  cutIntoSteps(trial);
  std::vector<std::size_t> at;
  for (const Restart& restart : trial.restarts) at.push_back(restart.cycle);
  // Standing it begins where a speed can first be taken; steps are 30 cycles, the first from 100 on.
  EXPECT_EQ(at, (std::vector<std::size_t>{2, 115, 235, 355}));
  for (const Restart& restart : trial.restarts)
    for (const std::size_t joint : {0u, 1u}) {
      EXPECT_NEAR(restart.position[joint], 0.4 * trial.time[restart.cycle], 1e-12);
      EXPECT_NEAR(restart.speed[joint], 0.4, 1e-12);
    }
  EXPECT_EQ(trial.restarts[0].load, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(trial.restarts[1].load, (std::vector<double>{0.95, 0.05}));
}

TEST(RestartsTest, anywhereEveryOneAndAHalfSecondsWhileNoFootCarriesAll) {
  Trial trial = walked(7, 4);
  cutIntoSteps(trial);
  std::vector<std::size_t> at;
  for (const Restart& restart : trial.restarts) at.push_back(restart.cycle);
  // Steps begin at cycle 400; the middle of the first is 1.13 s after the last one before.
  ASSERT_GE(at.size(), 4u);
  at.resize(4);
  EXPECT_EQ(at, (std::vector<std::size_t>{2, 152, 302, 415}));
}

TEST(RestartsTest, aShiftOfLoadOfThreeHundredthsIsNoStep) {
  for (const double shift : {0.025, 0.035}) {
    Trial trial = walked(4);
    // Both feet together carry 40 N.
    for (std::size_t k = 115; k < 130; ++k) {
      for (const std::size_t foot : {0u, 1u}) {
        std::vector<double>& force = (trial.signals.end() - 2 + static_cast<std::ptrdiff_t>(foot))->values;
        force[k] += (force[k] > 20 ? -40 : 40) * shift;
      }
    }
    cutIntoSteps(trial);
    EXPECT_EQ(trial.betweenSteps[114], shift < 0.03) << shift;
  }
}

TEST(RestartsTest, saysWhereNoFootLandsOrLiftsOff) {
  Trial trial = walked(4);
  cutIntoSteps(trial);
  ASSERT_EQ(trial.betweenSteps.size(), trial.cycles());
  // The load shifts from cycle 129 to 130: 0.03 s before and 0.06 s after that are left out.
  for (std::size_t k = 110; k < 155; ++k) EXPECT_EQ(trial.betweenSteps[k], k < 127 || k >= 136) << k;
}

TEST(RestartsTest, noneWhereNothingSteps) {
  Trial fixed = walked(4), floating = walked(2.1), blind = walked(4);
  fixed.freeBase = false;
  std::erase_if(blind.signals, [](const Signal& signal) { return signal.kind == SignalKind::force; });
  for (Trial* trial : {&fixed, &floating, &blind}) {
    cutIntoSteps(*trial);
    EXPECT_TRUE(trial->restarts.empty());
    EXPECT_TRUE(trial->betweenSteps.empty());
  }
}

TEST(RestartsTest, aLostReadingOfAFootIsNoPlaceToBegin) {
  Trial trial = walked(4);
  trial.signals.back().values[115] = std::numeric_limits<double>::quiet_NaN();
  cutIntoSteps(trial);
  ASSERT_GT(trial.restarts.size(), 2u);
  EXPECT_EQ(trial.restarts[1].cycle, 107u);  // the middle of what is left of that step before the gap
  EXPECT_FALSE(trial.betweenSteps[115]);
}

TEST(RestartsTest, theFootLiesFlatAndStays) {
  const Mechanism leg = legOnItsFoot();
  Trial trial = legTrial(true);
  Signal truth{"truth", SignalKind::truth, -1, -1, 0, false, std::vector<double>(trial.cycles())};
  for (int axis = 0; axis < 7; ++axis) {
    truth.axis = axis;
    trial.signals.push_back(truth);
  }
  const Plant plant = nominalPlant(leg);
  Stepper stepper(plant, trial, {0, 1}, nullptr);
  stepper.beginBody();
  Restart seen{0, {0.3, -0.1}, {0.5, 0.2}, {1}};
  stepper.restart(seen);
  EXPECT_NEAR(stepper.shown(0), 0.3, 1e-12);
  EXPECT_NEAR(stepper.rate(1), 0.2, 1e-12);
  std::vector<std::size_t> body;
  for (std::size_t s = trial.signals.size() - 7; s < trial.signals.size(); ++s) body.push_back(s);
  std::vector<std::vector<double>> values(trial.signals.size(), std::vector<double>(trial.cycles()));
  stepper.readBody(0, 0, body, values);
  const auto pose = [&](std::size_t axis) { return values[body[axis]][0]; };
  // The lower link stands upright, the upper one leans by the knee's angle, the body by both.
  EXPECT_NEAR(pose(2), 0.2 + 0.2 * std::cos(0.1) + 2e-5, 1e-9);
  EXPECT_NEAR(pose(5), std::sin(-0.2 / 2), 1e-9);
  EXPECT_NEAR(pose(3), std::cos(0.2 / 2), 1e-9);
  // Nothing of it slides in a step: the foot is where it was while the body moves on.
  stepper.step(0, 1e-5);
  stepper.readBody(1, 1e-5, body, values);
  const double speed = (values[body[5]][1] - values[body[5]][0]) / 1e-5;
  EXPECT_NEAR(speed, -0.5 * (0.5 + 0.2) * std::cos(0.1), 1e-3);
}

TEST(RestartsTest, theReplayGoesOnFromWhatWasMeasured) {
  const Mechanism leg = legOnItsFoot();
  Trial trial = legTrial(true);
  Plant reality = nominalPlant(leg);
  reality.joints[1].biasForce = 0.4;  // 0.02 rad at the knee
  const Prediction real = replay(reality, trial);
  for (std::size_t s = 0; s < trial.signals.size(); ++s) trial.signals[s].values = real.values[s];
  const std::size_t at = 300;
  Restart seen{at, {}, {}, {1}};
  for (const auto& values : real.values) {
    seen.position.push_back(values[at]);
    seen.speed.push_back((values[at + 1] - values[at - 1]) / 0.02);
  }
  trial.restarts = {seen};
  trial.betweenSteps.assign(trial.cycles(), 1);
  ReplayOptions inOnePiece;
  inOnePiece.restarts = false;
  const Prediction windows = replay(nominalPlant(leg), trial),
                   whole = replay(nominalPlant(leg), trial, inOnePiece);
  for (std::size_t k = at; k < at + 10; ++k) EXPECT_TRUE(std::isnan(windows.values[1][k])) << k;
  EXPECT_FALSE(std::isnan(windows.values[1][at + 10]));
  EXPECT_NEAR(windows.values[1][at - 1], whole.values[1][at - 1], 1e-3);
  EXPECT_FALSE(std::isnan(whole.values[1][at]));
  // A servo forgets in 0.1 s where it began: what is missing shows in a window, too.
  EXPECT_GT(real.values[1][at + 40] - windows.values[1][at + 40], 0.015);
}

}  // namespace
}  // namespace plumbline::gap
