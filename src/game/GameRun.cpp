#include "game/GameRun.h"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "framework/FileLines.h"
#include "framework/ReadFile.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "game/OutputFolder.h"
#include "game/StatusReader.h"
#include "math/Angle.h"
#include "simspark/ChildProcess.h"
#include "simspark/MonitorClient.h"
#include "simspark/SimulatorProcess.h"

namespace plumbline::game {

using simspark::Connection;

namespace {

/// For the robot to drop onto the field, beam and come to rest [s].
constexpr double secondsBeforeKickOff = 2;

void print(const std::string& text) {
  fmt::print("{}", text);
  std::fflush(stdout);
}

}  // namespace

/// The processes of a run.
class GameRun::Session {
public:
  Session(const GameOptions& options, const StopSignal& stop)
      : options_(options), programs_(programFolder()) {
    prepareOutput(options.output, {"agent.log", "simulator.log", "agent.json", "simulator.json",
                                   "summary.json", "track.svg", "track.csv"});
    ports_ = {options.port, options.monitorPort};
    try {
      if (options.host.empty()) startSimulator(stop);
      monitor.interruptBy(stop.fileDescriptor());
      if (const std::string why = monitor.connect(host(), ports_.monitor); !why.empty())
        throw std::runtime_error(why);
    } catch (const std::runtime_error&) {
      if (stop.requested()) throw Stopped("interrupted");
      throw;
    }
    startAgent();
  }

  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  /// After an error as well.
  ~Session() { askToStop(); }

  std::string file(const std::string& name) const { return options_.output + "/" + name; }

  /// Throws if a program is no more though nobody has stopped it.
  void check() {
    if (!agent_->running())
      throw std::runtime_error(fmt::format("the agent ended with status {}: {}", *agent_->exitStatus(),
                                           lastLine(file("agent.log"))));
    if (simulator_ && !simulator_->process().running() && *simulator_->process().exitStatus() != 0)
      throw std::runtime_error(fmt::format("the simulator ended with status {}: {}",
                                           *simulator_->process().exitStatus(),
                                           lastLine(file("simulator.log"))));
  }

  /// Both together: two that hang take no longer than one.
  void stop() {
    monitor.close();
    askToStop();
    if (agent_) {
      agent_->stop();
      if (*agent_->exitStatus() == 128 + SIGKILL)
        fmt::print(stderr, "game: the agent did not end and was killed; its crash log says where it was\n");
    }
    if (simulator_) simulator_->process().stop();
  }

  /// What a program has written about its cost [us per cycle]; 0 if it has not.
  static double cost(const std::string& path) {
    if (!std::filesystem::exists(path)) return 0;
    const auto json = nlohmann::json::parse(readFile(path, 1 << 20), nullptr, false);
    return json.is_discarded() ? 0 : json.value("cpu_us_per_cycle", 0.0);
  }

  simspark::MonitorClient monitor;

private:
  /// The agent first: it would try to reconnect.
  void askToStop() {
    if (agent_) agent_->askToStop();
    if (simulator_) simulator_->process().askToStop();
  }

  std::string host() const { return options_.host.empty() ? "127.0.0.1" : options_.host; }

  void startSimulator(const StopSignal& stop) {
    std::vector<std::string> arguments = {"--sync",
                                          "--seed",
                                          std::to_string(options_.seed),
                                          "--kickoff-after",
                                          fmt::format("{}", secondsBeforeKickOff),
                                          "--wait-agents",  // in real time, too: the start decides the run
                                          "1",
                                          "--monitor-step",
                                          "0.1",
                                          "--stats",
                                          file("simulator.json"),
                                          "--die-with-parent"};
    arguments.insert(arguments.end(), {"--engine", options_.engine});
    addField(arguments);
    if (!options_.stay)
      arguments.insert(arguments.end(), {"--max-seconds", fmt::format("{}", options_.limit)});
    if (options_.realtime) arguments.emplace_back("--realtime");
    if (options_.web) arguments.emplace_back("--web");
    arguments.insert(arguments.end(), options_.simulatorOptions.begin(), options_.simulatorOptions.end());
    simulator_.emplace(programs_ + "/simulator", arguments, file("ports.json"), file("simulator.log"),
                       [&stop] { return stop.requested(); });
    ports_ = simulator_->ports();
    if (ports_.web > 0) {
      fmt::print("watch at http://localhost:{}/\n", ports_.web);
      std::fflush(stdout);
    }
  }

  void startAgent() {
    std::vector<std::string> arguments = {programs_ + "/agent",
                                          "--type",
                                          std::to_string(options_.type),
                                          "--host",
                                          host(),
                                          "--port",
                                          std::to_string(ports_.agent),
                                          "--monitor-port",
                                          std::to_string(ports_.monitor),
                                          "--status",
                                          "--stats",
                                          file("agent.json")};
    addField(arguments);
    arguments.insert(arguments.end(), options_.agentOptions.begin(), options_.agentOptions.end());
    agent_.emplace(arguments, file("agent.log"));
  }

  /// The same field for both.
  void addField(std::vector<std::string>& arguments) const {
    if (!options_.field.empty()) arguments.insert(arguments.end(), {"--field", options_.field});
  }

