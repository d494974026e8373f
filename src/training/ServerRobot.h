#pragma once
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>

#include "math/Pose2.h"
#include "math/TorsoAngleFilter.h"
#include "robot/JointVelocityControl.h"
#include "simspark/AgentCommand.h"
#include "simspark/Connection.h"
#include "simspark/MonitorClient.h"
#include "simspark/ServerMessage.h"
#include "simspark/ServerMessageParser.h"
#include "simspark/StandardPorts.h"
#include "simulation/world/World.h"

namespace plumbline::training {

/// Where a SimSpark server, the league's or bin/simulator, listens for agents and for trainers.
struct SimSparkAddress {
  std::string host = "127.0.0.1";
  int agentPort = simspark::standardAgentPort, monitorPort = simspark::standardMonitorPort;

  /// From HOST:AGENTPORT:MONITORPORT, or "server" for the usual one. Throws std::invalid_argument, one line.
  static SimSparkAddress parse(const std::string& text);
  std::string text() const;
};

/// A robot of a SimSpark server that waits for its agents ($agentSyncMode of the league's), and the trainer
/// that moves robot and ball. True poses come from the monitor port: exact to 5 mm and 0.3 degrees, up to two
/// cycles old. One at a time per server; another one of this process waits for it. Errors:
/// std::runtime_error, one line, if the server is missing, disconnects, stays silent or does not wait for its
/// agents.
class ServerRobot {
public:
  static constexpr double cycleSeconds = 0.02;

  ServerRobot(int type, const SimSparkAddress& address);

  const simulation::RobotReadings& readings() const { return readings_; }
  const Pose3& torso() const { return T_world_torso_; }
  const Vec3& ball() const { return trainer_.scene().ball; }  ///< centre [m, field]
  bool playsOn() const { return trainer_.scene().playMode == "PlayOn"; }
  /// The vertical as gyro and accelerometer tell it.
  const TorsoAngleFilter& attitude() const { return attitude_; }
  long cycles() const { return cycles_; }  ///< since this object came to the server

  /// A cycle in which the joints go to these targets [rad].
  void drive(const JointArray& targets);
  /// Play goes on, and the robot stands at rest with these joint angles. A robot that fell is replaced by a
  /// new one, for there were some on the league's server that then never stood again.
  void put(const Pose2& place, const JointArray& angles);
  /// The same, but the robot is let go upright, its soles so high over the ground [m], and has no time to
  /// come to rest.
  void drop(const Pose2& place, const JointArray& angles, double height);
  /// The ball lies at rest there [m, field].
  void putBall(const Vec2& place);

private:
  /// Comes to the server as a new robot. The one before leaves when the new one is there: a server without
  /// any agent sits still for two seconds.
  void join();
  /// Answers with a command and takes in what comes of it.
  void exchange(simspark::AgentCommand command);
  /// Waits for the robot's next message, and answers for the one that is leaving.
  simspark::Connection::Status receive(std::string_view& text);
  /// Takes in the scenes that came.
  void follow();
  /// Puts it upright with its torso so high over a place [m].
  void teleport(const Pose2& place, double height);
  std::runtime_error failure(const std::string& what) const;

  const int type_;
  const SimSparkAddress address_;
  const std::unique_lock<std::mutex> alone_;  ///< among those of this server
  RobotModel model_;
  simspark::Connection agent_;
  simspark::Connection leaving_;  ///< of the robot before, while a new one joins
  simspark::MonitorClient trainer_;
  simspark::ServerMessageParser parser_;
  simspark::ServerMessage message_;
  simulation::RobotReadings readings_;
  simspark::PlayerName name_;
  JointVelocityControl control_;
  TorsoAngleFilter attitude_;
  Pose3 T_world_torso_ = Pose3::Identity();
  long cycles_ = 0, unseen_ = 0, lost_ = 0;  ///< unseen: since the last scene
};

}  // namespace plumbline::training
