#include "gap/inference/WindowStarts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../TwoJointArm.h"

namespace plumbline::gap {

namespace {

/// 2 s at 100 Hz of one joint whose positions are 0.1 + 0.5 t + 2 t^2.
Trial parabola() {
  Trial trial = armTrial(twoJointArm(), 2);
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const double t = trial.time[k];
    trial.signals[0].values[k] = 0.1 + 0.5 * t + 2 * t * t;
  }
  return trial;
}

}  // namespace

TEST(WindowStarts, aParabolasStateIsReadExactly) {
  const Trial trial = parabola();
  const MeasuredState state = stateAt(trial, trial.signals[0], 100, 1e-3);
  EXPECT_NEAR(state.position, 0.1 + 0.5 + 2, 1e-9);
  EXPECT_NEAR(state.speed, 0.5 + 4, 1e-8);
}

TEST(WindowStarts, positionsReadLaterThanTheCycleTellOfThatTime) {
  Trial trial = parabola();
  trial.positionAt[0] = 0.002;  // what was read at the cycle's time was shown 2 ms later
  EXPECT_NEAR(stateAt(trial, trial.signals[0], 100, 1e-3).position, 2.6 - 0.002 * 4.5 + 2 * 4e-6, 1e-7);
}

TEST(WindowStarts, theErrorOfAStateIsThatOfAFitToNoise) {
  // Seven readings at distance h about the start: variance of the slope is noise^2 / (28 h^2).
  const Trial trial = parabola();
  const MeasuredState state = stateAt(trial, trial.signals[0], 100, 1e-3);
  EXPECT_NEAR(std::sqrt(state.covariance(1, 1)), 1e-3 / (0.01 * std::sqrt(28.0)), 1e-6);
}

TEST(WindowStarts, nextToAGapNothingIsKnown) {
  Trial trial = parabola();
  for (std::size_t k = 97; k < 104; ++k)
    trial.signals[0].values[k] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(stateAt(trial, trial.signals[0], 100, 1e-3).speed));
}

TEST(WindowStarts, windowsFollowEachOtherAndHoldTwelveCyclesAtLeast) {
  const Trial trial = parabola();
  const std::vector<double> noises(trial.signals.size(), 1e-3);
  const std::vector<Window> windows = windowsIn(trial, 0.2, noises), shorter = windowsIn(trial, 0.05, noises);
  ASSERT_GE(windows.size(), 2U);
  EXPECT_GE(trial.time[windows[0].from], 0.3);
  for (std::size_t w = 1; w < windows.size(); ++w) {
    EXPECT_GE(windows[w].from, windows[w - 1].to);
    EXPECT_LE(windows[w].from, windows[w - 1].to + 10);  // half a window
  }
  EXPECT_EQ(windows[0].to - windows[0].from, 20U);
  EXPECT_EQ(shorter[0].to - shorter[0].from, 12U);
}

TEST(WindowStarts, noWindowBeginsWhereTheSpeedJumps) {
  Trial trial = parabola();
  const std::vector<double> noises(trial.signals.size(), 1e-3);
  const std::size_t jump = windowsIn(trial, 0.2, noises)[1].from;
  for (std::size_t k = jump; k < trial.cycles(); ++k)
    trial.signals[0].values[k] += 5 * (trial.time[k] - trial.time[jump]);
  for (const Window& window : windowsIn(trial, 0.2, noises))
    EXPECT_TRUE(window.from + 3 <= jump || window.from >= jump + 3) << window.from << " " << jump;
}

TEST(WindowStarts, aReplayGoesOnFromTheShiftedMeasuredState) {
  const Trial trial = parabola();
  const std::vector<Window> windows = windowsIn(trial, 0.2, std::vector<double>(trial.signals.size(), 1e-3));
  const Trial restarted = restartedAt(windows, trial, {.position = 0.01, .speed = 0.5});
  ASSERT_EQ(restarted.restarts.size(), windows.size());
  EXPECT_EQ(restarted.restarts[1].cycle, windows[1].from);
  EXPECT_NEAR(restarted.restarts[1].position[0], windows[1].starts[0].position + 0.01, 1e-12);
  EXPECT_NEAR(restarted.restarts[1].speed[0], windows[1].starts[0].speed + 0.5, 1e-12);
}

}  // namespace plumbline::gap
