#include "simulation/Simulation.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>

#include "math/Angle.h"
#include "simspark/ServerMessageParser.h"
#include "support/Samples.h"

namespace plumbline::simulation {
namespace {

using simspark::AgentCommand;
using simspark::ServerMessage;

ServerMessage sensed(const Simulation& simulation, PlayerId id) {
  ServerMessage message;
  const auto error = simspark::parseServerMessage(simulation.message(id), message);
  EXPECT_FALSE(error) << error->what;
  return message;
}

AgentCommand init(const std::string& team, int unum = 0) {
  AgentCommand command;
  command.init = simspark::InitRequest{unum, team};
  return command;
}

/// A message without its numbers, its image and what the ground makes of a robot's weight.
std::string shape(std::string message) {
  for (const char* node : {"(See", "(FRP"})
    for (std::size_t begin; (begin = message.find(node)) != std::string::npos;) {
      std::size_t end = begin;
      for (int depth = 0; depth > 0 || end == begin; ++end)
        depth += message[end] == '(' ? 1 : message[end] == ')' ? -1 : 0;
      message.erase(begin, end - begin);
    }
  std::string out;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const bool begins = message[i] == ' ' && i + 1 < message.size() &&
                        (std::isdigit(message[i + 1]) || message[i + 1] == '-');
    out += message[i];
    if (!begins) continue;
    const std::size_t end = message.find_first_of(" )", i + 1);
    const bool whole = message.substr(i, end - i).find('.') == std::string::npos;
    out += whole ? message.substr(i + 1, end - i - 1) : "#";
    i = end - 1;
  }
  return out;
}

class OfType : public testing::TestWithParam<int> {};

TEST_P(OfType, firstMessagesAreThoseOfTheLeaguesServer) {
  const auto recorded = test::samples("agent_type" + std::to_string(GetParam()));
  Simulation simulation(SimulationConfig{});
  const PlayerId id = simulation.addPlayer(GetParam());
  simulation.step();
  EXPECT_EQ(simulation.message(id), "") << "the first cycle makes none";
  simulation.step();
  EXPECT_TRUE(sensed(simulation, id).see) << "the next one has an image";
  simulation.step();
  EXPECT_EQ(simulation.act(id, init("TeamX")), "");
  // The recording begins here: free fall, put to its place, free fall, landing, in the accelerometer a cycle
  // late.
  for (int i = 0; i < 7; ++i) {
    if (i > 0) simulation.step();
    ServerMessage theirs;
    ASSERT_FALSE(simspark::parseServerMessage(recorded[std::size_t(i)], theirs));
    const ServerMessage ours = sensed(simulation, id);
    EXPECT_EQ(shape(simulation.message(id)), shape(recorded[std::size_t(i)])) << i;
    EXPECT_NEAR(ours.acc.z(), theirs.acc.z(), 0.0101) << i;
    EXPECT_NEAR(ours.acc.x(), theirs.acc.x(), 0.0101) << i;
    EXPECT_NEAR(ours.gyro.y(), theirs.gyro.y(), 2e-4) << i;
    EXPECT_EQ(ours.gameState.unum, theirs.gameState.unum) << i;
    EXPECT_EQ(ours.see.has_value(), theirs.see.has_value()) << i;
    EXPECT_EQ(ours.leftFoot.has_value(), theirs.leftFoot.has_value()) << i;
  }
}
INSTANTIATE_TEST_SUITE_P(Types, OfType, testing::Range(0, 5));

class Playing : public testing::Test {
protected:
  Playing() : simulation(config()) {
    id = simulation.addPlayer(0);
    steps(2);
    simulation.act(id, init("Red", 7));
    steps(100);
  }
  static SimulationConfig config() {
    SimulationConfig c;
    c.seed = 5;
    return c;
  }
  void steps(int n) {
    for (int i = 0; i < n; ++i) simulation.step();
  }
  Vec3 torso(PlayerId player) {
    return simulation.world().torso(simulation.allPlayers().at(player)->robot).pose.translation();
  }

