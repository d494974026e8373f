#include "training/ServerRobot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/GroundPose.h"
#include "simspark/LeagueRobots.h"
#include "simulation/ArmIntoTorso.h"
#include "simulation/ServerFixture.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

std::string refusal(const std::string& text) {
  try {
    SimSparkAddress::parse(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SimSparkAddress, isReadOrRefused) {
  const SimSparkAddress usual = SimSparkAddress::parse("server");
  EXPECT_EQ(usual.text(), "127.0.0.1:3100:3200");
  EXPECT_EQ(SimSparkAddress::parse("field.example:4100:4200").text(), "field.example:4100:4200");
  for (const char* bad : {"", "host", "host:3100", ":3100:3200", "host::3200", "host:3100:0", "host:3100:x",
                          "host:3100:3200 ", "host:70000:3200"})
    EXPECT_EQ(refusal(bad),
              "'" + std::string(bad) + "' is not a server; write HOST:AGENTPORT:MONITORPORT or 'server'");
}

JointArray standOf(int type) {
  const RobotModel model = simsparkRobot(type);
  return walking::WalkEngine(readLeagueGaits(type), model).stand().angles;
}

TEST(ServerRobot, standsWhereItIsPutAndSensesIt) {
  test::RunningServer server(test::inStep());
  ServerRobot robot(4, {"127.0.0.1", server.agentPort(), server.monitorPort()});
  const JointArray stand = standOf(4);
  robot.put(Pose2(-3, 2, 1), stand);
  const Pose2 place = groundPose(robot.torso());
  EXPECT_NEAR(place.x(), -3, 0.05);
  EXPECT_NEAR(place.y(), 2, 0.05);
  EXPECT_NEAR(place.heading, 1, 0.05);
  EXPECT_NEAR(robot.readings().angle[lKneePitch], stand[lKneePitch], 0.02);
  EXPECT_LT(robot.readings().gyro.norm(), 0.1);
  ASSERT_TRUE(robot.readings().leftFoot);
  EXPECT_GT(robot.readings().leftFoot->force.z(), 5);
  EXPECT_NEAR(robot.attitude().up().z(), 1, 0.01);
  EXPECT_TRUE(robot.playsOn());
  robot.putBall(Vec2(1, -2));
  for (int i = 0; i < 5; ++i) robot.drive(stand);
  EXPECT_NEAR((robot.ball() - Vec3(1, -2, 0.042)).norm(), 0, 0.01);
}

TEST(ServerRobot, isDroppedFromAHeightAndReplacedAfterAFall) {
  test::RunningServer server(test::inStep());
  ServerRobot robot(0, {"127.0.0.1", server.agentPort(), server.monitorPort()});
  JointArray leaning = standOf(0);
  for (const JointId joint : {lAnklePitch, rAnklePitch}) leaning[joint] -= 0.7;
  robot.drop(Pose2(), leaning, 0.1);
  robot.drive(leaning);
  for (int i = 0; i < 100; ++i) robot.drive(leaning);
  EXPECT_LT(robot.torso().linear()(2, 2), 0.5) << "nobody stands like this";
  EXPECT_LT(robot.torso().linear()(2, 0), 0) << "nor falls backward";
  robot.put(Pose2(), standOf(0));
  EXPECT_GT(robot.torso().linear()(2, 2), 0.99);
}

// The referee's memory of frozen joints does not outlive a start: the clock is set back at each.
TEST(ServerRobot, startsWithFreeJoints) {
  test::RunningServer server(test::inStep());
  ServerRobot robot(0, {"127.0.0.1", server.agentPort(), server.monitorPort()});
  const JointArray stand = standOf(0);
  robot.put(Pose2(), stand);
  for (int i = 0; i < 200; ++i) robot.drive(stand);  // the clock goes on
  JointArray inTorso = stand;
  for (const JointId joint : {lShoulderRoll, lShoulderPitch, lElbowYaw, lElbowRoll})
    inTorso[joint] = test::armIntoTorso()[joint];
  for (int i = 0; i < 25; ++i) robot.drive(inTorso);
  robot.put(Pose2(), stand);
  JointArray raised = stand;
  raised[lShoulderPitch] = stand[lShoulderPitch] - 0.5;
  for (int i = 0; i < 25; ++i) robot.drive(raised);
  EXPECT_NEAR(robot.readings().angle[lShoulderPitch], raised[lShoulderPitch], 0.05);
}

TEST(ServerRobot, saysThatThereIsNoServer) {
  try {
    ServerRobot(0, {"127.0.0.1", 1, 1});
    FAIL() << "there is no such server";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("; start bin/simulator --sync or the league's server first"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace plumbline::training
