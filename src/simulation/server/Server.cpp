#include "simulation/server/Server.h"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <utility>

namespace plumbline::simulation {

namespace {

constexpr int patience = 100;                          ///< longest wait before looking at `stop` again [ms]
constexpr double waitPatience = 2, waitInterval = 10;  ///< until a wait is told, and told again [s]
constexpr double maxLag = 0.1;  ///< a real-time run that is so late gives up on catching up [s]

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Server::Server(const ServerConfig& config_, const LogFunction& log_)
    : config(config_),
      log(log_),
      simulation_(config.simulation),
      agents(config.agents, simulation_, std::ref(log)),
      monitors(config.monitors, simulation_, std::ref(log)) {
  if (!config.realTime) monitors.clock().speed = 0;
  if (config.field) openField();
}

void Server::openField() {
  try {
    field.emplace(*config.field, simulation_, std::ref(log));
  } catch (const std::runtime_error& problem) {
    if (!config.fieldOptional) throw;
    log("nothing for bin/simplemonitor at its own port: " + std::string(problem.what()));
  }
}

void Server::listen(int milliseconds) {
  descriptors.clear();
  agents.watch(descriptors);
  const std::size_t firstMonitor = descriptors.size();
  monitors.watch(descriptors);
  const std::size_t firstViewer = descriptors.size();
  if (field) field->watch(descriptors);
  if (const double now = wallClock(); now - logLooked > 1) {
    log.tellOverdue();
    logLooked = now;
  }
  if (poll(descriptors.data(), descriptors.size(), milliseconds) <= 0) return;
  agents.serve(descriptors.data());
  monitors.serve(descriptors.data() + firstMonitor);
  if (field) field->serve(descriptors.data() + firstViewer);
}

bool Server::clockStands() const {
  if (monitors.clock().stands()) return true;
  if (config.waitForAgents == 0) return false;
  return agents.numAgents() < (started ? 1 : config.waitForAgents);
}

void Server::tellWait() {
  if (monitors.clock().stands()) return;  // a trainer wants it so
  const double now = wallClock();
  if (!stood || waitTold == 0) {
    waitTold = now;
    agentsTold = -1;
  }
  const int here = agents.numAgents();
  if (here == agentsTold || now - waitTold < (agentsTold < 0 ? waitPatience : waitInterval)) return;
  const int wanted = started ? 1 : config.waitForAgents;
  log("waiting for " + std::to_string(wanted) + (wanted == 1 ? " agent" : " agents") + " on port " +
      std::to_string(agentPort()) + ", " + std::to_string(here) + " so far; the clock stands" +
      (config.maxSeconds ? ", and the time until the end is simulated time" : ""));
  waitTold = now;
  agentsTold = here;
}

bool Server::collect() {
  const bool idle = clockStands() || !agents.ready();
  listen(idle ? patience : 0);
  agents.dropBroken();
  monitors.dropBroken();
  if (!clockStands()) {
    if (agents.ready()) return true;
    // Who comes while an agent is waited for sees at least where everything is.
    monitors.tell(false);
    tellField();
    return false;
  }
  tellWait();
  // Nothing moves, but trainers may set the scene and are shown it.
  const bool commanded = obeyTrainers();
  agents.dropBroken();
  // What changed since the last message, or now as a robot left, would not be seen before the clock goes on.
  const bool stopsNow = !std::exchange(stood, true);
  monitors.tell(commanded || stopsNow || monitors.owe());
  tellField();
  return false;
}

bool Server::obeyTrainers() {
  const bool any = monitors.carryOut();
  if (const auto reset = monitors.takeReset()) agents.restarted(simulation_.restart(reset->seed));
  return any;
}

void Server::cycle() {
  started = true;
  stood = false;
  if (obeyTrainers()) agents.dropBroken();  // a trainer may have removed players
  agents.carryOut();
  const bool delay = config.simulation.world.actionDelay;
  if (delay) agents.sendSenses();
  simulation_.step();
  if (!delay) agents.sendSenses();
  RunClock& clock = monitors.clock();
  if (clock.steps > 0) --clock.steps;
  if (clock.speed > 0) waitForClock();
  monitors.tell(monitors.due() || clock.paused);
  tellField();
  agents.dropBroken();
  ++statistics_.cycles;
}

void Server::tellField() {
  if (!field) return;
  field->tell();
  field->dropBroken();
}

void Server::waitForClock() {
  const double step = config.simulation.world.stepSeconds / monitors.clock().speed, now = wallClock();
  nextTick += step;
  if (nextTick < now - maxLag || nextTick > now + step) nextTick = now;
  if (nextTick <= now) return;
  timespec rest{0, static_cast<long>((nextTick - now) * 1e9)};
  nanosleep(&rest, nullptr);
}

void Server::run(const std::atomic<bool>& stop) {
  const double wallStart = wallClock(), cpuStart = cpuSeconds();
  const auto over = [&] {
    return stop || monitors.killRequested() || simulation_.finished() ||
           (config.maxSeconds && simulation_.time() >= *config.maxSeconds - 1e-9);
  };
  while (!over())
    if (collect()) cycle();
  statistics_.wallSeconds += wallClock() - wallStart;
  statistics_.cpuSeconds += cpuSeconds() - cpuStart;
  statistics_.simulatedSeconds = simulation_.time();
}

}  // namespace plumbline::simulation
