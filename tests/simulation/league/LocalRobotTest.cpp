#include "simulation/league/LocalRobot.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simulation/ArmIntoTorso.h"

namespace plumbline::simulation {
namespace {

TEST(LocalRobot, anAnswerShowsInTheMessageAfterTheNext) {
  LocalRobot robot(simsparkRobot(0));
  JointArray speeds{};
  for (int i = 0; i < 20; ++i) robot.act(speeds);
  speeds[headYaw] = 2;
  EXPECT_NEAR(robot.sense().angle[headYaw], 0, 1e-9);  // message i
  robot.act(speeds);
  EXPECT_NEAR(robot.sense().angle[headYaw], 0, 1e-9);  // i + 1
  robot.act({});
  EXPECT_NEAR(robot.sense().angle[headYaw], 0.04, 1e-5);  // i + 2
  robot.act({});
  EXPECT_NEAR(robot.sense().angle[headYaw], 0.04, 1e-5);
  EXPECT_NEAR(robot.time(), 23 * 0.02, 1e-12);
}

TEST(LocalRobot, restartsOnItsFeetInAnyPosture) {
  LocalRobot robot(simsparkRobot(3));
  JointArray bent{};
  for (const Side side : {Side::left, Side::right}) {
    const int hip = firstLegJoint(side) + 2;
    bent[static_cast<std::size_t>(hip)] = -0.5;
    bent[static_cast<std::size_t>(hip) + 1] = 1;
    bent[static_cast<std::size_t>(hip) + 2] = -0.5;
  }
  robot.restart(Pose2(-3, 2, 1.5), bent);
  const double before = robot.torso().pose.translation().z();
  for (int i = 0; i < 50; ++i) robot.act({});
  EXPECT_NEAR(robot.torso().pose.translation().z(), before, 0.002) << "it stood from the start";
  EXPECT_NEAR(robot.torso().pose.translation().x(), -3, 0.01);
  EXPECT_NEAR(robot.sense().angle[lKneePitch], 1, 1e-4);
  EXPECT_FALSE(robot.fallen());
}

TEST(LocalRobot, fallsAndIsSetUpAgain) {
  LocalRobot robot(simsparkRobot(0));
  JointArray lean{};
  lean[lAnklePitch] = lean[rAnklePitch] = -0.6;
  for (int i = 0; i < 60; ++i) robot.act(lean);
  for (int i = 0; i < 60; ++i) robot.act({});
  EXPECT_TRUE(robot.fallen());
  robot.restart();
  EXPECT_FALSE(robot.fallen());
  EXPECT_EQ(robot.time(), 0);
}

TEST(LocalRobot, limbsThatPassThroughEachOtherFreeze) {
  LocalRobot robot(simsparkRobot(0));
  EXPECT_FALSE(robot.overlaps());
  const JointArray angles = test::armIntoTorso();
  robot.restart(Pose2(), angles);
  EXPECT_TRUE(robot.overlaps());
  EXPECT_TRUE(robot.frozen().none());
  JointArray speeds{};
  speeds[lElbowRoll] = speeds[rElbowRoll] = 0.2;
  robot.act(speeds);
  EXPECT_EQ(robot.frozen().count(), 4u) << "the arm";
  for (int i = 0; i < 50; ++i) robot.act(speeds);
  EXPECT_NEAR(robot.sense().angle[lElbowRoll], angles[lElbowRoll], 0.01) << "a second long";
  EXPECT_GT(robot.sense().angle[rElbowRoll], 0.15);
  for (int i = 0; i < 50; ++i) robot.act(speeds);
  EXPECT_GT(robot.sense().angle[lElbowRoll], angles[lElbowRoll] + 0.15);
  robot.restart();
  EXPECT_TRUE(robot.frozen().none());
}

TEST(LocalRobot, startsLying) {
  LocalRobot robot(simsparkRobot(0));
  robot.restart(translation(0, 0, 0.1) * rotationY(pi / 2), {});
  for (int i = 0; i < 50; ++i) robot.act({});
  EXPECT_TRUE(robot.fallen());
  EXPECT_LT(robot.torso().pose.translation().z(), 0.3);
}

TEST(LocalRobot, aRestartForgetsEverything) {
  const auto story = [](LocalRobot& robot) {
    JointArray speeds{};
    speeds[lKneePitch] = 1.5;
    for (int i = 0; i < 40; ++i) robot.act(speeds);
    return robot.torso().pose.matrix();
  };
  LocalRobot robot(simsparkRobot(1));
  const auto first = story(robot);
  robot.restart();
  EXPECT_EQ(story(robot), first);
}

}  // namespace
}  // namespace plumbline::simulation
