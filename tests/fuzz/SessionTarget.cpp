// A whole game in this process, driven by what agents and trainers send.
#include <array>
#include <cmath>
#include <optional>

#include "fuzz/Targets.h"
#include "simspark/FieldMessage.h"
#include "simspark/LeagueRobots.h"
#include "simspark/SceneState.h"
#include "simspark/ServerMessageParser.h"
#include "simulation/Simulation.h"
#include "simulation/monitor/MonitorScene.h"
#include "simulation/server/FieldPort.h"

namespace plumbline::fuzz {

using namespace simulation;

namespace {

constexpr int maxSteps = 40;

struct Table {
  SimulationConfig config;
  Simulation simulation{config};
  std::array<std::optional<PlayerId>, 4> players;
  simspark::AgentCommandParser agentParser;
  simspark::TrainerCommandParser trainerParser;
  MonitorScene scene;

  void agent(std::size_t who, std::string_view text) {
    simspark::AgentCommand command;
    agentParser.parse(text, command);
    auto& player = players[who];
    if (command.scene && !player && command.scene->type >= 0 && command.scene->type < numSimsparkTypes())
      player = simulation.addPlayer(command.scene->type);
    if (player) simulation.act(*player, command);
  }

  void trainer(std::string_view text) {
    std::vector<simspark::TrainerCommand> commands;
    trainerParser.parse(text, commands);
    for (const auto& command : commands) simulation.train(command);
    for (const PlayerId id : simulation.takeKilled()) {
      simulation.removePlayer(id);
      for (auto& player : players)
        if (player == id) player.reset();
    }
  }

  void step() {
    simulation.step();
    for (const auto& player : players) {
      if (!player || simulation.message(*player).empty()) continue;
      simspark::ServerMessage message;
      const auto problem = simspark::parseServerMessage(simulation.message(*player), message);
      require(!problem, "an agent gets what it cannot read");
    }
  }

  /// What monitors get at the end.
  void look() {
    simspark::SceneState state;
    require(state.update(scene.full(simulation)).empty(), "monitors get what they cannot read");
    simspark::FieldState field;
    require(simspark::readFieldMessage(fieldMessage(simulation), field).empty(),
            "the compact port tells nonsense");
  }
};

}  // namespace

/// Lines "0 message" to "3 message" to four agents, "t message" to the trainer's port, "." a cycle.
void session(std::string_view bytes) {
  Table table;
  int steps = 0;
  for (std::size_t begin = 0; begin < bytes.size() && steps < maxSteps;) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const std::string_view line = bytes.substr(begin, end - begin);
    begin = end + 1;
    if (line.empty()) continue;
    const char who = line.front();
    if (who == '.') {
      table.step();
      ++steps;
    } else if (who == 't') {
      table.trainer(line.substr(1));
    } else if (who >= '0' && who <= '3') {
      table.agent(static_cast<std::size_t>(who - '0'), line.substr(1));
    }
  }
  if (steps < maxSteps) table.step();
  table.look();
}

std::vector<std::string> sessionSeeds() {
  const std::string two =
      "0(scene rsg/agent/nao/nao_hetero.rsg 0)\n1(scene rsg/agent/nao/nao_hetero.rsg 4)\n.\n"
      "0(init (unum 1)(teamname A))\n1(init (unum 2)(teamname B))\n.\n0(beam -1 0 0)\n1(beam -3 1 90)\n.\n";
  return {
      two + "t(playMode PlayOn)\n0(he1 2)(lle4 -1)(say hello)\n.\n1(rle5 3)(pass)\n.\n.\n.\n",
      two +
          "t(ball (pos 1 2 0.5)(vel 3 0 1))(kickOff Left)\n.\n.\nt(agent (unum 1)(team Left)(move 3 1 0.4 "
          "90))\n.\n"
          "t(kill (unum 2)(team Right))\n.\n",
      two +
          "2(scene rsg/agent/nao/nao_hetero.rsg 2)\n3(scene rsg/agent/nao/nao_hetero.rsg 3)\n.\n"
          "2(init (unum 0)(teamname A))\n.\nt(score (left 1)(right 2))(time 299.99)(dropBall)\n.\n.\nt(time "
          "600)\n.\n",
      two +
          "t(agent (unum 1)(team Left)(pos 0 0 0.4))(agent (unum 2)(team Right)(pos 0 0.1 0.4))\n.\n.\n.\n.\n"
          "t(repos (unum 1)(team Left))(select (unum 1)(team Left))\n.\n"};
}

namespace {
const Registered sessionTarget({"session", session, sessionSeeds, 400});
}  // namespace

}  // namespace plumbline::fuzz
