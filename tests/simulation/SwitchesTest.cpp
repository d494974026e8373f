// The league server's accidents, one switch each: what it does on, and off.
#include <gtest/gtest.h>

#include "ServerFixture.h"
#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simulation/Simulation.h"
#include "simulation/league/LocalRobot.h"
#include "simulation/league/MakeWorld.h"
#include "simulation/referee/rules/SelfCollision.h"

namespace plumbline::simulation {
namespace {

TEST(Switches, allAreOnByDefault) {
  const WorldConfig config;
  EXPECT_TRUE(config.bouncingJointStops && config.sleepingRobots && config.endlessFriction &&
              config.lastingCommands && config.actionDelay && Rules().of<simulation::SelfCollision>().on);
  EXPECT_FALSE(config.selfCollision) << "the league's server has it off in effect";
}

/// Least head yaw in the last second of two of turning it into its stop at 120 degrees [deg].
double leastYawAtStop(const WorldConfig& config) {
  LocalRobot robot(simsparkRobot(0), config);
  JointArray speeds{};
  speeds[headYaw] = 6;
  double least = 360;
  for (int i = 0; i < 100; ++i) {
    robot.act(speeds);
    if (i > 50) least = std::min(least, toDegrees(robot.sense().angle[headYaw]));
  }
  return least;
}

TEST(Switches, bouncingStops) {
  WorldConfig config;
  EXPECT_LT(leastYawAtStop(config), 118) << "it comes back from its stop for ever";
  config.bouncingJointStops = false;
  EXPECT_NEAR(leastYawAtStop(config), 120, 1);
}

TEST(Switches, sleepingRobots) {
  for (const bool on : {true, false}) {
    WorldConfig config;
    config.sleepingRobots = on;
    LocalRobot robot(simsparkRobot(0), config);
    for (int i = 0; i < 60; ++i) robot.act({});
    robot.world().moveRobot(robot.robot(), translation(0, 0, 1));
    for (int i = 0; i < 10; ++i) robot.act({});
    EXPECT_EQ(robot.torso().pose.translation().z() == 1, on) << "asleep it hangs in the air";
  }
}

TEST(Switches, lastingCommands) {
  for (const bool on : {true, false}) {
    WorldConfig config;
    config.lastingCommands = on;
    const auto world = makeWorld(config);
    const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 0, 0.4));
    world->setJointVelocity(robot, headYaw, 1);
    for (int i = 0; i < 10; ++i) world->step();
    EXPECT_NEAR(world->readings(robot).angle[headYaw], on ? 0.2 : 0.02, 1e-4);
  }
}

TEST(Switches, endlessFriction) {
  double tilt[2];
  for (const bool on : {true, false}) {
    WorldConfig config;
    config.endlessFriction = on;
    config.frictionCoefficient = 0.05;
    LocalRobot robot(simsparkRobot(0), config);
    for (int i = 0; i < 20; ++i) robot.act({});
    JointArray apart{};
    apart[lHipRoll] = 0.5;
    apart[rHipRoll] = -0.5;
    for (int i = 0; i < 50; ++i) robot.act(apart);
    // The legs are spread by half a radian each: on ice the feet slide apart, on the league's floor they
    // creep.
    tilt[on] =
        robot.world().linkState(robot.robot(), robot.model().linkIndex("lFoot")).pose.translation().y() -
        robot.world().linkState(robot.robot(), robot.model().linkIndex("rFoot")).pose.translation().y();
  }
  EXPECT_GT(std::abs(tilt[0] - tilt[1]), 0.005);
}

TEST(Switches, actionDelayOfALocalRobot) {
  WorldConfig config;
  config.actionDelay = false;
  LocalRobot robot(simsparkRobot(0), config);
  for (int i = 0; i < 20; ++i) robot.act({});
  JointArray speeds{};
  speeds[headYaw] = 2;
  robot.act(speeds);
  EXPECT_NEAR(robot.sense().angle[headYaw], 0.04, 1e-5) << "in the next message";
}

/// Messages from an answer to that which shows it.
int delayOverTheWire(bool actionDelay) {
  ServerConfig config = test::inStep();
  config.simulation.world.actionDelay = actionDelay;
  test::RunningServer server(config);
  test::TestAgent agent(server.agentPort(), 0, "Red", 1);
  simspark::AgentCommand idle, turn;
  idle.syn = turn.syn = true;
  turn.velocity[headYaw] = 2;
  const auto headYawNow = [&agent] {
    simspark::ServerMessage message;
    EXPECT_FALSE(simspark::parseServerMessage(agent.receive(), message));
    return message.angle[headYaw].value_or(0);
  };
  for (int i = 0; i < 20; ++i) {
    headYawNow();
    agent.send(idle);
  }
  for (int i = 0; i < 10; ++i) {
    if (headYawNow() > 0.01) return i;
    agent.send(turn);
  }
  return -1;
}

TEST(Switches, actionDelayOverTheWire) {
  EXPECT_EQ(delayOverTheWire(true), 2);
  EXPECT_EQ(delayOverTheWire(false), 1);
}

/// A player whose right forearm is pushed into its chest, as it was done on the league's server, whose angles
/// these are; by the cycle after kick-off.
class Forearm {
public:
  explicit Forearm(bool freezes) : simulation_(configOf(freezes)) {
    id_ = simulation_.addPlayer(0);
    simspark::AgentCommand init;
    init.init = simspark::InitRequest{1, "Red"};
    simulation_.act(id_, init);
    for (int i = 0; i < 100; ++i) simulation_.step();
    simulation_.train(simspark::PlayModeCommand{simspark::PlayMode::playOn});
  }

  void push(int cycles) {
    const std::pair<JointId, double> targets[] = {{rShoulderPitch, fromDegrees(84)},
                                                  {rShoulderRoll, fromDegrees(1)},
                                                  {rElbowYaw, fromDegrees(-24)},
                                                  {rElbowRoll, fromDegrees(49.5)}};
    for (int i = 0; i < cycles; ++i) {
      simspark::AgentCommand command;
      for (const auto& [joint, target] : targets)
        command.velocity[joint] = std::clamp(8 * (target - angle(joint)), -2.0, 2.0);
      simulation_.act(id_, command);
      simulation_.step();
    }
  }
  double angle(JointId joint) { return simulation_.world().readings(robot()).angle[joint]; }
  RobotHandle robot() { return simulation_.allPlayers().at(id_)->robot; }

private:
  static SimulationConfig configOf(bool freezes) {
    SimulationConfig config;
    config.rules.of<simulation::SelfCollision>().on = freezes;
    return config;
  }
  Simulation simulation_;
  PlayerId id_ = 0;
};

TEST(Switches, frozenLimbs) {
  Forearm frozen(true);
  frozen.push(50);
  EXPECT_NEAR(toDegrees(frozen.angle(rShoulderPitch)), 71, 2.5) << "the league's stands at 71.04";
  frozen.push(20);
  EXPECT_NEAR(toDegrees(frozen.angle(rShoulderPitch)), 71, 2.5);
  frozen.push(60);
  EXPECT_NEAR(toDegrees(frozen.angle(rShoulderPitch)), 84, 0.1) << "after a second it obeys, for two";
  Forearm free(false);
  free.push(50);
  EXPECT_GT(toDegrees(free.angle(rShoulderPitch)), 83);
}

}  // namespace
}  // namespace plumbline::simulation
