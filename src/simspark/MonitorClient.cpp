#include "simspark/MonitorClient.h"

namespace plumbline::simspark {

std::string MonitorClient::connect(const std::string& host, int port, const std::string& token,
                                   double timeoutSeconds) {
  problem.clear();
  state = SceneState();
  clock_.reset();
  if (std::string error = connection.connect(host, port, timeoutSeconds); !error.empty()) return error;
  if (!token.empty()) connection.send("(token " + token + ")");
  return {};
}

Connection::Status MonitorClient::receive(double timeoutSeconds) {
  std::string_view message;
  const auto status = connection.receive(message, timeoutSeconds);
  if (status != Connection::Status::message) return status;
  if (message == "best") return status;  // the answer to (getAck)
  if (const auto told = readClock(message)) {
    clock_ = told;
    return status;
  }
  problem = state.update(message);
  if (problem.empty()) return status;
  connection.close();
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
