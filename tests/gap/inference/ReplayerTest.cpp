#include "gap/inference/Replayer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../DutyTrial.h"

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

}  // namespace plumbline::gap
