#include "walking/planning/TurnToStop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace plumbline::walking {
namespace {

constexpr double dt = 0.02;

/// The turns of a robot that is to stop now, for so many seconds [rad/s].
std::vector<double> turnsOf(TurnToStop& stop, double requested, const WalkParameters& p, double seconds) {
  std::vector<double> turns;
  for (double time = 0; time < seconds; time += dt) turns.push_back(stop.turn(requested, false, p, dt));
  return turns;
}

TEST(TurnToStop, whileItWalksTheTurnIsAsRequested) {
  TurnToStop stop;
  for (const double turn : {-2.0, 0.0, 3.0}) EXPECT_EQ(stop.turn(turn, true, {}, dt), turn);
}

TEST(TurnToStop, aRobotThatStopsTurnsOnForAMomentAndNotForEver) {
  WalkParameters p;
  p.startStop.turn = 1;
  TurnToStop stop;
  stop.turn(0.4, true, p, dt);
  const std::vector<double> turns = turnsOf(stop, 0.4, p, 2);
  const auto end = std::ranges::find(turns, 0.0);
  for (auto turn = turns.begin(); turn != end; ++turn) EXPECT_EQ(*turn, 0.4);
  for (auto turn = end; turn != turns.end(); ++turn) EXPECT_EQ(*turn, 0);
  // A robot that is 10 degrees off gets its heading right at 0.4 rad/s; its feet come together soon after.
  const double turned = 0.4 * dt * static_cast<double>(end - turns.begin());
  EXPECT_GT(turned, 0.17);
  EXPECT_LT(turned, 0.22);
}

TEST(TurnToStop, itTurnsNoFasterThanItsLimitAndBeginsAnewAfterAWalk) {
  WalkParameters p;
  p.startStop.turn = 0.5;
  TurnToStop stop;
  EXPECT_EQ(turnsOf(stop, 3, p, 0.1).back(), 0.5);
  EXPECT_EQ(turnsOf(stop, -3, p, 0.1).back(), -0.5);
  EXPECT_EQ(turnsOf(stop, -3, p, 2).back(), 0);
  stop.turn(0, true, p, dt);
  EXPECT_EQ(turnsOf(stop, -3, p, 0.1).back(), -0.5);
}

}  // namespace
}  // namespace plumbline::walking
