#include <algorithm>

#include "Bending.h"
#include "Figures.h"
#include "simulation/Simulation.h"
#include "simulation/monitor/MonitorScene.h"

namespace plumbline::bench {

namespace {

using simulation::PlayerId;
using simulation::Simulation;

/// A game in this process, in which everybody bends the knees.
class Game {
public:
  explicit Game(int robots) {
    for (int i = 0; i < robots; ++i) {
      ids.push_back(simulation.addPlayer(teamTypes[static_cast<std::size_t>(i / 2)]));
      simspark::AgentCommand init;
      init.init = simspark::InitRequest{i / 2 + 1, i % 2 ? "Blue" : "Red"};
      simulation.act(ids.back(), init);
    }
    simulation.train(simspark::PlayModeCommand{simspark::PlayMode::playOn});
    for (int i = 0; i < 100; ++i) step();
  }
  void act() {
    const simspark::AgentCommand command = bending(cycle_++);
    for (const PlayerId id : ids) simulation.act(id, command);
  }
  void step() {
    act();
    simulation.step();
  }
  Simulation simulation{simulation::SimulationConfig{}};
  std::vector<PlayerId> ids;

private:
  int cycle_ = 0;
};

/// Whole cycles, and cycles of which something is left out, in turns, so that all see the same robots.
void measureCycle(Figures& figures, int robots) {
  Game game(robots);
  simulation::MonitorScene scene;
  scene.full(game.simulation);
  double whole = 0, physics = 0, monitor = 0;
  constexpr int rounds = 40;
  const int calls = std::max(2, 100 / robots);
  for (int round = 0; round < rounds; ++round) {
    whole += cpuPerCall(calls, [&] { game.step(); }) / rounds;
    physics += cpuPerCall(calls,
                          [&] {
                            game.act();
                            game.simulation.world().step();
                          }) /
               rounds;
    for (int i = 0; i < calls; ++i) {
      game.step();
      monitor += cpuPerCall(1, [&] { scene.difference(game.simulation); }) / (rounds * calls);
    }
  }
  const std::string n = '_' + std::to_string(robots);
  figures.add("physics_us" + n, physics, "us", "lower");
  figures.add("senses_and_rules_us" + n, whole - physics, "us", "lower",
              robots == 1 ? json(30) : json(nullptr));
  figures.add("monitor_difference_us" + n, monitor, "us", "lower");
  figures.add("monitor_scene_us" + n, cpuPerCall(100, [&] { scene.full(game.simulation); }), "us", "lower");
}

void measureReset(Figures& figures, int robots) {
  Game game(robots);
  double slowest = 0;
  for (int i = 0; i < 20; ++i) {
    const double before = cpuMicroseconds();
    game.simulation.restart();
    slowest = std::max(slowest, cpuMicroseconds() - before);
    for (int cycle = 0; cycle < 5; ++cycle) game.simulation.step();
  }
  figures.add("reset_ms_" + std::to_string(robots), slowest / 1000, "ms", "lower", 10);
}

}  // namespace

void measureParts(Figures& figures) {
  for (const int robots : {1, 22}) measureCycle(figures, robots);
  for (const int robots : {1, 2, 4, 11, 22}) measureReset(figures, robots);
}

}  // namespace plumbline::bench
