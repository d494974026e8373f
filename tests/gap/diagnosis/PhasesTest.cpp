#include "gap/diagnosis/Phases.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

/// A trial in which the shoulder is commanded and moves as functions of the time say [s].
template <typename Command, typename Position>
std::vector<Phase> ofShoulder(Command&& command, Position&& position) {
  Trial trial = armTrial(twoJointArm(), 4);
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    trial.command[0][k] = command(trial.time[k]);
    trial.signals[0].values[k] = position(trial.time[k]);
  }
  return phasesOf(trial, trial.signals[0]);
}

Phase moving(double speed) {
  const auto line = [=](double t) { return speed * (t - 2); };
  return ofShoulder(line, line)[200];
}

TEST(Phases, aJointRestsBelowAHundredthOfARadianASecondAndIsFastAboveHalfOfItsLimit) {
  EXPECT_EQ(moving(0), Phase::staticHold);
  EXPECT_EQ(moving(0.01), Phase::staticHold);
  EXPECT_EQ(moving(0.017), Phase::staticHold);
  EXPECT_EQ(moving(0.1), Phase::motion);
  EXPECT_EQ(moving(3.4), Phase::motion);
  EXPECT_EQ(moving(-3.6), Phase::highSpeed);
}

TEST(Phases, whatDriftsWithoutACommandRestsUntilItIsSeenToMove) {
  const auto drifting = [](double speed) {
    return ofShoulder([](double) { return 0.0; }, [=](double t) { return speed * (t - 2); })[200];
  };
  EXPECT_EQ(drifting(0.04), Phase::staticHold);
  EXPECT_EQ(drifting(0.06), Phase::motion);
}

TEST(Phases, aLoadIsHighWhereHalfOfTheTorqueIsAskedFor) {
  const auto off = [](double error) {
    return ofShoulder([=](double t) { return t + error; }, [](double t) { return t; })[200];
  };
  EXPECT_EQ(off(0.07), Phase::motion);  // 20 N m/rad, 3 N m
  EXPECT_EQ(off(-0.08), Phase::highLoad);
}

TEST(Phases, aReversalLastsAMomentToEitherSide) {
  const auto turn = [](double t) { return std::abs(t - 2); };
  const std::vector<Phase> phases = ofShoulder(turn, turn);
  const auto seconds = static_cast<double>(std::ranges::count(phases, Phase::reversal)) / 100;
  EXPECT_NEAR(seconds, 0.3, 0.02);
  EXPECT_EQ(phases[200 - 12], Phase::reversal);
  EXPECT_EQ(phases[200 + 12], Phase::reversal);
  EXPECT_EQ(phases[200 - 18], Phase::motion);
  EXPECT_EQ(phases[200 + 20], Phase::motion);
}

TEST(Phases, aMoveThatIsTooSlowToHaveADirectionIsNoReversal) {
  const auto turn = [](double t) { return t < 2 ? t - 2 : -0.04 * (t - 2); };
  EXPECT_EQ(std::ranges::count(ofShoulder(turn, turn), Phase::reversal), 0);
}

TEST(Phases, aSpeedIsTakenOverSixCycles) {
  // It stands but for one jump of 0.0035 rad: 0.058 rad/s over the cycles around it.
  const std::vector<Phase> phases =
      ofShoulder([](double) { return 0.0; }, [](double t) { return t < 1.995 ? 0.0 : 0.0035; });
  EXPECT_EQ(std::ranges::count(phases, Phase::motion), 6);
}

/// A robot of 0.5 kg on two feet: what bears on them, left and right, as shares of its weight.
std::vector<Phase> ofBody(const std::vector<std::pair<double, double>>& shares) {
  Mechanism robot = twoJointArm();
  for (const char* name : {"LFoot", "RFoot"}) {
    robot.feet.emplace_back();
    robot.feet.back().name = name;
    robot.feet.back().sensors.emplace_back();
  }
  Trial trial = armTrial(robot, 0.01 * static_cast<double>(shares.size()) + 0.001);
  trial.freeBase = true;
  const double weight = robot.totalMass() * robot.gravity.norm();
  for (const int foot : {0, 1}) {
    Signal force{"fsr", SignalKind::force, -1, foot, 0, false, {}};
    for (const auto& [left, right] : shares) force.values.push_back(weight * (foot == 0 ? left : right));
    trial.signals.push_back(force);
  }
  return phasesOf(trial, trial.signals.back());
}

TEST(Phases, aFootSupportsThatCarriesFourFifths) {
  const std::vector<Phase> phases =
      ofBody({{0.5, 0.5}, {0.78, 0.22}, {0.85, 0.15}, {0.78, 0.22}, {0.5, 0.5}});
  EXPECT_EQ(phases,
            (std::vector{Phase::motion, Phase::motion, Phase::leftSupport, Phase::motion, Phase::motion}));
  EXPECT_EQ(ofBody({{0.15, 0.85}, {0.15, 0.85}})[1], Phase::rightSupport);
}

TEST(Phases, anImpactIsAJumpByAThirdOfTheWeight) {
  EXPECT_EQ(ofBody({{0.5, 0.4}, {0.5, 0.65}})[1], Phase::motion);
  EXPECT_EQ(ofBody({{0.5, 0.4}, {0.5, 0.75}})[1], Phase::impact);
}

TEST(Phases, aRobotThatHangsRests) {
  Trial trial = armTrial(twoJointArm(), 1);
  trial.signals.push_back(
      {"gyro.x", SignalKind::gyro, -1, -1, 0, false, std::vector<double>(trial.cycles())});
  EXPECT_EQ(phasesOf(trial, trial.signals.back()), std::vector(trial.cycles(), Phase::staticHold));
}

TEST(Phases, haveNamesForPeople) {
  EXPECT_EQ(nameOf(Phase::staticHold), "static hold");
  EXPECT_EQ(nameOf(Phase::highLoad), "high load");
  EXPECT_EQ(nameOf(Phase::motion), "motion");
}

}  // namespace
}  // namespace plumbline::gap
