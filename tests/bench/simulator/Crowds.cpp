#include <fstream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "Bending.h"
#include "Figures.h"
#include "simspark/Connection.h"
#include "simspark/SimulatorProcess.h"

namespace plumbline::bench {

namespace {

using simspark::AgentCommand;
using simspark::Connection;

const std::string statistics = "build/bench/simulator.account";

/// What is known of the league's server with as many agents in step and a monitor: CPU per cycle [us],
/// largest resident memory [MB], speed [x real time].
struct Size {
  int robots;
  double leagueCpu, leagueMemory;
  json cpuTarget = nullptr, leagueSpeed = nullptr, memoryTarget = nullptr;
};
const Size sizes[] = {
    {1, 430, 31, nullptr, 52}, {2, 840, 32}, {4, 1420, 32}, {11, 6700, 35}, {22, 16000, 43, 5000, 0.43, 150}};

/// Reads whatever a monitor gets until the simulator ends.
void watch(int port) {
  Connection monitor;
  if (!monitor.connect("127.0.0.1", port).empty()) return;
  for (std::string_view text; monitor.receive(text, 60) == Connection::Status::message;) {
  }
}

std::unique_ptr<Connection> join(int port, int type) {
  auto agent = std::make_unique<Connection>();
  if (const auto error = agent->connect("127.0.0.1", port); !error.empty()) throw std::runtime_error(error);
  AgentCommand scene;
  scene.scene = simspark::SceneRequest{.type = type};
  scene.syn = true;
  agent->send(simspark::writeAgentCommand(scene));
  return agent;
}

/// So many cycles of a game in which everybody bends the knees; the simulator's own account of them, and its
/// memory [MB].
json play(int robots, int cycles, const std::string& engine) {
  simspark::SimulatorProcess simulator(
      "bin/simulator",
      {"--sync", "--seed", "1", "--wait-agents", std::to_string(robots), "--kickoff-after", "2", "--stats",
       statistics, "--die-with-parent", "--engine", engine},
      "build/bench/simulator.ports", "build/bench/simulator.out");
  std::thread monitor(watch, simulator.ports().monitor);
  std::vector<std::unique_ptr<Connection>> agents;
  for (int i = 0; i < robots; ++i)
    agents.push_back(join(simulator.ports().agent, teamTypes[static_cast<std::size_t>(i / 2)]));
  for (int cycle = 0; cycle < cycles; ++cycle)
    for (int i = 0; i < robots; ++i) {
      Connection& agent = *agents[static_cast<std::size_t>(i)];
      std::string_view message;
      if (agent.receive(message, 60) != Connection::Status::message)
        throw std::runtime_error("the simulator is gone: " + agent.error());
      AgentCommand answer = bending(cycle);
      if (cycle == 0) answer.init = simspark::InitRequest{i / 2 + 1, i % 2 ? "Blue" : "Red"};
      agent.send(simspark::writeAgentCommand(answer));
    }
  simulator.process().stop(10);
  monitor.join();
  std::ifstream file(statistics);
  json account = json::parse(file);
  account["memory"] = simulator.process().usage().maxResidentMegabytes;
  return account;
}

}  // namespace

void measureCrowds(Figures& figures, int cycles) {
  const auto measure = [&](int robots, const std::string& engine) {
    return play(robots, std::max(200, cycles / (robots * robots)), engine);
  };
  for (const Size& size : sizes) {
    const json account = measure(size.robots, "ode");
    const std::string n = std::to_string(size.robots);
    figures.add("cycle_cpu_us_" + n, account["cpu_us_per_cycle"], "us", "lower", size.cpuTarget,
                Peer{size.leagueCpu});
    figures.add("x_real_time_" + n, account["x_real_time"], "x", "higher", nullptr, Peer{size.leagueSpeed});
    figures.add("memory_mb_" + n, account["memory"], "MB", "lower", size.memoryTarget,
                Peer{size.leagueMemory});
  }
  for (const int robots : {1, 22}) {
    const json account = measure(robots, "bullet");
    const std::string n = "_bullet_" + std::to_string(robots);
    figures.add("cycle_cpu_us" + n, account["cpu_us_per_cycle"], "us", "lower");
    figures.add("x_real_time" + n, account["x_real_time"], "x", "higher");
    figures.add("memory_mb" + n, account["memory"], "MB", "lower");
  }
}

}  // namespace plumbline::bench
