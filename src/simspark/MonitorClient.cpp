#include "simspark/MonitorClient.h"

namespace plumbline::simspark {

std::string MonitorClient::connect(const std::string& host, int port, const std::string& token,
                                   double timeoutSeconds) {
  problem_.clear();
  state_ = SceneState();
  clock_.reset();
  connection_.listensOnly();
  if (std::string error = connection_.connect(host, port, timeoutSeconds); !error.empty()) return error;
  if (!token.empty()) connection_.send("(token " + token + ")");
  return {};
}

Connection::Status MonitorClient::receive(double timeoutSeconds) {
  std::string_view message;
  const auto status = connection_.receive(message, timeoutSeconds);
  if (status != Connection::Status::message) return status;
  if (message == "best") return status;  // the answer to (getAck)
  if (const auto received = readClock(message)) {
    clock_ = received;
    return status;
  }
  problem_ = state_.update(message);
  if (problem_.empty()) return status;
  connection_.close();
  return Connection::Status::closed;
}

bool MonitorClient::poll() {
  for (;;) {
    const auto status = receive(0);
    if (status == Connection::Status::closed) return false;
    if (status == Connection::Status::timeout) return true;
  }
}

}  // namespace plumbline::simspark