  Simulation simulation;
  PlayerId id = 0;
};

TEST_F(Playing, placeIsSentOnce) {
  Simulation fresh(config());
  const PlayerId player = fresh.addPlayer(1);
  fresh.step();
  fresh.step();
  EXPECT_FALSE(sensed(fresh, player).gameState.unum);
  fresh.act(player, init("Red", 3));
  fresh.step();
  EXPECT_EQ(sensed(fresh, player).gameState.unum, 3);
  EXPECT_EQ(sensed(fresh, player).gameState.side, "left");
  fresh.step();
  EXPECT_FALSE(sensed(fresh, player).gameState.unum);
}

TEST_F(Playing, aSpeedPersistsUntilChangedAndTurnsExactly) {
  AgentCommand command;
  command.velocity[headYaw] = 2;
  simulation.act(id, command);
  for (int i = 1; i <= 10; ++i) {
    steps(1);
    EXPECT_NEAR(*sensed(simulation, id).angle[headYaw], 0.04 * i, 1e-3) << i;
  }
  command.velocity[headYaw] = -2;
  command.velocity[lToePitch] = 1;  // type 0 has none
  simulation.act(id, command);
  steps(5);
  EXPECT_NEAR(*sensed(simulation, id).angle[headYaw], 0.2, 2e-3);
}

TEST_F(Playing, beamGoesWhereItIsSentWithinTheNoise) {
  AgentCommand command;
  double spread = 0, turn = 0;
  for (int i = 0; i < 200; ++i) {
    command.beam = Pose2(-3, 2, 0.5);
    simulation.act(id, command);
    const BodyState body = simulation.world().torso(simulation.allPlayers().at(id)->robot);
    const Vec3 p = body.pose.translation();
    const double heading = std::atan2(body.pose.linear()(1, 0), body.pose.linear()(0, 0));
    EXPECT_LT(std::fabs(p.x() + 3), 0.05);
    EXPECT_LT(std::fabs(p.y() - 2), 0.05);
    EXPECT_LT(std::fabs(heading - 0.5), fromDegrees(10));
    EXPECT_NEAR(p.z(), 0.4, 1e-9);
    spread = std::max(spread, std::fabs(p.x() + 3));
    turn = std::max(turn, std::fabs(heading - 0.5));
  }
  EXPECT_GT(spread, 0.045);
  EXPECT_GT(turn, fromDegrees(9));
}

TEST_F(Playing, beamStaysInTheOwnHalfAndBeforeKickOff) {
  AgentCommand command;
  command.beam = Pose2(5, 20, 0);
  simulation.act(id, command);
  EXPECT_NEAR(torso(id).x(), 0, 1e-9);
  EXPECT_NEAR(torso(id).y(), 10, 1e-9);
  const PlayerId right = simulation.addPlayer(1);
  simulation.act(right, init("Blue"));
  command.beam = Pose2(-4, 1, 0);
  simulation.act(right, command);
  EXPECT_NEAR(torso(right).x(), 4, 0.05) << "seen by the right team";
  EXPECT_NEAR(torso(right).y(), -1, 0.05);
  EXPECT_LT(simulation.world().torso(simulation.allPlayers().at(right)->robot).pose.linear()(0, 0), -0.9)
      << "looks left";
  simulation.train(simspark::PlayModeCommand{PlayMode::playOn});
  command.beam = Pose2(-10, 0, 0);
  simulation.act(id, command);
  EXPECT_NEAR(torso(id).x(), 0, 1e-9) << "not while playing";
}

TEST_F(Playing, startPlacesAreARow) {
  EXPECT_NEAR(torso(id).x(), -14.2, 0.02);
  EXPECT_NEAR(torso(id).y(), 9.2, 0.02);
  const PlayerId next = simulation.addPlayer(2);
  simulation.act(next, init("Red"));
  EXPECT_NEAR(torso(next).y(), 8.0, 1e-9);
  const PlayerId other = simulation.addPlayer(2);
  simulation.act(other, init("Blue"));
  EXPECT_NEAR(torso(other).x(), 14.2, 1e-9);
}

TEST_F(Playing, refusedPlacesAreNamed) {
  const PlayerId second = simulation.addPlayer(0);
  EXPECT_EQ(simulation.act(second, init("Red", 7)), "team Red: number 7 is taken");
  steps(3);
  EXPECT_FALSE(sensed(simulation, second).gameState.unum);
  EXPECT_EQ(simulation.act(second, init("Red", 8)), "");
  EXPECT_EQ(simulation.act(second, init("Red", 9)), "team Red: this robot has its number already");
  simulation.removePlayer(second);
  const PlayerId third = simulation.addPlayer(0);
  EXPECT_EQ(simulation.act(third, init("Red", 8)), "") << "a number comes back";
}

TEST_F(Playing, wordsAreHeardByAllWithTheirDirection) {
  const PlayerId mate = simulation.addPlayer(1), enemy = simulation.addPlayer(1);
  simulation.act(mate, init("Red", 2));
  simulation.act(enemy, init("Blue", 2));
  steps(2);
  for (const auto& [player, unum, side, x, y] : {std::tuple{id, 7, TeamSide::left, -2.0, 0.0},
                                                 {mate, 2, TeamSide::left, -2.0, -1.0},
                                                 {enemy, 2, TeamSide::right, 3.0, 0.0}})
    simulation.train(simspark::MoveAgentCommand{simspark::PlayerName{unum, side}, Vec3(x, y, 0.4), 0});
  AgentCommand command;
  command.say = "hello";
  simulation.act(id, command);
  steps(1);
  ASSERT_EQ(sensed(simulation, id).heard.size(), 1u);
  EXPECT_TRUE(sensed(simulation, id).heard[0].self);
  const auto atMate = sensed(simulation, mate).heard;
  ASSERT_EQ(atMate.size(), 1u);
  EXPECT_EQ(atMate[0].team, "Red");
  EXPECT_EQ(atMate[0].text, "hello");
  EXPECT_NEAR(atMate[0].direction, pi / 2, 1e-3) << "in the field's frame, not the head's";
  const auto atEnemy = sensed(simulation, enemy).heard;
  ASSERT_EQ(atEnemy.size(), 1u);
  EXPECT_NEAR(atEnemy[0].direction, 0, 1e-3) << "the right team sees the field turned";
  simulation.train(simspark::MoveAgentCommand{simspark::PlayerName{2, TeamSide::right}, Vec3(50, 0, 0.4), 0});
  steps(1);
  simulation.act(id, command);
  steps(1);
  EXPECT_TRUE(sensed(simulation, enemy).heard.empty()) << "52 m are too far";
}

TEST_F(Playing, trainerMovesBallAndPlayers) {
  simulation.train(simspark::PlayModeCommand{PlayMode::playOn});
  EXPECT_EQ(simulation.train(simspark::BallCommand{Vec3(1, 2, 0.042), Vec3(3, 0, 0)}), "");
  EXPECT_EQ(simulation.world().ball().pose.translation(), Vec3(1, 2, 0.042));
  EXPECT_EQ(simulation.world().ball().linearVelocity, Vec3(3, 0, 0));
  EXPECT_EQ(simulation.train(simspark::BallCommand{Vec3(4, 2, 0.042), {}}), "");
  EXPECT_EQ(simulation.world().ball().linearVelocity, Vec3(3, 0, 0)) << "a position alone keeps the speed";
  const simspark::PlayerName me{7, TeamSide::left};
  simulation.train(simspark::MoveAgentCommand{me, Vec3(1, 1, 0.5), pi / 2});
  EXPECT_LT((torso(id) - Vec3(1, 1, 0.5)).norm(), 1e-9);
  simulation.train(simspark::MoveAgentCommand{me, Vec3(2, 1, 0.5), {}});
  EXPECT_NEAR(simulation.world().torso(simulation.allPlayers().at(id)->robot).pose.linear()(1, 0), 1, 1e-9);
  EXPECT_EQ(simulation.train(
                simspark::MoveAgentCommand{simspark::PlayerName{8, TeamSide::left}, Vec3(1, 1, 1), {}}),
            "trainer: no such player");
  simulation.train(simspark::TimeCommand{12});
  simulation.train(simspark::ScoreCommand{3, 4});
  EXPECT_EQ(simulation.game().time, 12);
  EXPECT_EQ(simulation.game().score[1], 4);
}

TEST_F(Playing, selectAndKill) {
  const PlayerId second = simulation.addPlayer(1);
  simulation.act(second, init("Blue", 4));
  EXPECT_EQ(simulation.train(simspark::KillCommand{}), "trainer: no such player") << "nobody is selected";
  simulation.train(simspark::SelectCommand{});
  EXPECT_TRUE(simulation.allPlayers().at(id)->selected);
  simulation.train(simspark::SelectCommand{});
  EXPECT_TRUE(simulation.allPlayers().at(second)->selected);
  EXPECT_FALSE(simulation.allPlayers().at(id)->selected);
  EXPECT_EQ(simulation.train(simspark::KillCommand{}), "");
  EXPECT_EQ(simulation.takeKilled(), std::vector<PlayerId>{second});
  EXPECT_TRUE(simulation.takeKilled().empty());
  EXPECT_EQ(simulation.numPlayers(), 1u);
  simulation.train(simspark::RepositionCommand{simspark::PlayerName{7, TeamSide::left}});
  EXPECT_LT((torso(id) - Vec3(0, -10.5, 1)).norm(), 1e-9) << "beside the field";
}

TEST_F(Playing, groundTruthIsTheTruth) {
  SimulationConfig c = config();
  c.players.groundTruth = true;
  c.players.groundTruthDecimals = 6;
  Simulation open(c);
  const PlayerId player = open.addPlayer(0);
  open.act(player, init("Red", 7));
  for (int i = 0; i < 10; ++i) open.step();
  const auto truth = sensed(open, player).groundTruth;
  ASSERT_TRUE(truth);
  const BodyState body = open.world().torso(open.allPlayers().at(player)->robot);
  EXPECT_TRUE(truth->T_world_torso.isApprox(body.pose, 1e-5));
  EXPECT_LT((truth->ball - open.world().ball().pose.translation()).norm(), 1e-5);
  ASSERT_EQ(truth->players.size(), 1u);
  EXPECT_EQ(truth->players[0].unum, 7);
  EXPECT_FALSE(sensed(simulation, id).groundTruth) << "only if asked for";
}

std::string transcript(Simulation& simulation) {
  std::string all;
  std::vector<PlayerId> players;
  for (int i = 0; i < 4; ++i) {
    players.push_back(simulation.addPlayer(i));
    simulation.act(players.back(), init(i % 2 ? "Red" : "Blue"));
  }
  simulation.step();
  for (int cycle = 0; cycle < 120; ++cycle) {
    for (const PlayerId player : players) {
      AgentCommand command;
      if (cycle == 3) command.beam = Pose2(-2, 2 * player, 0);
      command.velocity[rKneePitch] = std::sin(0.3 * cycle + player);
      command.velocity[headYaw] = 1.0 - cycle % 3;
      command.say = "x" + std::to_string(player);
      simulation.act(player, command);
    }
    if (cycle == 50) simulation.train(simspark::KickOffCommand{TeamSide::none});
    simulation.step();
    for (const PlayerId player : players) all += simulation.message(player) + '\n';
  }
  return all;
}

TEST(Simulation, sameSeedSameBytesAgainAndAfterAReset) {
  SimulationConfig config;
  config.seed = 11;
  Simulation first(config), second(config);
  const std::string all = transcript(first);
  EXPECT_EQ(all, transcript(second));
  first.reset();
  EXPECT_EQ(first.time(), 0);
  EXPECT_EQ(all, transcript(first));
  config.seed = 12;
  Simulation other(config);
  EXPECT_NE(all, transcript(other));
}

TEST(Simulation, twentyTwoPlay) {
  Simulation simulation(SimulationConfig{});
  const int types[] = {0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4};
  for (const char* team : {"Red", "Blue"})
    for (const int type : types) ASSERT_EQ(simulation.act(simulation.addPlayer(type), init(team)), "");
  for (int i = 0; i < 10; ++i) simulation.step();
  for (const auto& [id, player] : simulation.allPlayers())
    EXPECT_FALSE(sensed(simulation, id).see && sensed(simulation, id).see->players.empty());
  EXPECT_EQ(simulation.numPlayers(), 22u);
}

TEST(Simulation, robotsThatComeTogetherDoNotTouch) {
  Simulation simulation(SimulationConfig{});
  std::vector<PlayerId> players;
  for (int i = 0; i < 22; ++i) players.push_back(simulation.addPlayer(i % 5));
  const auto place = [&](PlayerId id) -> Vec3 {
    return simulation.world().torso(simulation.allPlayers().at(id)->robot).pose.translation();
  };
  EXPECT_EQ(place(players[0]), Vec3(0, -1, 1.5)) << "the league's spawn";
  EXPECT_NEAR(place(players[1]).x(), 1, 1e-9);
  EXPECT_NEAR(place(players[2]).x(), -1, 1e-9);
  for (int i = 0; i < 5; ++i) simulation.step();
  for (const PlayerId id : players)
    for (const auto& angle : sensed(simulation, id).angle) EXPECT_NEAR(angle.value_or(0), 0, 1e-3);
}

TEST(Simulation, aGoalIsScored) {
  Simulation simulation(SimulationConfig{});
  const PlayerId id = simulation.addPlayer(0);
  simulation.act(id, init("Red"));
  simulation.train(simspark::PlayModeCommand{PlayMode::playOn});
  simulation.train(simspark::BallCommand{Vec3(13, 0.2, 0.042), Vec3(8, 0, 0)});
  int cycles = 0;
  while (simulation.game().mode == PlayMode::playOn && cycles < 200) {
    simulation.step();
    ++cycles;
  }
  EXPECT_EQ(simulation.game().mode, PlayMode::goalLeft);
  EXPECT_EQ(simulation.game().score[0], 1);
  EXPECT_LT(cycles, 60);
}

}  // namespace
}  // namespace plumbline::simulation
