// Whole games: 22 agents through the sockets, in step, from the first kick-off to the end; and their
// repetition.
#include <gtest/gtest.h>

#include "ServerFixture.h"
#include "simspark/TrainerCommand.h"
#include "support/FarOff.h"

namespace plumbline::simulation {
namespace {

using simspark::AgentCommand;
using test::inStep;
using test::RunningServer;
using test::TestAgent;

constexpr int types[] = {0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4};

std::vector<std::unique_ptr<TestAgent>> twoTeams(int port, int players) {
  std::vector<std::unique_ptr<TestAgent>> agents;
  for (int i = 0; i < players; ++i)
    agents.push_back(std::make_unique<TestAgent>(port, types[i / 2], i % 2 ? "Blue" : "Red", i / 2 + 1));
  return agents;
}

TEST(Game, twentyTwoPlayTwoHalvesToTheEnd) {
  ServerConfig config = inStep(22);
  config.simulation.rules.time.half = 1.5;
  config.simulation.rules.kickOff.after = 0.1;
  RunningServer server(config);
  auto agents = twoTeams(server.agentPort(), 22);
  std::vector<std::string> modes;
  std::string last;
  for (int cycle = 0; cycle < 400 && (modes.empty() || modes.back() != "GameOver"); ++cycle) {
    for (auto& agent : agents) {
      last = agent->play(1);
      ASSERT_EQ(last.find("gone"), std::string::npos) << cycle;
    }
    simspark::ServerMessage message;
    ASSERT_FALSE(simspark::parseServerMessage(last.substr(0, last.size() - 1), message));
    const std::string mode(message.gameState.playMode);
    if (modes.empty() || modes.back() != mode) modes.push_back(mode);
  }
  EXPECT_EQ(modes, (std::vector<std::string>{"BeforeKickOff", "KickOff_Left", "BeforeKickOff",
                                             "KickOff_Right", "GameOver"}));
  EXPECT_NE(last.find("(t 3.0"), std::string::npos) << last;
}

TEST(Game, mayEndTheSimulatorTenSecondsLater) {
  ServerConfig config = inStep(1);
  config.simulation.rules.time.half = 0.2;
  config.simulation.rules.time.quitAfterGame = true;
  config.simulation.rules.kickOff.after = 0;
  RunningServer server(config);
  TestAgent agent(server.agentPort(), 0, "Red", 1);
  std::string all = agent.play(100);
  AgentCommand done;
  done.syn = true;
  std::string_view text;
  EXPECT_TRUE(comesTrue([&] {
    while (agent.connection.receive(text, 0.01) == simspark::Connection::Status::message) agent.send(done);
    return server.ended();
  }));
  server.join();
  EXPECT_NE(all.find("(pm GameOver)"), std::string::npos);
  EXPECT_NEAR(server.statistics().simulatedSeconds, 10.5, 0.2);
}

/// A game in this process, in which everybody moves and talks.
std::string play(Simulation& simulation, const std::vector<PlayerId>& players) {
  std::string all;
  for (int cycle = 0; cycle < 60; ++cycle) {
    if (cycle == 20) simulation.train(simspark::KickOffCommand{TeamSide::none});
    if (cycle == 40) simulation.train(simspark::DropBallCommand{});
    for (const PlayerId id : players) {
      AgentCommand command;
      command.velocity[rKneePitch] = id % 2 ? 0.7 : -0.3;
      command.velocity[headYaw] = 0.1 * id;
      if (cycle == 10) command.beam = Pose2(-0.3 * id, 1, 0.1);
      simulation.act(id, command);
    }
    simulation.step();
    for (const PlayerId id : players) all += simulation.message(id);
  }
  return all;
}

std::vector<PlayerId> join(Simulation& simulation, int players) {
  std::vector<PlayerId> ids;
  for (int i = 0; i < players; ++i) {
    ids.push_back(simulation.addPlayer(types[i / 2]));
    AgentCommand command;
    command.init = simspark::InitRequest{i / 2 + 1, i % 2 ? "Blue" : "Red"};
    EXPECT_EQ(simulation.act(ids.back(), command), "");
  }
  return ids;
}

class Repetition : public testing::TestWithParam<int> {};

TEST_P(Repetition, freshStartsAndResetsAreTheSameToTheByte) {
  SimulationConfig config;
  config.seed = 5;
  Simulation first(config), second(config);
  const std::string game = play(first, join(first, GetParam()));
  EXPECT_GT(game.size(), 10000u);
  EXPECT_TRUE(game == play(second, join(second, GetParam()))) << "another fresh start";
  first.reset();
  EXPECT_TRUE(game == play(first, join(first, GetParam()))) << "after a reset";
  std::vector<PlayerId> ids;
  for (const auto& [old, id] : first.restart()) ids.push_back(id);
  EXPECT_EQ(first.time(), 0);
  EXPECT_TRUE(game == play(first, ids)) << "after a reset with everybody there";
  ids.clear();
  for (const auto& [old, id] : first.restart(6)) ids.push_back(id);
  EXPECT_FALSE(game == play(first, ids)) << "another seed";
}

INSTANTIATE_TEST_SUITE_P(Of, Repetition, testing::Values(1, 11, 22));

TEST(Reset, whoLeftIsForgotten) {
  Simulation simulation(SimulationConfig{});
  const auto ids = join(simulation, 4);
  simulation.train(simspark::PlayModeCommand{PlayMode::playOn});
  for (int i = 0; i < 5; ++i) simulation.step();
  simulation.removePlayer(ids[0]);
  simulation.removePlayer(ids[3]);
  const auto renamed = simulation.restart();
  EXPECT_EQ(renamed, (std::map<PlayerId, PlayerId>{{ids[1], 1}, {ids[2], 2}}));
  EXPECT_EQ(simulation.game().mode, PlayMode::beforeKickOff);
  EXPECT_EQ(simulation.game().teams, (std::array<std::string, 2>{"Blue", "Red"})) << "in the order of coming";
  EXPECT_EQ(simulation.numPlayers(), 2u);
  simulation.step();
  const auto& player = *simulation.allPlayers().at(2);
  EXPECT_EQ(player.side, TeamSide::right);
  EXPECT_EQ(player.unum, 2);
}

TEST(Reset, byATrainerThroughTheSockets) {
  ServerConfig config = inStep(3);
  config.simulation.rules.kickOff.after = 0.2;
  RunningServer server(config);
  auto agents = twoTeams(server.agentPort(), 3);
  simspark::Connection trainer;
  ASSERT_EQ(trainer.connect("127.0.0.1", server.monitorPort()), "");
  std::string_view scene;
  const auto cycle = [&] {
    std::string all;
    for (auto& agent : agents) all += agent->play(1);
    return all;
  };
  /// From the reset on: the message with which time begins anew, and those after it.
  const auto game = [&] {
    trainer.send("(reset)");
    std::string all = cycle();
    for (int i = 0; i < 200 && all.find("(now 0.04)") == std::string::npos; ++i) all = cycle();
    for (int i = 0; i < 40; ++i) all += cycle();
    return all;
  };
  ASSERT_EQ(trainer.receive(scene, 10), simspark::Connection::Status::message);
  for (int i = 0; i < 30; ++i) cycle();
  const std::string first = game();
  EXPECT_NE(first.find("(unum 2) (team left)"), std::string::npos);
  EXPECT_NE(first.find("KickOff_Left"), std::string::npos);
  EXPECT_EQ(first.find("gone"), std::string::npos);
  EXPECT_TRUE(first == game());
}

TEST(Leaving, aRobotThatIsKilledOrVanishesLeavesNoTraceInTheGame) {
  Simulation simulation(SimulationConfig{});
  auto ids = join(simulation, 6);
  simulation.train(simspark::PlayModeCommand{PlayMode::playOn});
  simulation.step();
  const Vec3 foot = simulation.world().torso(simulation.allPlayers().at(ids[2])->robot).pose.translation();
  simulation.train(simspark::BallCommand{Vec3(foot.x() + 0.05, foot.y(), 0.3), Vec3::Zero()});
  simulation.step();
  simulation.train(simspark::KillCommand{simspark::PlayerName{2, TeamSide::left}});  // it touched the ball
  EXPECT_EQ(simulation.takeKilled(), std::vector<PlayerId>{ids[2]});
  simulation.removePlayer(ids[5]);
  simulation.train(simspark::BallCommand{Vec3(0, 10.2, 0.042), Vec3::Zero()});
  for (int i = 0; i < 60; ++i) simulation.step();
  EXPECT_EQ(simulation.game().mode, PlayMode::kickInRight) << "the ball's last touch still counts";
  EXPECT_EQ(simulation.numPlayers(), 4u);
  const PlayerId next = simulation.addPlayer(2);
  AgentCommand command;
  command.init = simspark::InitRequest{2, "Red"};
  EXPECT_EQ(simulation.act(next, command), "") << "its number is free again";
  for (int i = 0; i < 10; ++i) simulation.step();
}

}  // namespace
}  // namespace plumbline::simulation
