#include "training/tasks/BeforeKick.h"

#include <gtest/gtest.h>

#include "training/MotionTrial.h"

namespace plumbline::training {
namespace {

TEST(BeforeKick, aRobotComesToRestAfterAWalkOrASway) {
  MotionTrial trial(4);
  int came = 0, walked = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    trial.robot.restart(Pose2(), trial.stand);
    trial.restarted();
    trial.seed(seed);
    if (!comesToKick(trial)) continue;
    ++came;
    walked += trial.torsoPose().translation().head<2>().norm() > 0.05;
    EXPECT_LT(trial.tilt(), 0.3);
    EXPECT_FALSE(trial.lying());
  }
  EXPECT_GE(came, 18);
  EXPECT_GE(walked, 6);
  EXPECT_LE(walked, 18);
}

}  // namespace
}  // namespace plumbline::training
