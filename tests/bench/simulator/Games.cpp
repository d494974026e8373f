#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "Figures.h"
#include "framework/SteadyClock.h"
#include "simspark/ChildProcess.h"
#include "simspark/Connection.h"
#include "simspark/SimulatorProcess.h"

namespace plumbline::bench {

namespace {

using simspark::ChildProcess;

const std::string folder = "build/bench/", accountFile = folder + "simulator.account";
constexpr int types[] = {0, 4, 4, 1, 4, 0, 3, 1, 3, 4, 0};

std::string agentStatistics(int i) { return folder + "simulator.agent" + std::to_string(i) + ".account"; }

struct Account {
  json simulator;
  double speed = 0;         ///< of the game clock [x real time]
  double agentCpu = 0;      ///< mean of the agents [us per cycle]
  double allAgentsCpu = 0;  ///< of all agents together [us per cycle]
  double firstCycle = 0;    ///< of an agent, mean [us]
  double agentCycles = 0;   ///< of the agent that played the fewest
  double memory = 0;        ///< [MB]
};

/// How fast the game clock goes from its first second to the simulator's end, as a monitor sees it.
double clockSpeed(int monitorPort) {
  simspark::Connection monitor;
  if (const auto error = monitor.connect("127.0.0.1", monitorPort); !error.empty())
    throw std::runtime_error(error);
  monitor.send("(viewer 0.02)");  // so that looking costs little
  double firstWall = 0, firstGame = 0, game = 0, wall = 0;
  for (std::string_view text; monitor.receive(text, 60) == simspark::Connection::Status::message;) {
    const auto at = text.substr(0, 600).find("(time ");
    if (at == std::string_view::npos) continue;
    game = std::strtod(std::string(text.substr(at + 6, 12)).c_str(), nullptr);
    wall = steadySeconds();
    if (game < 1 || firstWall > 0) continue;
    firstWall = wall;
    firstGame = game;
  }
  if (wall <= firstWall) throw std::runtime_error("the game was too short to see how fast it goes");
  return (game - firstGame) / (wall - firstWall);
}

/// A game of bin/agent's until the simulator ends by itself.
Account play(int agentsPerTeam, int teams, std::vector<std::string> options) {
  for (const char* option : {"--seed", "1", "--kickoff-after", "2", "--die-with-parent", "--stats"})
    options.emplace_back(option);
  options.push_back(accountFile);
  simspark::SimulatorProcess simulator("bin/simulator", options, folder + "simulator.ports",
                                       folder + "simulator.out");
  std::vector<std::unique_ptr<ChildProcess>> agents;
  for (int team = 0; team < teams; ++team)
    for (int i = 0; i < agentsPerTeam; ++i)
      agents.push_back(std::make_unique<ChildProcess>(
          std::vector<std::string>{
              "bin/agent", "--team", team ? "Blue" : "Red", "--number", std::to_string(i + 1), "--type",
              std::to_string(types[i]), "--port", std::to_string(simulator.ports().agent), "--monitor-port",
              std::to_string(simulator.ports().monitor), "--crash-log", folder + "simulator.crash.log",
              "--stats", agentStatistics(static_cast<int>(agents.size()))},
          folder + "simulator.agents.out"));
  Account account;
  account.speed = clockSpeed(simulator.ports().monitor);
  while (simulator.process().running()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  for (auto& agent : agents) agent->stop(10);

  account.memory = simulator.process().usage().maxResidentMegabytes;
  std::ifstream file(accountFile);
  account.simulator = json::parse(file);
  account.agentCycles = account.simulator["cycles"];
  for (std::size_t i = 0; i < agents.size(); ++i) {
    std::ifstream own(agentStatistics(static_cast<int>(i)));
    const json agent = json::parse(own);
    if (!agent["cpu_us_per_cycle"].is_number())
      throw std::runtime_error("agent " + std::to_string(i) + " did not play a cycle; see " + folder +
                               "simulator.agents.out");
    account.allAgentsCpu += agent["cpu_us_per_cycle"].get<double>();
    account.firstCycle += agent["first_cycle_cpu_us"].get<double>() / static_cast<double>(agents.size());
    account.agentCycles = std::min(account.agentCycles, agent["cycles"].get<double>());
  }
  account.agentCpu = account.allAgentsCpu / static_cast<double>(agents.size());
  return account;
}

/// What whole players and the simulator cost where eleven play eleven in step, so that none of them rests:
/// what a soak of a day takes.
void measurePlayers(Figures& figures) {
  const Account game = play(11, 2, {"--sync", "--wait-agents", "22", "--max-seconds", "60"});
  const double simulator = game.simulator["cpu_us_per_cycle"].get<double>();
  figures.add("player_cycle_cpu_us_22", game.agentCpu, "us", "lower", 200);
  figures.add("player_first_cycle_cpu_us", game.firstCycle, "us", "lower", 2000);
  figures.add("players_game_cycle_cpu_us_22", simulator, "us", "lower");
  figures.add("players_and_game_cpu_us_22", game.allAgentsCpu + simulator, "us", "lower", 4000);
}

/// One bin/agent in step. The best of three runs, as whatever else the machine does slows this one, in which
/// two processes take turns.
void measureOne(Figures& figures, const std::string& engine, const std::string& suffix, double target,
                const Peer& peer) {
  Account best;
  for (int run = 0; run < 3; ++run)
    if (const Account next = play(1, 1, {"--sync", "--max-seconds", "300", "--engine", engine});
        next.speed > best.speed)
      best = next;
  figures.add("agent_x_real_time_1" + suffix, best.speed, "x", "higher", target, peer);
  const double cpu = best.simulator["cpu_us_per_cycle"].get<double>() + best.agentCpu;
  figures.add("agent_and_simulator_cpu_us_1" + suffix, cpu, "us", "lower", 20000 / target);
}

}  // namespace

void measureGames(Figures& figures) {
  measureOne(figures, "ode", "", 100, Peer{28, "rcssserver3d 0.7.3 with a UT agent"});
  measureOne(figures, "bullet", "_bullet", 150, Peer());
  measurePlayers(figures);

  const Account full = play(11, 2, {"--realtime", "--wait-agents", "22", "--max-seconds", "30"});
  figures.add("game_x_real_time_22", full.speed, "x", "higher", 0.99);
  figures.add("game_cycle_cpu_us_22", full.simulator["cpu_us_per_cycle"], "us", "lower", 5000, Peer{14600});
  figures.add("game_agent_cpu_us", full.agentCpu, "us", "lower", 200);
  const double cycles = full.simulator["cycles"];
  figures.add("game_cycles_of_slowest_agent", 100 * full.agentCycles / cycles, "%", "higher");
  double load = 0;  // of everything on this machine: the figures in real time and x are to be read with it
  std::ifstream("/proc/loadavg") >> load;
  figures.add("load_average_of_the_machine", load, "processes", "lower");
  figures.add("game_memory_mb_22", full.memory, "MB", "lower", 150);
}

}  // namespace plumbline::bench
