#pragma once
#include <mutex>
#include <string>

#include "math/TorsoAngleFilter.h"
#include "robot/JointVelocityControl.h"
#include "simspark/AgentCommand.h"
#include "simspark/Connection.h"
#include "simspark/MonitorClient.h"
#include "simspark/ServerMessage.h"
#include "training/Walker.h"

namespace plumbline::walking {

/// Where a SimSpark server, the league's or bin/simulator, listens for agents and for trainers.
struct ServerAddress {
  std::string host = "127.0.0.1";
  int agentPort = 3100, monitorPort = 3200;

  /// From HOST:AGENTPORT:MONITORPORT, or "server" for the usual one. Throws std::invalid_argument, one line.
  static ServerAddress parse(const std::string& text);
  std::string text() const;
};

/// A robot of a SimSpark server that waits for its agents ($agentSyncMode of the league's). It senses and
/// acts like a player, and the trainer moves it to its places. Its true pose comes from the monitor port:
/// exact to 5 mm and 0.3 degrees, up to two cycles old. One at a time per server; another one of this process
/// waits for it. Errors: std::runtime_error, one line, if the server is missing, disconnects, stays silent or
/// does not wait for its agents.
class ServerWalker : public Walker {
public:
  ServerWalker(int type, const WalkGaits& gaits, const ServerAddress& address);

  /// No server pushes or carries robots: throws std::logic_error.
  void push(const Vec3& change) override;
  /// Whom a trainer moves has lost its speed.
  bool carries() const override { return false; }
  Pose3 torso() const override { return T_world_torso_; }
  /// The monitor's poses are too coarse for it: throws std::logic_error.
  Vec2 comVelocity() override;

private:
  void put(const Pose2& place, const JointArray& angles) override;
  void move(const Vec2& place) override;
  WalkSensors sense() override;
  void act(const WalkOutput& output, const WalkSensors& sensors) override;

  /// Comes to the server as a new robot.
  void join();
  /// A cycle in which the joints go to these angles [rad].
  void drive(const JointArray& targets);
  /// Answers with a command and takes in what comes of it.
  void exchange(simspark::AgentCommand command);
  /// Takes in the scenes that came.
  void follow();
  /// Puts it upright with its torso so high over a place [m].
  void teleport(const Pose2& place, double height);
  std::runtime_error failure(const std::string& what) const;

  const int type_;
  const ServerAddress address_;
  const std::unique_lock<std::mutex> alone_;  ///< among those of this server
  simspark::Connection agent_;
  simspark::MonitorClient trainer_;
  simspark::ServerMessage message_;
  simspark::PlayerName name_;
  JointVelocityControl control_;
  TorsoAngleFilter filter_;
  JointArray measured_{};
  Pose3 T_world_torso_ = Pose3::Identity();
  long cycles_ = 0, unseen_ = 0, lost_ = 0;  ///< unseen: since the last scene
};

}  // namespace plumbline::walking