  static std::string lastLine(const std::string& path) {
    std::string last;
    if (!std::filesystem::exists(path)) return "see " + path;
    FileLines lines(path);
    for (std::string line; lines.next(line);)
      if (!line.empty()) last = line;
    return last.empty() ? "see " + path : last;
  }

  const GameOptions& options_;
  std::string programs_;
  simspark::Ports ports_;
  std::optional<simspark::SimulatorProcess> simulator_;
  std::optional<simspark::ChildProcess> agent_;
};

void GameRun::countFalls(const simspark::SceneRobot& robot, double time) {
  const double up = robot.T_world_torso.linear()(2, 2);
  if (up > 0.9) {
    stood_ = true;
    fallen_ = false;
  }
  if (stood_ && !fallen_ && up < 0.5) {
    fallen_ = true;
    ++summary_.falls;
  }
  track_.push_back({time, robot.T_world_torso.translation().head<2>(), Vec2::Zero(), fallen_});
}

void GameRun::watch(const simspark::SceneState& scene) {
  const simspark::SceneRobot* robot = scene.robots.empty() ? nullptr : &scene.robots.front();
  if (!robot) return;
  countFalls(*robot, scene.time);
  track_.back().ball = scene.ball.head<2>();
  const Pose3& pose = robot->T_world_torso;
  table_ += fmt::format("{:.2f},{:.3f},{:.3f},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{}\n", scene.time,
                        pose.translation().x(), pose.translation().y(), robot->heading(), pose.linear()(2, 2),
                        scene.ball.x(), scene.ball.y(), scene.ball.z(), scene.playMode);
  if (!summary_.goal && scene.scoreLeft > 0) {
    summary_.goal = true;
    summary_.goalTime = scene.time;
  }
  if (scene.time < nextLine_ && !summary_.goal) return;
  if (scene.time <= 0 && nextLine_ > 0) return;
  nextLine_ = scene.time + 1 - 1e-6;
  const Vec3 torso = robot->T_world_torso.translation();
  lines_.add({scene.time,
              fmt::format("{:5.0f} s  robot ({:6.2f}, {:6.2f}) {:4.0f} deg  ball ({:6.2f}, {:6.2f})  {:<13}",
                          scene.time, torso.x(), torso.y(), toDegrees(robot->heading()), scene.ball.x(),
                          scene.ball.y(), scene.playMode),
              fallen_, summary_.goal});
}

void GameRun::stay(Session& session, StopSignal& stop) const {
  session.monitor.send(simspark::ClockCommand{simspark::ClockCommand::Kind::pause});
  fmt::print("{}; the page stays on the last picture: press Ctrl-C to end\n",
             summary_.goal ? fmt::format("goal after {:.2f} s", summary_.goalTime) : "no goal");
  std::fflush(stdout);
  // What comes is read, or the simulator would have to keep it.
  while (!stop.requested() && session.monitor.receive(0.1) != Connection::Status::closed) session.check();
}

Summary GameRun::play(StopSignal& stop) {
  const auto start = std::chrono::steady_clock::now();
  const auto wall = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Session session(options_, stop);
  StatusReader status(session.file("agent.log"));
  bool kickedOff = options_.host.empty();
  double lastMessage = 0;
  while (!stop.requested() && !summary_.goal) {
    const auto result = session.monitor.receive(0.1);
    if (result == Connection::Status::closed) {
      session.check();
      break;  // the simulator has ended in time
    }
    if (result == Connection::Status::timeout) {
      session.check();
      if (wall() - lastMessage > 30) throw std::runtime_error("no message from the simulator for 30 s");
      continue;
    }
    lastMessage = wall();
    const simspark::SceneState& scene = session.monitor.scene();
    watch(scene);
    print(lines_.due(scene.time, status.read()));
    summary_.simTime = scene.time + (options_.host.empty() ? secondsBeforeKickOff : 0);
    if (scene.time > options_.limit || scene.playMode == "GameOver") break;
    if (options_.stay && summary_.simTime >= options_.limit) break;
    // A server that runs already gets the kick-off command once the robot stands.
    if (!kickedOff && stood_ && wall() > 2) {
      session.monitor.send(simspark::KickOffCommand{simspark::TeamSide::left});
      kickedOff = true;
    }
  }
  print(lines_.rest(session.monitor.scene().time, status.read()));
  summary_.over = !stop.requested();
  if (options_.stay && summary_.over) stay(session, stop);
  session.stop();
  summary_.wall = wall();
  summary_.agentCpu = Session::cost(session.file("agent.json"));
  summary_.simulatorCpu = Session::cost(session.file("simulator.json"));
  writeFile(session.file("track.svg"),
            trackPicture(track_,
                         fmt::format("Robot type {} (blue) and ball (orange), seed {}: {}", options_.type,
                                     options_.seed,
                                     summary_.goal ? fmt::format("goal after {:.1f} s", summary_.goalTime)
                                                   : std::string("no goal")),
                         session.monitor.scene().field));
  writeFile(session.file("track.csv"), table_);
  writeFile(session.file("summary.json"), toJson(summary_));
  return summary_;
}

}  // namespace plumbline::game
