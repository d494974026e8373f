#include "simulation/server/MonitorPort.h"

#include <algorithm>

#include "framework/Loopback.h"

namespace plumbline::simulation {

namespace {
constexpr std::size_t maxMonitors = 32;
constexpr std::size_t maxCommands = 256;  ///< commands of a monitor in one cycle
}  // namespace

MonitorPort::Monitor::Monitor(int fd, const std::string& address, std::size_t maxQueue)
    : client(fd, address, simspark::maxAgentMessage, maxQueue) {}

MonitorPort::MonitorPort(const Config& config_, Simulation& simulation_, LogFunction log_)
    : config(config_), simulation(simulation_), log(std::move(log_)), listener(config.address, config.port) {}

void MonitorPort::watch(std::vector<pollfd>& descriptors) {
  descriptors.push_back({listener.descriptor(), POLLIN, 0});
  for (const auto& monitor : monitors) descriptors.push_back(monitor->client.watch());
  watched = monitors.size();
}

void MonitorPort::serve(const pollfd* events) {
  for (std::size_t i = 0; i < watched; ++i) {
    if (events[1 + i].revents == 0) continue;
    monitors[i]->client.serve(events[1 + i].revents);
    receive(*monitors[i]);
  }
  if (events[0].revents != 0) accept();
}

void MonitorPort::accept() {
  std::string address;
  for (std::size_t i = 0; i < mostAccepted; ++i) {
    const int fd = listener.accept(address);
    if (fd < 0) return;
    monitors.push_back(std::make_unique<Monitor>(fd, address, config.maxQueue));
    monitors.back()->admitted = config.token.empty();
    makeRoom(
        monitors, maxMonitors, "too many monitors", [this](Monitor& monitor) { receive(monitor); },
        [](const Monitor& monitor) { return !monitor.spoke; });
  }
}

bool MonitorPort::admits(Monitor& monitor, std::string_view text) {
  if (monitor.admitted) return true;
  monitor.admitted = sameSecret(text, "(token " + config.token + ")");
  monitor.spoke = monitor.admitted;
  if (!monitor.admitted) monitor.client.drop("did not name the token");
  return false;
}

void MonitorPort::receive(Monitor& monitor) {
  for (std::string_view text; monitor.client.next(text);) {
    if (!admits(monitor, text)) continue;
    std::vector<simspark::TrainerCommand> commands;
    const std::string problem = monitor.parser.parse(text, commands);
    if (!monitor.parser.wellFormed()) return monitor.client.drop("sent garbage: " + problem);
    monitor.spoke = true;
    monitor.pending += commands.size();
    if (monitor.pending > maxCommands) return monitor.client.drop("sent too many commands in a cycle");
    for (auto& command : commands) pending.emplace_back(&monitor, std::move(command));
    if (problem.empty() || monitor.complained || text == "(init)")
      continue;  // (init) is how viewers say hello
    monitor.complained = true;
    log("monitor " + monitor.client.address() + ": " + problem + " (told once)");
  }
}

bool MonitorPort::carryOut() {
  const bool any = !pending.empty();
  for (const auto& [monitor, command] : pending) carryOut(*monitor, command);
  pending.clear();
  for (const auto& monitor : monitors) monitor->pending = 0;
  return any;
}

void MonitorPort::carryOut(Monitor& monitor, const simspark::TrainerCommand& command) {
  if (std::holds_alternative<simspark::FullStateCommand>(command)) toldVersion = monitor.viewVersion = 0;
  if (std::holds_alternative<simspark::AcknowledgeCommand>(command)) monitor.acknowledge = true;
  if (std::holds_alternative<simspark::KillSimulatorCommand>(command)) killed = true;
  if (const auto* wish = std::get_if<simspark::ResetCommand>(&command)) {
    reset = *wish;
    return;
  }
  if (const auto* clock = std::get_if<simspark::ClockCommand>(&command)) return carryOut(monitor, *clock);
  if (const auto* viewer = std::get_if<simspark::ViewerCommand>(&command)) return carryOut(monitor, *viewer);
  const std::string problem = simulation.train(command);
  if (!problem.empty()) log("monitor " + monitor.client.address() + ": " + problem);
}

void MonitorPort::carryOut(Monitor& monitor, const simspark::ClockCommand& command) {
  using Kind = simspark::ClockCommand::Kind;
  const simspark::SimulatorClock& clock = clock_;  // what trainers are told of it
  const simspark::SimulatorClock before = clock;
  switch (command.kind) {
    case Kind::tell:
      monitor.clockAsked = true;
      break;
    case Kind::pause:
      clock_.paused = true;
      break;
    case Kind::resume:
      clock_.paused = false;
      clock_.steps = 0;
      break;
    case Kind::step:
      if (clock_.paused) clock_.steps = static_cast<int>(command.value);
      break;
    case Kind::speed:
      clock_.speed = command.value;
      break;
  }
  if (clock_ != before) ++clock_.changes;
}

void MonitorPort::carryOut(Monitor& monitor, const simspark::ViewerCommand& command) {
  monitor.interval = command.interval;
  if (!monitor.view) monitor.view = std::make_unique<MonitorScene>();
}

void MonitorPort::tellViewer(Monitor& monitor, bool regular) {
  monitor.viewStale = monitor.viewStale || regular;
  if (!monitor.viewStale || !monitor.client.idle()) return;
  const double now = wallClock();
  if (now < monitor.nextView) return;
  const bool whole = monitor.viewVersion != simulation.sceneVersion();
  monitor.client.send(whole ? monitor.view->full(simulation) : monitor.view->difference(simulation));
  monitor.viewVersion = simulation.sceneVersion();
  monitor.nextView = now + monitor.interval;
  monitor.viewStale = false;
}

void MonitorPort::tell(bool regular) {
  bool anyNew = false, anyTold = false;
  for (const auto& monitor : monitors) {
    if (!monitor->admitted || monitor->client.broken()) continue;
    if (monitor->clockAsked && monitor->clockTold != clock_.changes) {
      monitor->client.send(simspark::writeClock(clock_));
      monitor->clockTold = clock_.changes;
    }
    if (monitor->view)
      tellViewer(*monitor, regular);
    else
      (monitor->told ? anyTold : anyNew) = true;
    if (monitor->acknowledge) monitor->client.send("best");
    monitor->acknowledge = false;
  }
  if (!anyNew && !(anyTold && regular)) return;

  // A robot came, went or got its number: everybody needs the whole scene. A new monitor needs it as well,
  // but first the others get what changed, as the scene then forgets what it told them.
  const bool whole = simulation.sceneVersion() != toldVersion;
  toldVersion = simulation.sceneVersion();
  if (anyTold && !whole) send(scene.difference(simulation), Recipients::told);
  if (anyNew || whole) send(scene.full(simulation), whole ? Recipients::all : Recipients::untold);
}

void MonitorPort::send(const std::string& text, Recipients recipients) {
  for (const auto& monitor : monitors) {
    if (!monitor->admitted || monitor->view ||
        (recipients != Recipients::all && monitor->told != (recipients == Recipients::told)))
      continue;
    monitor->client.send(text);
    monitor->told = true;
  }
}

bool MonitorPort::owe() const {
  return std::any_of(monitors.begin(), monitors.end(), [this](const auto& monitor) {
    return (monitor->view ? monitor->viewVersion : toldVersion) != simulation.sceneVersion();
  });
}

void MonitorPort::dropBroken() {
  const double now = wallClock();
  for (const auto& monitor : monitors) {
    if (monitor->client.halfSince() > 0 && now - monitor->client.halfSince() > config.halfTimeout)
      monitor->client.drop("sent half a message and no more");
    if (!monitor->admitted && now - monitor->client.since() > config.tokenTimeout)
      monitor->client.drop("did not name the token");
  }
  std::erase_if(monitors, [this](const auto& monitor) {
    if (!monitor->client.broken()) return false;
    std::erase_if(pending, [&](const auto& command) { return command.first == monitor.get(); });
    log("monitor " + monitor->client.address() + ' ' + monitor->client.reason());
    return true;
  });
}

}  // namespace plumbline::simulation
