// What the simulator costs: bin/simulator in step with one agent and with 22, and its parts in this process.
// Prints a table and writes build/bench/simulator.json. One argument: cycles with one agent (15000).
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "simspark/AgentCommand.h"
#include "simspark/Connection.h"
#include "simspark/ServerMessageParser.h"
#include "simspark/SimulatorProcess.h"
#include "simulation/Simulation.h"
#include "simulation/monitor/MonitorScene.h"
#include "support/Samples.h"

namespace plumbline {
namespace {

using nlohmann::json;
using simspark::AgentCommand;

double cpuMicroseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

double cpuPerCall(int calls, const std::function<void()>& call) {
  const double before = cpuMicroseconds();
  for (int i = 0; i < calls; ++i) call();
  return (cpuMicroseconds() - before) / calls;
}

/// Knees that bend and stretch twice a second, so that the robot never comes to rest and the physics has
/// work.
AgentCommand bending(int cycle) {
  AgentCommand command;
  const double speed = 1.2 * std::sin(0.02 * cycle * 2 * 3.14159 * 2);
  for (const int leg : {static_cast<int>(lHipYawPitch), static_cast<int>(rHipYawPitch)}) {
    command.velocity[static_cast<std::size_t>(leg + lHipPitch - lHipYawPitch)] = -speed / 2;
    command.velocity[static_cast<std::size_t>(leg + lKneePitch - lHipYawPitch)] = speed;
    command.velocity[static_cast<std::size_t>(leg + lAnklePitch - lHipYawPitch)] = -speed / 2;
  }
  command.velocity[headYaw] = std::sin(0.1 * cycle);
  command.syn = true;
  return command;
}

struct Team {
  const char* name;
  std::vector<int> types;
};

/// Plays so many cycles with bin/simulator; its own account of the cost.
json play(const std::vector<Team>& teams, int cycles) {
  const std::string statistics = "build/bench/simulator.stats.json";
  int players = 0;
  for (const Team& team : teams) players += static_cast<int>(team.types.size());
  {
    simspark::SimulatorProcess simulator("bin/simulator",
                                         {"--sync", "--seed", "1", "--wait-agents", std::to_string(players),
                                          "--stats", statistics, "--die-with-parent"},
                                         "build/bench/simulator.ports.json", "build/bench/simulator.out");
    std::vector<std::unique_ptr<simspark::Connection>> agents;
    std::vector<AgentCommand> hello;
    for (const Team& team : teams)
      for (std::size_t i = 0; i < team.types.size(); ++i) {
        agents.push_back(std::make_unique<simspark::Connection>());
        if (const auto error = agents.back()->connect("127.0.0.1", simulator.ports().agent); !error.empty())
          throw std::runtime_error(error);
        AgentCommand scene;
        scene.scene = simspark::SceneRequest{.type = team.types[i]};
        scene.syn = true;
        agents.back()->send(simspark::writeAgentCommand(scene));
        AgentCommand init;
        init.syn = true;
        init.init = simspark::InitRequest{static_cast<int>(i) + 1, team.name};
        hello.push_back(init);
      }
    for (int cycle = 0; cycle < cycles; ++cycle) {
      const std::string text = simspark::writeAgentCommand(bending(cycle));
      for (std::size_t i = 0; i < agents.size(); ++i) {
        std::string_view message;
        if (agents[i]->receive(message, 60) != simspark::Connection::Status::message)
          throw std::runtime_error("the simulator is gone: " + agents[i]->error());
        agents[i]->send(cycle == 0 ? simspark::writeAgentCommand(hello[i]) : text);
      }
    }
    simulator.process().stop(10);
  }
  std::ifstream file(statistics);
  return json::parse(file);
}

json figure(const std::string& name, double value, const std::string& unit, const std::string& better,
            json target = {}, json peer = {}) {
  json result = {{"name", "simulator." + name}, {"value", value}, {"unit", unit}, {"better", better}};
  if (!target.is_null()) result["target"] = target;
  if (!peer.is_null()) {
    result["peer"] = "rcssserver3d 0.7.3";
    result["peer_value"] = peer;
  }
  return result;
}

/// One robot in this process: the physics alone, and what comes on top of it.
void addParts(json& figures) {
  simulation::Simulation whole{simulation::SimulationConfig{}};
  const simulation::PlayerId id = whole.addPlayer(0);
  AgentCommand init;
  init.init = simspark::InitRequest{1, "Red"};
  whole.act(id, init);
  for (int i = 0; i < 100; ++i) whole.step();
  double all = 0, physics = 0;
  int cycle = 0;
  for (int round = 0; round < 60; ++round) {  // taken in turns, so that both see the same robot
    all += cpuPerCall(50,
                      [&] {
                        whole.act(id, bending(cycle++));
                        whole.step();
                      }) /
           60;
    physics += cpuPerCall(50,
                          [&] {
                            whole.act(id, bending(cycle++));
                            whole.world().step();
                          }) /
               60;
  }
  figures.push_back(figure("physics_us", physics, "us", "lower"));
  figures.push_back(figure("senses_and_rules_us", all - physics, "us", "lower", 30));

  simulation::MonitorScene scene;
  figures.push_back(figure("monitor_scene_us", cpuPerCall(500, [&] { scene.full(whole); }), "us", "lower"));
  double difference = 0;
  for (int i = 0; i < 500; ++i) {
    whole.act(id, bending(cycle++));
    whole.step();
    difference += cpuPerCall(1, [&] { scene.difference(whole); }) / 500;
  }
  figures.push_back(figure("monitor_difference_us", difference, "us", "lower"));
}

void addWire(json& figures) {
  simspark::ServerMessage message;
  const auto longest = [](const char* sample) {
    const auto all = test::samples(sample);
    return *std::max_element(all.begin(), all.end(),
                             [](const auto& a, const auto& b) { return a.size() < b.size(); });
  };
  const std::string alone = longest("agent_type0"), crowd = longest("agent_game_22_players");
  figures.push_back(figure("parse_message_us",
                           cpuPerCall(5000, [&] { simspark::parseServerMessage(alone, message); }), "us",
                           "lower", 60));
  figures.push_back(figure("parse_message_of_22_us",
                           cpuPerCall(5000, [&] { simspark::parseServerMessage(crowd, message); }), "us",
                           "lower"));
  const std::string text = simspark::writeAgentCommand(bending(7));
  simspark::AgentCommandParser parser;
  AgentCommand command;
  figures.push_back(
      figure("parse_command_us", cpuPerCall(20000, [&] { parser.parse(text, command); }), "us", "lower"));
}

int run(int cycles) {
  json figures = json::array();
  const json one = play({{"Red", {0}}}, cycles);
  figures.push_back(figure("cycle_cpu_us", one["cpu_us_per_cycle"], "us", "lower", 220, 360));
  figures.push_back(figure("x_real_time", one["x_real_time"], "x", "higher", 80, 52));
  const std::vector<int> types = {0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4};
  const json full = play({{"Red", types}, {"Blue", types}}, std::max(100, cycles / 30));
  figures.push_back(figure("cycle_cpu_us_22", full["cpu_us_per_cycle"], "us", "lower", {}, 14600));
  addParts(figures);
  addWire(figures);

  std::ofstream("build/bench/simulator.json") << figures.dump(1) << '\n';
  for (const json& f : figures)
    std::printf("%-36s %10.2f %s\n", f["name"].get<std::string>().c_str(), f["value"].get<double>(),
                f["unit"].get<std::string>().c_str());
  return 0;
}

}  // namespace
}  // namespace plumbline

int main(int argc, char** argv) {
  try {
    return plumbline::run(argc > 1 ? std::atoi(argv[1]) : 15000);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "SimulatorBench: %s\n", problem.what());
    return 1;
  }
}
