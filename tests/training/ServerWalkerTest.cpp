#include "training/ServerWalker.h"

#include <gtest/gtest.h>

#include "simulation/ServerFixture.h"
#include "training/WalkTrial.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

SimSparkAddress of(const test::RunningServer& server) {
  return {"127.0.0.1", server.agentPort(), server.monitorPort()};
}

TEST(ServerWalker, walksThereAsItDoesHere) {
  test::RunningServer server(test::inStep());
  const walking::WalkGaits gaits = readLeagueGaits(0);
  const walking::WalkRequest forward{Vec2(0.3, 0), 0, true};
  WalkingRobot here(0, gaits);
  ServerWalker there(0, gaits, of(server));
  for (Walker* robot : {static_cast<Walker*>(&here), static_cast<Walker*>(&there)}) {
    robot->restart(Pose2(-3, 2, 1));
    EXPECT_NEAR(robot->pose().x(), -3, 0.05);
    EXPECT_NEAR(robot->pose().y(), 2, 0.05);
    EXPECT_NEAR(robot->pose().heading, 1, 0.05);
    EXPECT_TRUE(robot->run({}, 0.5));
    EXPECT_TRUE(robot->run(forward, 10));
  }
  const auto way = [](Walker& robot) { return (robot.pose().position - Vec2(-3, 2)).norm(); };
  EXPECT_GT(way(here), 2.5);
  EXPECT_NEAR(way(there), way(here), 0.15);
}

TEST(ServerWalker, standsUpAgainAfterAFall) {
  test::RunningServer server(test::inStep());
  ServerWalker robot(3, readLeagueGaits(3), of(server));
  walking::WalkGaits wild = readLeagueGaits(3);
  wild.base.posture.torsoPitch = 0.6;
  for (walking::WalkParameters& corner : wild.corner) corner.posture.torsoPitch = 0.6;
  robot.use(wild);
  EXPECT_FALSE(robot.run({Vec2(9, 0), 0, true}, 10)) << "bent so far forward nobody walks fast";
  robot.use(readLeagueGaits(3));
  EXPECT_TRUE(robot.run({Vec2(0.3, 0), 0, true}, 3));
}

TEST(ServerWalker, isHeldInLapsOfTheField) {
  test::RunningServer server(test::inStep());
  ServerWalker there(0, readLeagueGaits(0), of(server));
  WalkingRobot here(0, readLeagueGaits(0));
  for (const WalkTrialKind task :
       {WalkTrialKind::forward, WalkTrialKind::backward, WalkTrialKind::sideways, WalkTrialKind::turn})
    for (const double sign : {-1.0, 1.0}) {
      const walking::WalkRequest full = fullSpeed(task, sign);
      const HeldSpeed far = holdSpeed(there, full, 40, 0.3, 0), near = holdSpeed(here, full, 40, 0.3, 0);
      EXPECT_TRUE(far.upright);
      EXPECT_NEAR(far.speed, near.speed, 0.03 * near.speed);
    }
}

TEST(ServerWalker, saysWhatAServerCannot) {
  EXPECT_THROW(ServerWalker(0, readLeagueGaits(0), {"127.0.0.1", 1, 1}), std::runtime_error);
  auto server = std::make_unique<test::RunningServer>(test::inStep());
  ServerWalker robot(0, readLeagueGaits(0), of(*server));
  EXPECT_THROW(robot.push(Vec3::UnitX()), std::logic_error);
  EXPECT_FALSE(robot.carries());
  EXPECT_THROW(robot.carry(Vec2::Zero()), std::logic_error);
  EXPECT_THROW(robot.comVelocity(), std::logic_error);
  server.reset();
  EXPECT_THROW(robot.run({}, 20), std::runtime_error);
}

}  // namespace
}  // namespace plumbline::training
