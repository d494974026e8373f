#include "walking/estimation/FitSafety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::walking {
namespace {

constexpr double seconds = 0.2, halfDistance = 0.05;  // of a step; of a foot from the middle [m]

/// Steps of 0.2 s with the feet 0.1 m apart, at a speed [m/s] where they begin.
std::vector<ObservedStep> stepsAt(double speed) {
  std::vector<ObservedStep> steps(2);
  for (const std::size_t foot : {0u, 1u}) {
    ObservedStep& step = steps[foot];
    step.begin.support = foot == 0 ? Support::left : Support::right;
    step.begin.foot[foot] = Pose2(0, foot == 0 ? halfDistance : -halfDistance);
    step.begin.velocity = Vec2(speed, 0);
    step.samples.push_back({seconds, Vec2::Zero(), Vec2::Zero()});
  }
  return steps;
}

TEST(FitSafety, neutralParametersChangeNothing) { EXPECT_EQ(FitSafety(stepsAt(0.4)).change({}), 0); }

TEST(FitSafety, aCentimetreUnderTheMassIsAsMuchAsIsSafe) {
  ModelParameters shifted;
  shifted.massOffsetX = 0.004;
  EXPECT_NEAR(FitSafety(stepsAt(0)).change(shifted), 0.4, 1e-6);
  shifted.massOffsetX = -0.02;
  EXPECT_NEAR(FitSafety(stepsAt(0)).change(shifted), 2, 1e-6);
}

TEST(FitSafety, fiveCentimetresASecondAreAsMuchAsIsSafe) {
  // A pendulum that passes over its foot with a step of length s in the time T begins it with
  // s / 2 * rate / tanh(rate * T / 2). Where time passes 5 % faster in it, T is that much longer.
  const double rate = std::sqrt(9.81 / 0.25);
  ModelParameters faster;
  faster.timeFactor = 1.05;
  for (const double speed : {0.2, 0.4}) {
    const double half = speed * seconds / 2;
    const double plain = half * rate / std::tanh(rate * seconds / 2),
                 fitted = half * rate / std::tanh(rate * seconds * 1.05 / 2);
    EXPECT_NEAR(FitSafety(stepsAt(speed)).change(faster), (plain - fitted) / 0.05, 0.01) << speed;
  }
}

TEST(FitSafety, parametersThatAreNoNumbersAreNotSafe) {
  ModelParameters noNumber;
  noNumber.timeFactor = std::nan("");
  EXPECT_GT(FitSafety(stepsAt(0.2)).change(noNumber), 1);
}

}  // namespace
}  // namespace plumbline::walking
