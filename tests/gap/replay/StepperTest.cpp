#include "gap/replay/Stepper.h"

#include <gtest/gtest.h>

#include "../LegOnItsFoot.h"

namespace plumbline::gap {
namespace {

/// A leg on a small sole that its knee tips over, for so many cycles, with the true pose of its body.
Trial tipping(int cycles) {
  Mechanism leg = legOnItsFoot();
  leg.feet[0].soleSize = Vec3(0.02, 0.02, 0);
  Trial trial = armTrial(leg, 0.01 * cycles + 0.005, 0);
  trial.freeBase = true;
  for (std::size_t k = 20; k < trial.cycles(); ++k) trial.command[1][k] = 0.3;
  Signal truth{"truth", SignalKind::truth, -1, -1, 0, false, std::vector<double>(trial.cycles())};
  for (int axis = 0; axis < 7; ++axis) {
    truth.axis = axis;
    trial.signals.push_back(truth);
  }
  return trial;
}

Prediction tipped(const Trial& trial) { return replay(nominalPlant(*trial.robot), trial); }

// A body whose upright axis is half as high as it is long leans by 60 degrees.
TEST(Stepper, aBodyThatLeansByMoreThanSixtyDegreesHasFallen) {
  const Trial whole = tipping(300);
  const Prediction all = tipped(whole);
  const std::size_t first = whole.signals.size() - 7;
  int fallen = 0;
  const auto upright = [&](int cycle) {
    const auto axis = [&](std::size_t i) { return all.values[first + i][static_cast<std::size_t>(cycle)]; };
    return 1 - 2 * (axis(4) * axis(4) + axis(5) * axis(5));
  };
  while (fallen < 299 && !(upright(fallen) < 0.5)) ++fallen;
  ASSERT_GT(fallen, 5);
  ASSERT_LT(fallen, 290) << "it tips over " << upright(299);
  ASSERT_GT(upright(fallen + 1), 0.4) << "and is not down at once";
  EXPECT_FALSE(tipped(tipping(fallen - 1)).fell);
  EXPECT_TRUE(tipped(tipping(fallen + 2)).fell);
}

}  // namespace
}  // namespace plumbline::gap
