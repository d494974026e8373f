#pragma once
#include <optional>
#include <string>

#include "math/Pose2.h"
#include "math/Types.h"
#include "simspark/Connection.h"
#include "simspark/StandardPorts.h"
#include "simspark/TrainerCommand.h"

namespace plumbline {

/// A module reaches it through object<Monitor>(): commands to SimSpark's monitor port, for training and
/// tests. Places are in the server's field frame, x towards the right goal [m, rad]. Connects when first
/// used, and again after the simulator was restarted. Every command returns false if it could not be sent;
/// error() says why.
class Monitor {
public:
  /// The server to talk to from now on; an open connection to another one is closed.
  void setServer(const std::string& host, int port);

  /// Token of the server; empty: none.
  void setToken(const std::string& token) { token_ = token; }
  /// Ends every wait when it becomes readable (simspark::Connection).
  void interruptBy(int stopDescriptor) { connection_.interruptBy(stopDescriptor); }

  bool moveBall(const Vec3& position, const Vec3& velocity = Vec3::Zero());
  /// Upright at this place and heading, standing height above the ground.
  bool moveRobot(simspark::TeamSide side, int number, const Pose2& place, double height = 0.4);
  bool setPlayMode(simspark::PlayMode mode);
  bool kickOff(simspark::TeamSide side);
  bool send(const simspark::TrainerCommand& command);
  const std::string& error() const { return error_; }

private:
  bool sendText(const std::string& text);

  std::string host_ = "127.0.0.1";
  int port_ = simspark::standardMonitorPort;
  simspark::Connection connection_;
  std::string token_, error_;
};

}  // namespace plumbline
