#include "gap/run/Plausibility.h"

#include <gtest/gtest.h>

#include <cmath>

#include "PendulumRun.h"
#include "math/Random.h"

namespace plumbline::gap {
namespace {

/// Never the same again within a run.
double wandering(double t) { return 0.15 * std::sin(6 * t + 0.3 * t * t) + 0.1 * std::sin(7.7 * t + 0.4); }

Run moving() {
  return pendulumRun(
      wandering, [](double t) { return wandering(t - 0.05); }, 100, 20);
}

Run later(double seconds, double rate = 100) {
  return pendulumRun(
      wandering, [=](double t) { return wandering(t - seconds); }, rate, 20);
}

TEST(Plausibility, aRateThatIsSixPerCentOffIsReported) {
  gap::Run run = moving();
  EXPECT_EQ(saidOf(run), "");
  run.rateHz = 104;
  EXPECT_EQ(saidOf(run), "");
  run.rateHz = 106;
  EXPECT_EQ(saidOf(run),
            "r: run.json: rate_hz 106 says 0.009434 s a line, t advances by 0.01 s; t is used\n");
}

TEST(Plausibility, aGainSixtyTimesTheRobotsOwnIsReported) {
  gap::Run run = moving();
  run.servo["pendulum"].kp = 0.9586 * 40;
  EXPECT_EQ(saidOf(run), "");
  run.servo["pendulum"].kp = 0.9586 / 40;
  EXPECT_EQ(saidOf(run), "");
  run.servo["pendulum"].kp = 0.9586 * 60;
  EXPECT_EQ(saidOf(run),
            "r: run.json: servo.pendulum.kp is 57.52, 60 times that of xl330_pendulum; check its unit\n");
}

TEST(Plausibility, timesThatAreFartherFromTheCycleThanAnyBusAreReported) {
  gap::Run run = moving();
  run.timing["pendulum"].posAt = -0.24;
  EXPECT_EQ(saidOf(run), "");
  run.timing["pendulum"].posAt = -0.3;
  EXPECT_EQ(saidOf(run), "r: run.json: timing.pos_at_s.pendulum is -0.3 s, -30 cycles; is it in s?\n");
}

TEST(Plausibility, aSlowJointIsNoOtherClock) {
  EXPECT_EQ(saidOf(later(0.45)), "");
  EXPECT_EQ(
      saidOf(later(0.6)),
      "r: pos.pendulum: it moves as cmd.pendulum does 0.6 s before; are both of one clock, and in the right "
      "lines?\n");
  EXPECT_EQ(
      saidOf(later(1.5)),
      "r: pos.pendulum: it moves as cmd.pendulum does 1.5 s before; are both of one clock, and in the right "
      "lines?\n");
  EXPECT_EQ(saidOf(later(3)), "") << "so far nobody looks";
}

TEST(Plausibility, fastRecordingsAreComparedEveryHundredthOfASecond) {
  EXPECT_EQ(
      saidOf(later(1.004, 1000)),
      "r: pos.pendulum: it moves as cmd.pendulum does 1 s before; are both of one clock, and in the right "
      "lines?\n");
}

TEST(Plausibility, aPositionTwoCyclesBeforeItsCommandIsHowClocksAreRead) {
  for (const int ahead : {2, 3}) {
    Random random(7);
    std::vector<double> noise(1100);
    for (double& x : noise) x = 0.3 * random.uniform();
    const auto at = [&](double t, int by) {
      return noise[static_cast<std::size_t>(std::lround(100 * t)) + static_cast<std::size_t>(by)];
    };
    const std::string said =
        saidOf(pendulumRun([&](double t) { return at(t, 0); }, [&](double t) { return at(t, ahead); }));
    EXPECT_EQ(said, ahead == 2
                        ? ""
                        : "r: pos.pendulum: it moves as cmd.pendulum does 0.03 s later; are both of one "
                          "clock, and in the right lines?\n");
  }
}

TEST(Plausibility, aPositionIsAtMostTwoHundredthsOfASecondBeforeItsCommand) {
  // Two cycles of 80 a second are 0.025 s.
  Random random(7);
  std::vector<double> noise(1000);
  for (double& x : noise) x = 0.3 * random.uniform();
  const auto at = [&](double t, int by) { return noise[static_cast<std::size_t>(std::lround(80 * t) + by)]; };
  const std::string said =
      saidOf(pendulumRun([&](double t) { return at(t, 0); }, [&](double t) { return at(t, 2); }, 80));
  EXPECT_NE(said.find("0.025 s later; are both of one clock"), std::string::npos) << said;
}

TEST(Plausibility, anotherClockHasToExplainAFifthMoreThanADelay) {
  // A swing that is 0.58 s late is like itself with half a second taken off by the cosine of the 0.08 s left.
  const auto said = [](double like) {
    const double rate = std::acos(like) / 0.08;
    return saidOf(pendulumRun([=](double t) { return 0.2 * std::sin(rate * t); },
                              [=](double t) { return 0.2 * std::sin(rate * (t - 0.58)); }, 100, 20));
  };
  EXPECT_NE(said(0.77), "");
  EXPECT_EQ(said(0.83), "");
}

TEST(Plausibility, aTorqueOfItsOwnLinesCommandIsReported) {
  Mechanism robot = findMechanism("xl330_pendulum");
  robot.joints[0].servo = {};
  robot.joints[0].servo.kp = 3;
  gap::Run run = later(0.05);
  const auto withTorques = [&](std::size_t before) {
    const std::vector<double>&cmd = run.channels["cmd.pendulum"], &pos = run.channels["pos.pendulum"];
    std::vector<double> torques;
    for (std::size_t k = 0; k < cmd.size(); ++k)
      torques.push_back(3 * (cmd[k < before ? 0 : k - before] - pos[k]));
    run.channels["torque.pendulum"] = torques;
    std::vector<RunWarning> warnings;
    checkPlausibility(run, robot, warnings);
    return warnings;
  };
  EXPECT_TRUE(withTorques(1).empty());
  const std::vector<RunWarning> warnings = withTorques(0);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0].line("r"),
      "r: torque.pendulum: it is the torque of its own line's command, but commands come into force after "
      "a line's readings; add to run.json: timing: {effort_at_s: 1e-4}");
  run.timing["*"].effortAt = 1e-4;
  EXPECT_TRUE(withTorques(0).empty());
}

}  // namespace
}  // namespace plumbline::gap
