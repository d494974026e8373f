#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "simspark/AgentCommand.h"
#include "simspark/Connection.h"
#include "simspark/MonitorClient.h"
#include "simspark/ServerMessageParser.h"
#include "simulation/server/Server.h"
#include "support/FarOff.h"

namespace plumbline::test {

/// A server on free ports that runs in a thread until the object ends; keeps its log.
class RunningServer {
public:
  explicit RunningServer(simulation::ServerConfig config) {
    config.agents.port = config.monitors.port = 0;
    server_ = std::make_unique<simulation::Server>(config, [this](const std::string& line) {
      const std::lock_guard lock(mutex_);
      lines_ += line + '\n';
    });
    thread_ = std::thread([this] {
      server_->run(stop_);
      ended_ = true;
    });
  }
  ~RunningServer() { end(); }

  void end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  /// Whether it has ended by itself.
  bool ended() const { return ended_; }
  /// Waits until it has.
  void join() { thread_.join(); }
  int agentPort() const { return server_->agentPort(); }
  int monitorPort() const { return server_->monitorPort(); }
  int fieldPort() const { return server_->fieldPort(); }
  std::string log() {
    const std::lock_guard lock(mutex_);
    return lines_;
  }
  /// Whether the log gets this text.
  bool logs(const std::string& text) {
    return comesTrue([&] { return log().find(text) != std::string::npos; });
  }
  const simulation::ServerStatistics& statistics() const { return server_->statistics(); }

private:
  std::mutex mutex_;
  std::string lines_;
  std::unique_ptr<simulation::Server> server_;
  std::atomic<bool> stop_ = false, ended_ = false;
  std::thread thread_;
};

/// A server in step with its agents, as fast as it goes.
inline simulation::ServerConfig inStep(int waitForAgents = 1) {
  simulation::ServerConfig config;
  config.agents.sync = true;
  config.realTime = false;
  config.waitForAgents = waitForAgents;
  config.simulation.seed = 3;
  return config;
}

/// An agent that repeats what it gets.
class TestAgent {
public:
  TestAgent(int port, int type, const std::string& team, int unum) {
    const std::string error = connection.connect("127.0.0.1", port);
    if (!error.empty()) throw std::runtime_error(error);
    simspark::AgentCommand command;
    command.scene = simspark::SceneRequest{.type = type};
    command.syn = true;
    send(command);
    hello.init = simspark::InitRequest{unum, team};
  }

  /// The next message; empty if the connection is gone or nothing comes.
  std::string receive() {
    std::string_view text;
    if (connection.receive(text, farOff) != simspark::Connection::Status::message) return {};
    return std::string(text);
  }
  void send(const simspark::AgentCommand& command) { connection.send(simspark::writeAgentCommand(command)); }
  /// Takes part for so many cycles; returns what was received. The first answer asks for the place in the
  /// team.
  std::string play(int cycles) {
    std::string all;
    for (int i = 0; i < cycles; ++i) {
      const std::string text = receive();
      if (text.empty()) return all + "gone";
      all += text + '\n';
      simspark::AgentCommand answer = std::exchange(hello, {});
      answer.syn = true;
      answer.velocity[rKneePitch] = i % 20 < 10 ? 0.5 : -0.5;
      answer.say = "w" + std::to_string(i);
      send(answer);
    }
    return all;
  }

  simspark::Connection connection;
  simspark::AgentCommand hello;
};

}  // namespace plumbline::test
