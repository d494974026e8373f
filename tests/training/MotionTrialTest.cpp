#include "training/MotionTrial.h"

#include <gtest/gtest.h>

#include <csignal>

#include "framework/StopSignal.h"

namespace plumbline::training {
namespace {

TEST(MotionTrial, aPushMakesAWalkingRobotFallTheWayItGoes) {
  MotionTrial trial(0);
  int falls = 0, wanted = 0;
  for (unsigned seed = 1; falls < 6; ++seed) {
    ASSERT_LT(seed, 100U) << "its walk withstands most pushes, not all";
    trial.seed(seed);
    if (!trial.stumble(1)) continue;
    ++falls;
    EXPECT_TRUE(trial.lying());
    wanted += motion::lyingOn(trial.up()) == motion::LyingOn::front;
  }
  EXPECT_GE(wanted, 4);
}

TEST(MotionTrial, aStateCanBeBegunWithAgain) {
  MotionTrial trial(0), other(0);
  trial.seed(3);
  trial.fall(-1);
  MotionTrial::State state = trial.state();
  EXPECT_GT(state.torso.linearVelocity.norm() + state.torso.angularVelocity.norm(), 0);
  for (MotionTrial* one : {&trial, &other}) {
    one->begin(state);
    for (int i = 0; i < 10; ++i) one->step(one->stand);
  }
  EXPECT_EQ(trial.torsoPose().matrix(), other.torsoPose().matrix());
  state.stop();
  other.begin(state);
  EXPECT_EQ(other.robot.torso().linearVelocity, Vec3::Zero());
  EXPECT_EQ(other.robot.torso().angularVelocity, Vec3::Zero());
}

TEST(MotionTrial, aStopEndsATry) {
  MotionTrial trial(0);
  StopSignal stop;
  stop.catchSignals();
  trial.fall(1);
  raise(SIGTERM);
  EXPECT_THROW(trial.fall(1), Stopped);
}

}  // namespace
}  // namespace plumbline::training
