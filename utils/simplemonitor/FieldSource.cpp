#include "FieldSource.h"

#include <utility>

#include "simspark/TrainerCommand.h"

namespace plumbline::simplemonitor {

using simspark::Connection;

namespace {
constexpr double patience = 3;  ///< for a connection [s]
}  // namespace

FieldSource::FieldSource(std::string host, std::vector<int> ports, std::string token)
    : host_(std::move(host)), token_(std::move(token)), ports_(std::move(ports)), port_(ports_.front()) {}

std::string FieldSource::connect() {
  std::string problems;
  complete_ = false;
  scene_ = simspark::FieldScene();
  for (const int candidate : ports_) {
    std::string why = connection_.connect(host_, candidate, patience);
    if (why.empty()) {
      port_ = candidate;
      problem_.clear();
      if (!token_.empty()) connection_.send("(token " + token_ + ")");
      // This project's monitor port then sends no more often than that; others ignore it.
      connection_.send(simspark::writeTrainerCommand(simspark::ViewerCommand{simspark::fieldInterval}));
      return {};
    }
    if (!problems.empty()) {
      problems += ", nor to port " + std::to_string(candidate);
      if (const auto colon = why.rfind(": "); colon != std::string::npos) problems += why.substr(colon);
    } else {
      problems = std::move(why);
    }
  }
  return problems;
}

void FieldSource::lose(const std::string& why) {
  problem_ = why.empty() ? "the simulator has gone" : why;
  connection_.close();
  complete_ = false;
}

bool FieldSource::take(std::string_view message) {
  if (message == "best" || simspark::readClock(message)) return false;
  std::string why;
  if (simspark::isFieldMessage(message)) {
    why = simspark::readFieldMessage(message, state_);
  } else {
    why = scene_.update(message);
    if (why.empty() && !scene_.complete()) return false;
  }
  if (!why.empty()) {
    lose(name() + " sent no monitor's message: " + why);
    return false;
  }
  complete_ = true;
  return true;
}

bool FieldSource::receive(double timeoutSeconds) {
  bool fresh = false;
  while (connection_.connected()) {
    std::string_view message;
    const auto status = connection_.receive(message, fresh ? 0 : timeoutSeconds);
    if (status == Connection::Status::timeout) break;
    if (status == Connection::Status::closed) {
      lose(connection_.error());
      break;
    }
    bytes_ += simspark::frameHeaderSize + message.size();
    fresh = take(message) || fresh;
  }
  if (fresh && complete_ && scene_.complete()) state_ = scene_.state();
  return fresh && complete_;
}

}  // namespace plumbline::simplemonitor
