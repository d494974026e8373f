#include "training/WalkChoice.h"

#include <gtest/gtest.h>

#include "training/SprintingWalk.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

ChoiceSetup quick() {
  ChoiceSetup setup;
  setup.minutes = 1;
  setup.tries = 2;
  setup.trySeconds = 3;
  setup.holds = 1;
  setup.holdSeconds = 4;
  return setup;
}

TEST(WalkChoice, aSlowerMixtureLeavesFullSpeedsAlone) {
  const walking::WalkGaits slow = slowMixture(sprintingWalk(), 0.5);
  EXPECT_EQ(slow.base.speed.omniForward, 0.1);
  EXPECT_EQ(slow.corner[2].speed.omniSideways, 0.05);
  EXPECT_EQ(slow.base.speed.maxForward, 0.6);
}

TEST(WalkChoice, aSprintThatMakesTheRobotFallIsCutOrLeftAway) {
  // Slow steps at 1.5 m/s: beyond what legs can do.
  walking::WalkGaits gaits = plainWalk();
  for (walking::WalkParameters* p :
       {&gaits.base, &gaits.corner[0], &gaits.corner[1], &gaits.corner[2], &gaits.corner[3]}) {
    p->speed.omniForward = 0.1;
    p->speed.maxForward = 1.5;
    p->step.maxForward = 0.3;
    p->sprint.riseTime = 1;
  }
  WalkingRobot robot(0, gaits);
  const ChoiceSetup setup = quick();
  EXPECT_FALSE(sprintHolds(robot, gaits, WalkTrialKind::forward, setup));
  EXPECT_TRUE(sprintHolds(robot, cutSprint(gaits, WalkTrialKind::forward, 0), WalkTrialKind::forward, setup));
  std::string said;
  const walking::WalkGaits chosen = chooseSprint(robot, gaits, {gaits}, WalkTrialKind::forward, setup,
                                                 [&](const std::string& line) { said += line; });
  EXPECT_LT(chosen.base.speed.maxForward, 1.5);
  EXPECT_GE(chosen.base.speed.maxForward, 0.1);
  EXPECT_TRUE(sprintHolds(robot, chosen, WalkTrialKind::forward, setup));
  EXPECT_NE(said.find("forward"), std::string::npos);
}

TEST(WalkChoice, theSameSeedChoosesTheSame) {
  const walking::WalkGaits gaits = plainWalk();
  WalkingRobot robot(3, gaits), again(3, gaits);
  const ChoiceSetup setup = quick();
  EXPECT_EQ(randomFalls(robot, gaits, setup, 1), randomFalls(again, gaits, setup, 1));
}

}  // namespace
}  // namespace plumbline::training
