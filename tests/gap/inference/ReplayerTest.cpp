#include "gap/inference/Replayer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../DutyTrial.h"
#include "../LegOnItsFoot.h"
#include "../ThreeRecordings.h"

namespace plumbline::gap {

TEST(Replayer, theDutyOfAMotorThatIsOffIsNotPredicted) {
  Trial trial = dutyTrial({}, 2, 5e-4);
  const std::size_t half = trial.cycles() / 2;
  trial.stiffness.assign(1, std::vector<double>(trial.cycles(), 1));
  for (std::size_t k = half; k < trial.cycles(); ++k) trial.stiffness[0][k] = 0;
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const Groups groups({trial});
  const Residuals residuals = Replayer(pendulum, groups, 1).residuals({});
  const ResidualSeries& duty = *residuals[0].back();
  EXPECT_TRUE(std::isfinite(duty[half / 2]));
  EXPECT_TRUE(std::isnan(duty[half + half / 2]));
}

TEST(Replayer, aDutyWorkedOutAMillisecondEarlierIsNoGap) {
  Trial trial = dutyTrial({}, 2, 0);
  Signal& duty = trial.signals.back();
  const std::vector<double> exact = duty.values;
  for (std::size_t k = 0; k < trial.cycles(); ++k)
    duty.values[k] -= 1e-3 * rateAt(trial, trial.signals.back(), k);
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  double shifted = 0, left = 0;
  const Groups groups({trial});
  const Residuals residuals = Replayer(pendulum, groups, 1).residuals({});
  // In the sines, where nothing jumps.
  for (std::size_t k = 35; k < 60; ++k) {
    shifted += std::pow(duty.values[k] - exact[k], 2);
    left += std::pow((*residuals[0].back())[k], 2);
  }
  EXPECT_LT(left, 0.1 * shifted);
}

TEST(Replayer, aBaseIsInEveryHypothesis) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}, 2));
  const Cause friction = causeOfArm("coulomb_friction", "elbow", 0.2),
              force = causeOfArm("bias_force", "shoulder", 0.3);
  const Replayer plain(arm, groups, 1), with(plain, groups, {friction});
  const Residuals both = plain.residuals({friction, force}), one = plain.residuals({friction});
  EXPECT_EQ((*with.residuals({force})[0][1])[50], (*both[0][1])[50]);
  EXPECT_EQ((*with.residuals({})[0][1])[50], (*one[0][1])[50]);
  EXPECT_NE((*plain.residuals({})[0][1])[50], (*one[0][1])[50]);
  // For other groups it keeps it.
  EXPECT_EQ(Replayer(with, groups).base(), Explanation{friction});
}

TEST(Replayer, aGearDoesNotShortenTheStepsOfARobotOnItsFoot) {
  // Else any gear would explain what long steps do wrong.
  const Mechanism leg = legOnItsFoot();
  Trial trial = recorded(plantOf(leg, {}), legTrial(true, 2), 0, 3);
  const Groups groups({trial});
  const Cause none = causeOf(leg, "joint_compliance", "knee", 1e-9);
  const Replayer replayer(leg, groups, 1);
  const Residuals with = replayer.residuals({none}), nominal = replayer.residuals({});
  for (std::size_t k = 100; k < 150; ++k) EXPECT_NEAR((*with[0][0])[k], (*nominal[0][0])[k], 2e-6);
}

}  // namespace plumbline::gap
