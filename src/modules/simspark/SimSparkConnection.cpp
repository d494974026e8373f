#include "modules/simspark/SimSparkConnection.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "modules/simspark/Monitor.h"

namespace plumbline {

MAKE_MODULE(SimSparkConnection)

namespace {

std::string inFolderOfAgent(const std::string& path) {
  const std::filesystem::path file(path);
  return file.is_absolute() ? path : (std::filesystem::path(simspark::programFolder()) / file).string();
}

}  // namespace

void SimSparkConnection::init() {
  options_ = &object<AgentOptions>();
  link_ = &object<SimSparkLink>();
  simulatorProgram_ = inFolderOfAgent(config.get<std::string>("simulator"));
  connectSeconds_ = config.get<double>("connectSeconds", {0, 3600});
  reconnect_ = config.get<bool>("reconnect");
  maxRestarts_ = config.get<int>("maxRestarts", {0, 1e9});
}

bool SimSparkConnection::tryConnect(std::string& why) {
  link_->ports = {options_->port, options_->monitorPort};
  std::string host = options_->host;
  if (options_->startSimulator) {
    if (link_->simulator && !link_->simulator->process().running()) link_->simulator.reset();
    if (!link_->simulator) {
      if (connections_ > 0 && restarts_++ >= maxRestarts_) {
        requestStop(1, "the simulator died " + std::to_string(restarts_) +
                           " times; see SimSparkConnection.yaml: maxRestarts");
        return false;
      }
      const std::string base =
          (std::filesystem::temp_directory_path() / ("plumbline-" + std::to_string(getpid()))).string();
      std::vector<std::string> simulatorOptions = options_->simulatorOptions;
      simulatorOptions.emplace_back("--die-with-parent");
      try {
        link_->simulator = std::make_unique<simspark::SimulatorProcess>(simulatorProgram_, simulatorOptions,
                                                                        base + ".ports", base + ".log");
      } catch (const std::runtime_error& error) {
        requestStop(1, error.what());
        return false;
      }
      std::filesystem::remove(base + ".ports");
      std::filesystem::remove(base + ".log");  // the child keeps its descriptor; nothing stays in the folder
      log << "started " << simulatorProgram_ << " on port " << link_->simulator->ports().agent;
    }
    link_->ports = link_->simulator->ports();
    host = "127.0.0.1";
  }
  if (monitor) monitor->setServer(host, link_->ports.monitor);
  why = link_->connection.connect(host, link_->ports.agent, 1.0);
  if (!why.empty()) return false;

  // The server makes the robot, answers once, and then takes the place in the team.
  simspark::AgentCommand scene;
  scene.scene = simspark::SceneRequest{.type = options_->type};
  scene.syn = true;
  link_->send(scene);
  std::string_view answer;
  if (link_->connection.receive(answer, 5.0) != simspark::Connection::Status::message) {
    why = "no answer to (scene) from port " + std::to_string(link_->ports.agent);
    link_->connection.close();
    return false;
  }
  simspark::AgentCommand init;
  init.init = simspark::InitRequest{options_->number, options_->team};
  init.syn = true;
  link_->send(init);
  return true;
}

bool SimSparkConnection::connect() {
  std::string why;
  // How long to try is a matter of patience, not of behaviour: the clock decides nothing else.
  const auto start = std::chrono::steady_clock::now();
  while (!stopRequested()) {
    if (tryConnect(why)) {
      ++connections_;
      cycles_ = 0;
      log << "connected to port " << link_->ports.agent;
      return true;
    }
    if (stopRequested()) break;
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > connectSeconds_) {
      requestStop(1, why);
      break;
    }
    usleep(100'000);
  }
  return false;
}

bool SimSparkConnection::receive() {
  while (!stopRequested()) {
    std::string_view text;
    switch (link_->connection.receive(text, 0.1)) {
      case simspark::Connection::Status::message:
        message_.assign(text);
        ++cycles_;
        return true;
      case simspark::Connection::Status::timeout:
        break;
      case simspark::Connection::Status::closed:
        log << "connection lost: " << link_->connection.error();
        if (!reconnect_) requestStop(1, "connection to the simulator lost: " + link_->connection.error());
        return false;
    }
  }
  return false;
}

void SimSparkConnection::execute() {
  message_.clear();
  while (!stopRequested()) {
    if (!link_->connection.connected() && !connect()) return;
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
