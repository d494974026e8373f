#include "gap/inference/Stretches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::gap {
namespace {

/// Ten seconds of one joint at 100 Hz whose command is this function of time.
template <class Command>
Trial trialWith(Command command) {
  Trial trial;
  trial.command.resize(1);
  Signal position;
  position.name = "pos.knee";
  position.joint = 0;
  for (int k = 0; k < 1000; ++k) {
    trial.time.push_back(0.01 * k);
    trial.command[0].push_back(command(0.01 * k));
    position.values.push_back(trial.command[0].back());
  }
  trial.signals.push_back(position);
  return trial;
}

TEST(Stretches, theFirstThreeTenthsOfASecondAreNotScored) {
  EXPECT_EQ(firstScored(trialWith([](double) { return 0.0; })), 30u);
}

TEST(Stretches, aJointAtRestIsCutByTime) {
  const Trial trial = trialWith([](double) { return 0.2; });
  EXPECT_EQ(stretchesOf(trial, 4), (std::vector<std::size_t>{30, 273, 515, 758, 1000}));
}

TEST(Stretches, motionThatGoesOnIsCutByTimeNearly) {
  const std::vector<std::size_t> bounds = stretchesOf(trialWith([](double t) { return std::sin(6 * t); }), 4);
  const std::vector<std::size_t> byTime{30, 273, 515, 758, 1000};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(static_cast<double>(bounds[i]), byTime[i], 15);
}

TEST(Stretches, aRampOfFourTenthsOfASecondIsInThreeOfFour) {
  const Trial trial = trialWith([](double t) { return std::clamp(2.5 * (t - 2), 0.0, 1.0); });
  const std::vector<std::size_t> bounds = stretchesOf(trial, 4);
  int with = 0;
  for (std::size_t i = 0; i < 4; ++i)
    with += trial.command[0][bounds[i + 1] - 1] - trial.command[0][bounds[i]] > 0.1;
  EXPECT_EQ(with, 3);
}

TEST(Stretches, readingsThatAreMissingDoNotCountAsTravel) {
  Trial trial = trialWith([](double) { return 0.2; });
  trial.signals[0].values[500] = std::nan("");
  EXPECT_EQ(stretchesOf(trial, 2), (std::vector<std::size_t>{30, 515, 1000}));
}

TEST(Stretches, aTrialShorterThanItsStartHasEmptyStretches) {
  Trial trial = trialWith([](double) { return 0.2; });
  trial.time.resize(10);
  trial.command[0].resize(10);
  trial.signals[0].values.resize(10);
  EXPECT_EQ(stretchesOf(trial, 2), (std::vector<std::size_t>{10, 10, 10}));
}

}  // namespace
}  // namespace plumbline::gap
