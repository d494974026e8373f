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
constexpr double waitPatience = 2, waitInterval = 10;  ///< until a wait is reported, and reported again [s]
constexpr double maxLag = 0.1;  ///< a real-time run that is so late gives up on catching up [s]

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Server::Server(const ServerConfig& config, const LogFunction& log)
    : config_(config),
      log_(log),
      simulation_(config_.simulation),
      agents_(config_.agents, simulation_, std::ref(log_)),
      monitors_(config_.monitors, simulation_, std::ref(log_)) {
  if (!config_.realTime) monitors_.clock().speed = 0;
  if (config_.field) openField();
}

void Server::openField() {
  try {
    field_.emplace(*config_.field, simulation_, std::ref(log_));
  } catch (const std::runtime_error& problem) {
    if (!config_.fieldOptional) throw;
    log_("nothing for bin/simplemonitor at its own port: " + std::string(problem.what()));
  }
}

void Server::listen(int milliseconds) {
  descriptors_.clear();
  agents_.watch(descriptors_);
  const std::size_t firstMonitor = descriptors_.size();
  monitors_.watch(descriptors_);
  const std::size_t firstViewer = descriptors_.size();
  if (field_) field_->watch(descriptors_);
  if (const double now = steadySeconds(); now - logLooked_ > 1) {
    log_.reportOverdue();
    logLooked_ = now;
  }
  if (poll(descriptors_.data(), descriptors_.size(), milliseconds) <= 0) return;
  agents_.serve(descriptors_.data());
  monitors_.serve(descriptors_.data() + firstMonitor);
  if (field_) field_->serve(descriptors_.data() + firstViewer);
}

bool Server::clockIsStopped() const {
  if (monitors_.clock().stopped()) return true;
  if (config_.waitForAgents == 0) return false;
  return agents_.numAgents() < (started_ ? 1 : config_.waitForAgents);
}

void Server::reportWait() {
  if (monitors_.clock().stopped()) return;  // a trainer wants it so
  const double now = steadySeconds();
  if (!stood_ || waitReported_ == 0) {
    waitReported_ = now;
    agentsReported_ = -1;
  }
  const int here = agents_.numAgents();
  if (here == agentsReported_ || now - waitReported_ < (agentsReported_ < 0 ? waitPatience : waitInterval))
    return;
  const int wanted = started_ ? 1 : config_.waitForAgents;
  log_("waiting for " + std::to_string(wanted) + (wanted == 1 ? " agent" : " agents") + " on port " +
       std::to_string(agentPort()) + ", " + std::to_string(here) + " so far; the clock is stopped" +
       (config_.maxSeconds ? ", and the time until the end is simulated time" : ""));
  waitReported_ = now;
  agentsReported_ = here;
}

bool Server::collect() {
  const bool idle = clockIsStopped() || !agents_.ready();
  listen(idle ? patience : 0);
  agents_.dropBroken();
  monitors_.dropBroken();
  if (!clockIsStopped()) {
    if (agents_.ready()) return true;
    // A client that comes during a wait for agents sees at least where everything is.
    monitors_.sendState(false);
    sendField();
    return false;
  }
  reportWait();
  // Nothing moves, but trainers may set the scene and see it.
  const bool commanded = obeyTrainers();
  agents_.dropBroken();
  // Otherwise the last changes, or a robot that left, would only be seen when the clock goes on.
  const bool stopsNow = !std::exchange(stood_, true);
  monitors_.sendState(commanded || stopsNow || monitors_.owe());
  sendField();
  return false;
}

bool Server::obeyTrainers() {
  const bool any = monitors_.carryOut();
  if (const auto reset = monitors_.takeReset()) agents_.restarted(simulation_.restart(reset->seed));
  return any;
}

void Server::cycle() {
  started_ = true;
  stood_ = false;
  if (obeyTrainers()) agents_.dropBroken();  // a trainer may have removed players
  agents_.carryOut();
  const bool delay = config_.simulation.world.actionDelay;
  if (delay) agents_.sendSenses();
  simulation_.step();
  if (!delay) agents_.sendSenses();
  RunClock& clock = monitors_.clock();
  if (clock.steps > 0) --clock.steps;
  if (clock.speed > 0) waitForClock();
  monitors_.sendState(monitors_.due() || clock.paused);
  sendField();
  agents_.dropBroken();
  ++statistics_.cycles;
}

void Server::sendField() {
  if (!field_) return;
  field_->sendState();
  field_->dropBroken();
}

void Server::waitForClock() {
  const double step = config_.simulation.world.stepSeconds / monitors_.clock().speed, now = steadySeconds();
  nextTick_ += step;
  if (nextTick_ < now - maxLag || nextTick_ > now + step) nextTick_ = now;
  if (nextTick_ <= now) return;
  timespec rest{0, static_cast<long>((nextTick_ - now) * 1e9)};
  nanosleep(&rest, nullptr);
}

void Server::run(const std::atomic<bool>& stop) {
  const double wallStart = steadySeconds(), cpuStart = cpuSeconds();
  const auto over = [&] {
    return stop || monitors_.killRequested() || simulation_.finished() ||
           (config_.maxSeconds && simulation_.time() >= *config_.maxSeconds - 1e-9);
  };
  while (!over())
    if (collect()) cycle();
  statistics_.wallSeconds += steadySeconds() - wallStart;
  statistics_.cpuSeconds += cpuSeconds() - cpuStart;
  statistics_.simulatedSeconds = simulation_.time();
}

}  // namespace plumbline::simulation
