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

MonitorPort::MonitorPort(const Config& config, Simulation& simulation, LogFunction log)
    : config_(config),
      simulation_(simulation),
      log_(std::move(log)),
      listener_(config_.address, config_.port) {}

void MonitorPort::watch(std::vector<pollfd>& descriptors) {
  descriptors.push_back({listener_.descriptor(), POLLIN, 0});
  for (const auto& monitor : monitors_) descriptors.push_back(monitor->client.watch());
  watched_ = monitors_.size();
}

void MonitorPort::serve(const pollfd* events) {
  for (std::size_t i = 0; i < watched_; ++i) {
    if (events[1 + i].revents == 0) continue;
    monitors_[i]->client.serve(events[1 + i].revents);
    receive(*monitors_[i]);
  }
  if (events[0].revents != 0) accept();
}

void MonitorPort::accept() {
  std::string address;
  for (std::size_t i = 0; i < mostAccepted; ++i) {
    const int fd = listener_.accept(address);
    if (fd < 0) return;
    monitors_.push_back(std::make_unique<Monitor>(fd, address, config_.maxQueue));
    monitors_.back()->admitted = config_.token.empty();
    makeRoom(
        monitors_, maxMonitors, "too many monitors", [this](Monitor& monitor) { receive(monitor); },
        [](const Monitor& monitor) { return !monitor.spoke; });
  }
}

bool MonitorPort::admits(Monitor& monitor, std::string_view text) {
  if (monitor.admitted) return true;
  monitor.admitted = sameSecret(text, "(token " + config_.token + ")");
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
    for (auto& command : commands) pending_.emplace_back(&monitor, std::move(command));
    if (problem.empty() || monitor.complained || text == "(init)")
      continue;  // (init) is how viewers say hello
    monitor.complained = true;
    log_("monitor " + monitor.client.address() + ": " + problem + " (reported once)");
  }
}

bool MonitorPort::carryOut() {
  const bool any = !pending_.empty();
  for (const auto& [monitor, command] : pending_) carryOut(*monitor, command);
  pending_.clear();
  for (const auto& monitor : monitors_) monitor->pending = 0;
  return any;
}

void MonitorPort::carryOut(Monitor& monitor, const simspark::TrainerCommand& command) {
  if (std::holds_alternative<simspark::FullStateCommand>(command)) sentVersion_ = monitor.viewVersion = 0;
  if (std::holds_alternative<simspark::AcknowledgeCommand>(command)) monitor.acknowledge = true;
  if (std::holds_alternative<simspark::KillSimulatorCommand>(command)) killed_ = true;
  if (const auto* wish = std::get_if<simspark::ResetCommand>(&command)) {
    reset_ = *wish;
    return;
  }
  if (const auto* clock = std::get_if<simspark::ClockCommand>(&command)) return carryOut(monitor, *clock);
  if (const auto* viewer = std::get_if<simspark::ViewerCommand>(&command)) return carryOut(monitor, *viewer);
  const std::string problem = simulation_.train(command);
  if (!problem.empty()) log_("monitor " + monitor.client.address() + ": " + problem);
}

void MonitorPort::carryOut(Monitor& monitor, const simspark::ClockCommand& command) {
  using Kind = simspark::ClockCommand::Kind;
  const simspark::SimulatorClock& clock = clock_;  // what is sent to trainers of it
  const simspark::SimulatorClock before = clock;
  switch (command.kind) {
    case Kind::subscribe:
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

void MonitorPort::sendToViewer(Monitor& monitor, bool regular) {
  monitor.viewStale = monitor.viewStale || regular;
  if (!monitor.viewStale || !monitor.client.idle()) return;
  const double now = steadySeconds();
  if (now < monitor.nextView) return;
  const bool whole = monitor.viewVersion != simulation_.sceneVersion();
  monitor.client.send(whole ? monitor.view->full(simulation_) : monitor.view->difference(simulation_));
  monitor.viewVersion = simulation_.sceneVersion();
  monitor.nextView = now + monitor.interval;
  monitor.viewStale = false;
}

void MonitorPort::sendState(bool regular) {
  bool anyUninformed = false, anyInformed = false;
  for (const auto& monitor : monitors_) {
    if (!monitor->admitted || monitor->client.broken()) continue;
    if (monitor->clockAsked && monitor->clockSent != clock_.changes) {
      monitor->client.send(simspark::writeClock(clock_));
      monitor->clockSent = clock_.changes;
    }
    if (monitor->view)
      sendToViewer(*monitor, regular);
    else
      (monitor->informed ? anyInformed : anyUninformed) = true;
    if (monitor->acknowledge) monitor->client.send("best");
    monitor->acknowledge = false;
  }
  if (!anyUninformed && !(anyInformed && regular)) return;

  // A robot came, went or got its number: everybody needs the whole scene. A new monitor needs it as well,
  // but first the others get what changed, as the scene then forgets what it sent them.
  const bool whole = simulation_.sceneVersion() != sentVersion_;
  sentVersion_ = simulation_.sceneVersion();
  if (anyInformed && !whole) send(scene_.difference(simulation_), Recipients::informed);
  if (anyUninformed || whole)
    send(scene_.full(simulation_), whole ? Recipients::all : Recipients::uninformed);
}

void MonitorPort::send(const std::string& text, Recipients recipients) {
  for (const auto& monitor : monitors_) {
    if (!monitor->admitted || monitor->view ||
        (recipients != Recipients::all && monitor->informed != (recipients == Recipients::informed)))
      continue;
    monitor->client.send(text);
    monitor->informed = true;
  }
}

bool MonitorPort::owe() const {
  return std::any_of(monitors_.begin(), monitors_.end(), [this](const auto& monitor) {
    return (monitor->view ? monitor->viewVersion : sentVersion_) != simulation_.sceneVersion();
  });
}

void MonitorPort::dropBroken() {
  const double now = steadySeconds();
  for (const auto& monitor : monitors_) {
    if (monitor->client.halfSince() > 0 && now - monitor->client.halfSince() > config_.halfTimeout)
      monitor->client.drop("sent half a message and no more");
    if (!monitor->admitted && now - monitor->client.since() > config_.tokenTimeout)
      monitor->client.drop("did not name the token");
  }
  std::erase_if(monitors_, [this](const auto& monitor) {
    if (!monitor->client.broken()) return false;
    std::erase_if(pending_, [&](const auto& command) { return command.first == monitor.get(); });
    log_("monitor " + monitor->client.address() + ' ' + monitor->client.reason());
    return true;
  });
}

}  // namespace plumbline::simulation
