#include "modules/simspark/SimSparkConnection.h"

#include <poll.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "framework/SteadyClock.h"
#include "framework/Waiting.h"
#include "modules/simspark/Monitor.h"

namespace plumbline {

MAKE_MODULE(SimSparkConnection)

namespace {

std::string inFolderOfAgent(const std::string& path) {
  const std::filesystem::path file(path);
  return file.is_absolute() ? path : (std::filesystem::path(programFolder()) / file).string();
}

constexpr double connectPause = 0.1, refusedPause = 1;  // [s]
constexpr double reportAfter = 2;                       ///< a wait is worth a word [s]
constexpr double placeInterval = 5;                     ///< between two requests for a place [s]
constexpr int maxPlaceRequests = 200;

}  // namespace

void SimSparkConnection::init() {
  options_ = &object<AgentOptions>();
  link_ = &object<SimSparkLink>();
  link_->connection.interruptBy(stopDescriptor());
  monitor_ = &object<Monitor>();
  monitor_->interruptBy(stopDescriptor());
  monitor_->setToken(options_->token);
  simulatorProgram_ = inFolderOfAgent(simulator);
}

bool SimSparkConnection::startSimulator() {
  if (link_->simulator && !link_->simulator->process().running()) {
    // It was asked to (--max-seconds): no accident to recover from.
    if (link_->simulator->process().exitStatus() == 0) {
      const std::string reason = "the simulator has ended";
      notify(reason);
      requestStop(0, reason);
      return false;
    }
    link_->simulator.reset();
  }
  if (!link_->simulator) {
    if (connections_ > 0 && restarts_++ >= maxRestarts) {
      requestStop(1, "the simulator died " + std::to_string(restarts_) +
                         " times; see SimSparkConnection.yaml: maxRestarts");
      return false;
    }
    const std::string base =
        (std::filesystem::temp_directory_path() / ("plumbline-" + std::to_string(getpid()))).string();
    const auto removeFiles = [&base] {  // the child keeps its descriptor; nothing stays in the folder
      std::filesystem::remove(base + ".ports");
      std::filesystem::remove(base + ".log");
    };
    std::vector<std::string> simulatorOptions = options_->simulatorOptions;
    simulatorOptions.emplace_back("--die-with-parent");
    try {
      link_->simulator =
          std::make_unique<simspark::SimulatorProcess>(simulatorProgram_, simulatorOptions, base + ".ports",
                                                       base + ".log", [this] { return stopRequested(); });
    } catch (const std::runtime_error& error) {
      if (stopRequested()) removeFiles();  // else its log says what went wrong
      requestStop(1, error.what());
      return false;
    }
    removeFiles();
    log << "started " << simulatorProgram_ << " on port " << link_->simulator->ports().agent;
    if (const int web = link_->simulator->ports().web; web > 0)
      notify("watch at http://localhost:" + std::to_string(web) + "/");
  }
  link_->ports = link_->simulator->ports();
  return true;
}

bool SimSparkConnection::connect() {
  const Waiting waiting;
  const double start = steadySeconds();
  std::string host = options_->startSimulator ? "127.0.0.1" : options_->host;
  link_->ports = {options_->port, options_->monitorPort};
  while (!stopRequested()) {
    if (options_->startSimulator && !startSimulator()) return false;
    monitor_->setServer(host, link_->ports.monitor);
    const std::string why = link_->connection.connect(host, link_->ports.agent, 1.0);
    if (why.empty()) {
      log << "connected to port " << link_->ports.agent;
      askForRobot();
      return true;
    }
    if (stopRequested()) break;
    if (connectSeconds > 0 && steadySeconds() - start > connectSeconds) {
      requestStop(1, why);
      break;
    }
    if (!waitReported_) notify("waiting for a server: " + why);
    pause(connectPause);
  }
  return false;
}

void SimSparkConnection::askForRobot() {
  // The server makes the robot, answers once, and then takes the place in the team.
  if (!options_->token.empty()) link_->connection.send("(token " + options_->token + ")");
  simspark::AgentCommand scene;
  scene.scene = simspark::SceneRequest{.type = options_->type};
  scene.syn = true;
  link_->send(scene);
  phase_ = Phase::scene;
  attached_ = true;
  placed_ = false;
  phaseSince_ = steadySeconds();
  phaseReported_ = false;
}

void SimSparkConnection::askForPlace() {
  simspark::AgentCommand init;
  init.init = simspark::InitRequest{options_->number, options_->team};
  init.syn = true;
  link_->send(init);
  ++placeRequests_;
  placeAsked_ = steadySeconds();
}

void SimSparkConnection::answered() {
  if (phase_ == Phase::scene) {
    phase_ = Phase::place;
    phaseSince_ = steadySeconds();
    phaseReported_ = false;
    ++connections_;
    cycles_ = 0;
    placeRequests_ = 0;
    askForPlace();
    return;
  }
  phase_ = Phase::play;
}

void SimSparkConnection::lookForPlace(std::string_view text) {
  // The first message to a robot with a place says which; without one it stays beside the field.
  placed_ = text.find("(unum ") != std::string_view::npos;
  if (!placed_) return reportWait(steadySeconds() - phaseSince_);
  if (waitReported_ || wasHere_)
    notify((wasHere_ ? "back on port " : "plays on port ") + std::to_string(link_->ports.agent));
  waitReported_ = wasHere_ = false;
}

void SimSparkConnection::reportWait(double seconds) {
  const std::string port = std::to_string(link_->ports.agent);
  const bool due = !phaseReported_ && seconds > reportAfter;
  phaseReported_ = phaseReported_ || due;
  if (phase_ == Phase::scene && due)
    notify("connected; port " + port +
           " gives no robot yet: its clock may stand until all agents are connected");
  if (phase_ == Phase::scene) return;
  const std::string number =
      options_->number > 0 ? "number " + std::to_string(options_->number) : std::string("a number");
  if (due)
    notify("port " + port + " gives no place in team " + options_->team + " yet: " + number +
           " may be taken, the team full, or the clock stopped");
  // Whoever has the number may go. Few enough requests not to be taken for a flood when the clock goes on.
  if (steadySeconds() - placeAsked_ > placeInterval && placeRequests_ < maxPlaceRequests) askForPlace();
}

void SimSparkConnection::lost() {
  const Waiting waiting;
  attached_ = false;
  const std::string why = link_->connection.error();
  log << "connection lost: " << why;
  if (!reconnect) return requestStop(1, "connection to the simulator lost: " + why);
  if (placed_ || !waitReported_) notify("connection lost: " + why + "; trying again");
  wasHere_ = wasHere_ || placed_;
  // A server that sends us away is not asked again at once.
  if (phase_ != Phase::play) pause(refusedPause);
}

bool SimSparkConnection::receive() {
  const Waiting waiting;
  while (!stopRequested()) {
    std::string_view text;
    switch (link_->connection.receive(text, 0.1)) {
      case simspark::Connection::Status::message:
        if (phase_ != Phase::play) answered();
        if (phase_ == Phase::place) break;
        if (!placed_) lookForPlace(text);
        message_.assign(text);
        ++cycles_;
        return true;
      case simspark::Connection::Status::timeout:
        if (!placed_) reportWait(steadySeconds() - phaseSince_);
        break;
      case simspark::Connection::Status::closed:
        lost();
        return false;
    }
  }
  return false;
}

void SimSparkConnection::notify(const std::string& line) {
  waitReported_ = true;
  log << line;
  if (options_->notify) options_->notify(line);
}

void SimSparkConnection::pause(double seconds) const {
  pollfd stopped{stopDescriptor(), POLLIN, 0};
  poll(&stopped, 1, static_cast<int>(1000 * seconds));
}

void SimSparkConnection::execute() {
  message_.clear();
  while (!stopRequested()) {
    if (!link_->connection.connected()) {
      if (attached_) lost();  // it broke while something was sent
      if (stopRequested() || !connect()) return;
    }
    if (receive()) return;
  }
}

void SimSparkConnection::update(ServerMessageText* theServerMessageText) {
  theServerMessageText->text = message_;
}

void SimSparkConnection::update(SimSparkInfo* theSimSparkInfo) {
  theSimSparkInfo->connected = link_->connection.connected();
  theSimSparkInfo->connections = connections_;
  theSimSparkInfo->agentPort = link_->ports.agent;
  theSimSparkInfo->monitorPort = link_->ports.monitor;
  theSimSparkInfo->cycles = cycles_;
}

}  // namespace plumbline
