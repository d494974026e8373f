#include "gap/answer/Behavior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../LegOnItsFoot.h"

namespace plumbline::gap {
namespace {

/// A body on its feet, seen for 4 s: it turns, tilts, bears on two feet and goes; what it did stands in the
/// signals.
Trial seen(const Mechanism& robot, double tilt = 0.1, double speed = 0.1) {
  Trial trial = armTrial(robot, 4);
  trial.name = "runs/walk";
  trial.freeBase = true;
  trial.signals.clear();
  const auto add = [&](SignalKind kind, int place, int axis, auto&& value) {
    Signal signal{"x", kind, -1, place, axis, false, {}};
    for (const double t : trial.time) signal.values.push_back(value(t));
    trial.signals.push_back(std::move(signal));
  };
  add(SignalKind::gyro, -1, 0, [](double t) { return 0.5 + 0.2 * std::sin(2 * M_PI * t); });
  add(SignalKind::gyro, -1, 1, [](double) { return 0.1; });
  add(SignalKind::accelerometer, -1, 0, [=](double) { return 9.81 * std::sin(tilt); });
  add(SignalKind::accelerometer, -1, 1, [](double) { return 0.0; });
  add(SignalKind::accelerometer, -1, 2, [=](double) { return 9.81 * std::cos(tilt); });
  add(SignalKind::force, 0, 0, [](double) { return 30.0; });
  add(SignalKind::force, 1, 0, [](double) { return 10.0; });
  add(SignalKind::truth, -1, 0, [=](double t) { return speed * t; });
  add(SignalKind::truth, -1, 1, [](double) { return 2.0; });
  return trial;
}

Mechanism onTwoFeet() {
  Mechanism robot = twoJointArm();
  robot.feet.push_back({});
  robot.feet.back().name = "LFoot";
  robot.feet.back().link = 2;
  robot.feet.back().sensors.emplace_back();
  robot.feet.push_back(robot.feet.back());
  return robot;
}

TEST(BehaviorTest, saysWhatTheRunDid) {
  const Mechanism robot = onTwoFeet();
  const Trial trial = seen(robot);
  const Evidence evidence({trial});
  const Evaluator evaluator(robot, evidence);
  Prediction nominal;
  for (const Signal& signal : trial.signals) nominal.values.push_back(signal.values);
  nominal.fell = true;
  const std::vector<Behavior> list = behaviors(evaluator, {nominal});
  ASSERT_EQ(list.size(), 6u);
  const std::pair<const char*, double> wanted[] = {{"sway (RMS turning rate), walk", 0.2 / std::sqrt(2)},
                                                   {"largest tilt, walk", 0.1},
                                                   {"weight on LFoot, walk", 0.75},
                                                   {"way gone, walk", 0.399},
                                                   {"mean speed, walk", 0.1},
                                                   {"fell, walk", 0}};
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i].name, wanted[i].first);
    EXPECT_NEAR(list[i].measured, wanted[i].second, 1e-6) << list[i].name;
  }
  EXPECT_DOUBLE_EQ(list[0].nominal, list[0].measured);
  EXPECT_DOUBLE_EQ(list[5].nominal, 1);
}

/// What a robot did, by its name; NaN where nothing is said of it.
double measured(const std::string& what, const Trial& trial, const Mechanism& robot) {
  const Evidence evidence({trial});
  const Evaluator evaluator(robot, evidence);
  Prediction nominal;
  for (const Signal& signal : trial.signals) nominal.values.push_back(signal.values);
  for (const Behavior& line : behaviors(evaluator, {nominal}))
    if (line.name == what + ", walk") return line.measured;
  return std::nan("");
}

TEST(BehaviorTest, aRobotFellThatTiltsByMoreThanARadian) {
  const Mechanism robot = onTwoFeet();
  for (const double tilt : {0.3, 0.9, 1.1, 1.5}) {
    const Trial trial = seen(robot, tilt);
    EXPECT_NEAR(measured("largest tilt", trial, robot), tilt, 1e-6);
    EXPECT_EQ(measured("fell", trial, robot), tilt > 1 ? 1 : 0) << tilt;
  }
}

TEST(BehaviorTest, aSpeedIsSaidOfARobotThatWentThirtyCentimetres) {
  const Mechanism robot = onTwoFeet();
  EXPECT_NEAR(measured("mean speed", seen(robot, 0.1, 0.085), robot), 0.085, 1e-3);
  const Trial trial = seen(robot, 0.1, 0.07);
  EXPECT_NEAR(measured("way gone", trial, robot), 0.28, 0.01);
  EXPECT_TRUE(std::isnan(measured("mean speed", trial, robot)));
}

TEST(BehaviorTest, aRunWithAFixedBaseHasNone) {
  const Mechanism arm = twoJointArm();
  const Evidence evidence({recorded(nominalPlant(arm), armTrial(arm, 2), 5e-4, 1)});
  const Evaluator evaluator(arm, evidence);
  EXPECT_TRUE(behaviors(evaluator, {Prediction()}).empty());
}

TEST(BehaviorTest, whatSteppedIsPlayedInOnePiece) {
  const Mechanism leg = legOnItsFoot();
  Trial trial = legTrial(true, 3);
  Signal gyro{"gyro.y", SignalKind::gyro, -1, -1, 1, false, std::vector<double>(trial.cycles())};
  trial.signals.push_back(gyro);
  gyro.axis = 0;
  trial.signals.push_back(gyro);
  const Prediction whole = replay(nominalPlant(leg), trial);
  for (std::size_t s = 0; s < trial.signals.size(); ++s) trial.signals[s].values = whole.values[s];
  // From here on it goes where no command led it.
  trial.restarts.push_back({150, {0.3, -0.3}, {0, 0}, {1}});
  const Evidence evidence({trial});
  Evaluator evaluator(leg, evidence);
  evaluator.setBase({});
  const std::vector<Behavior> list = behaviors(evaluator, {evaluator.basePrediction(0)});
  ASSERT_EQ(list[0].name, "sway (RMS turning rate), arm");
  EXPECT_NEAR(list[0].nominal, list[0].measured, 1e-9);
  EXPECT_NEAR(list[0].corrected, list[0].measured, 1e-9);
}

}  // namespace
}  // namespace plumbline::gap
