#include "training/WalkTrial.h"

#include <gtest/gtest.h>

#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

WalkTrialResult tried(const walking::WalkGaits& gaits, const WalkTrialSetup& setup) {
  WalkingRobot robot(3, gaits);
  return tryWalk(robot, gaits, WalkTrialKind::forward, setup);
}

TEST(WalkTrial, aSteadyWalkLeansLittle) {
  const WalkTrialResult result = tried(readLeagueGaits(3), {.seed = 5, .tries = 3, .seconds = 4, .push = 0});
  EXPECT_EQ(result.falls, 0);
  EXPECT_GT(result.lean, 0.05);
  EXPECT_LT(result.lean, 0.4);
}

TEST(WalkTrial, aFallCountsAsALeanOfOne) {
  walking::WalkGaits gaits = plainWalk();
  gaits.base.speed.omniForward = 0.1;
  gaits.base.speed.maxForward = 1.5;
  gaits.base.step.maxForward = 0.3;
  for (walking::WalkParameters& corner : gaits.corner) corner = gaits.base;
  WalkTrialSetup setup{.seed = 5, .tries = 4, .seconds = 4, .push = 3, .stopEarly = false};
  const WalkTrialResult fallen = tried(gaits, setup);
  ASSERT_EQ(fallen.falls, 1);
  EXPECT_NEAR(fallen.lean, 1, 1e-12);
  setup.stopEarly = true;
  EXPECT_NEAR(tried(gaits, setup).lean, 1, 1e-12);
}

TEST(WalkTrial, aCutSprintIsTriedBesideTheWholeOne) {
  WalkTrialSetup setup{.seed = 5, .tries = 2, .seconds = 3, .push = 0};
  const walking::WalkGaits gaits = readLeagueGaits(3);
  const WalkTrialResult alone = tried(gaits, setup);
  setup.alsoCut = true;
  const WalkTrialResult both = tried(gaits, setup);
  EXPECT_EQ(both.speed, alone.speed);
  EXPECT_EQ(both.falls, alone.falls);
  EXPECT_GT(both.lean, alone.lean + 0.05);
  EXPECT_LT(both.lean, alone.lean + 0.4);
}

}  // namespace
}  // namespace plumbline::training
