#include "optimization/farm/FarmClient.h"

#include <poll.h>

#include <stdexcept>

namespace plumbline::farm {
namespace {

constexpr double patience = 10;  ///< for the server's first line [s]
constexpr std::size_t mostUnsent = 4 * maxLine;

std::string placeOf(const FarmAddress& server) { return server.host + ':' + std::to_string(server.port); }

bool isReadable(int descriptor) {
  pollfd one{descriptor, POLLIN, 0};
  return poll(&one, 1, 0) > 0;
}

}  // namespace

FarmClient::FarmClient(const FarmAddress& server, const std::string& name, int stopDescriptor)
    : place_("the optimisation server at " + placeOf(server)),
      stopDescriptor_(stopDescriptor),
      socket_(connectTo(server.host, server.port, stopDescriptor), maxLine, mostUnsent) {
  socket_.send(text(Hello{Hello::Role::worker, name, server.token}));
  for (double waited = 0; welcome_.task.empty() && over_.empty(); waited += 0.1) {
    if (waited > patience) throw std::runtime_error(place_ + " says nothing");
    if (isReadable(stopDescriptor_)) throw std::runtime_error(place_ + " had said nothing before the stop");
    socket_.wait(0.1, stopDescriptor_);
    while (take()) {
    }
  }
}

/// Takes in one line that has come; false: there is none.
bool FarmClient::take() {
  std::string line;
  if (!socket_.next(line)) {
    if (socket_.broken()) throw std::runtime_error(place_ + ' ' + socket_.reason());
    return false;
  }
  ToWorker message;
  try {
    message = readToWorker(line);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(place_ + ": " + error.what());
  }
  if (!message.error.empty()) throw std::runtime_error(place_ + ": " + message.error);
  if (!message.over.empty()) over_ = message.over;
  if (message.welcome) welcome_ = *message.welcome;
  if (message.trial) {
    if (message.trial->parameters.size() != welcome_.parameters)
      throw std::runtime_error(place_ + ": a trial has another number of parameters than announced");
    trial_ = std::move(message.trial);
  }
  return true;
}

std::optional<Trial> FarmClient::next(double seconds) {
  while (!trial_ && !isOver() && take()) {
  }
  if (!trial_ && !isOver()) socket_.wait(seconds, stopDescriptor_);
  while (!trial_ && !isOver() && take()) {
  }
  std::optional<Trial> trial;
  trial.swap(trial_);
  return trial;
}

void FarmClient::tell(const Trial& trial, std::span<const double> costs,
                      const std::map<std::string, double>& figures) {
  socket_.send(text(Answer{trial.number, {costs.begin(), costs.end()}, figures}));
}

std::string readStatus(const FarmAddress& server) {
  LineSocket socket(connectTo(server.host, server.port), maxLine, mostUnsent);
  socket.send(text(Hello{Hello::Role::status, "status", server.token}));
  std::string line;
  for (double waited = 0; !socket.next(line); waited += 0.1) {
    const std::string place = "the optimisation server at " + placeOf(server);
    if (socket.broken()) throw std::runtime_error(place + ' ' + socket.reason());
    if (waited > patience) throw std::runtime_error(place + " says nothing");
    socket.wait(0.1);
  }
  return line;
}

}  // namespace plumbline::farm
