#include "modules/simspark/Monitor.h"

#include "framework/ModuleObjects.h"

namespace plumbline {

MAKE_MODULE_OBJECT(Monitor, Monitor)

void Monitor::setServer(const std::string& host, int port) {
  if (host != host_ || port != port_) connection_.close();
  host_ = host;
  port_ = port;
}

bool Monitor::moveBall(const Vec3& position, const Vec3& velocity) {
  return send(simspark::BallCommand{position, velocity});
}

bool Monitor::moveRobot(simspark::TeamSide side, int number, const Pose2& place, double height) {
  return send(simspark::MoveAgentCommand{simspark::PlayerName{number, side},
                                         Vec3(place.x(), place.y(), height), place.heading});
}

bool Monitor::setPlayMode(simspark::PlayMode mode) { return send(simspark::PlayModeCommand{mode}); }

bool Monitor::kickOff(simspark::TeamSide side) { return send(simspark::KickOffCommand{side}); }

bool Monitor::send(const simspark::TrainerCommand& command) {
  const std::string text = simspark::writeTrainerCommand(command);
  // A connection that the simulator has closed shows only when it is used: one more try.
  return sendText(text) || sendText(text);
}

bool Monitor::sendText(const std::string& text) {
  if (!connection_.connected()) {
    error_ = connection_.connect(host_, port_, 1.0);
    if (!error_.empty()) return false;
    if (!token_.empty()) connection_.send("(token " + token_ + ")");
  }
  // The scene that the port sends is of no use here, but nobody else would take it away.
  std::string_view scene;
  while (connection_.receive(scene, 0) == simspark::Connection::Status::message) {
  }
  if (connection_.connected() && connection_.send(text)) return true;
  error_ = connection_.error();
  connection_.close();
  return false;
}

}  // namespace plumbline
