#include "training/ServerTrial.h"

#include <gtest/gtest.h>

#include "simulation/ServerFixture.h"
#include "training/tasks/BeforeKick.h"
#include "training/tasks/WalkOn.h"

namespace plumbline::training {
namespace {

TEST(ServerTrial, fallsAndStandsUpThereAsHere) {
  test::RunningServer server(test::inStep());
  ServerTrial trial(4, {"127.0.0.1", server.agentPort(), server.monitorPort()});
  for (const int direction : {1, -1}) {
    const std::string motion = direction > 0 ? "standUpFront" : "standUpBack";
    int up = 0, falls = 0;
    for (unsigned seed = 1; falls < 5; ++seed) {
      ASSERT_LT(seed, 40U) << "it seldom falls as wanted";
      trial.seed(seed);
      if (!trial.fall(direction)) continue;
      ++falls;
      EXPECT_TRUE(trial.lying());
      EXPECT_EQ(trial.nextStandUp().name, motion + "Fast");
      trial.play(trial.motion(motion));
      WalkOn walk(trial);
      walk.begin(trial.player.angles());
      while (!walk.isOver()) walk.step();
      up += walk.upright();
    }
    EXPECT_GE(up, 3) << motion;
  }
}

TEST(ServerTrial, comesToRestBeforeAKick) {
  test::RunningServer server(test::inStep());
  ServerTrial trial(0, {"127.0.0.1", server.agentPort(), server.monitorPort()});
  int came = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    trial.standAt(Pose2(-10, 5, 0));
    EXPECT_FALSE(trial.lying());
    trial.seed(seed);
    came += comesToKick(trial);
  }
  EXPECT_GE(came, 4);
}

}  // namespace
}  // namespace plumbline::training
