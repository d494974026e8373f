#include "web/LiveFeed.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "framework/SteadyClock.h"
#include "web/Frame.h"
#include "web/Geometry.h"

namespace plumbline::web {

using namespace simspark;

namespace {

constexpr double viewInterval = 0.03;     ///< between two frames: 25 a second at the league's 0.04 [s]
constexpr double commandPatience = 0.02;  ///< longest time a command waits [s]
constexpr double connectTimeout = 1, reconnectPause = 0.5;
constexpr std::size_t maxCommands = 1000;

}  // namespace

LiveFeed::LiveFeed(const Config& config, Broadcast& broadcast)
    : config_(config), broadcast_(broadcast), start_(steadySeconds()) {
  status_.source = config_.host + ':' + std::to_string(config_.port);
  if (!config_.record.empty()) writer_ = std::make_unique<MatchWriter>(config_.record);
  status_.recording = config_.record;
  if (config_.drawingPort >= 0) {
    try {
      drawings_ = std::make_unique<DrawingPort>(config_.drawingPort);
    } catch (const std::runtime_error& error) {
      if (!config_.drawingPortOptional)
        throw std::runtime_error(
            error.what() + std::string("; give --drawing-port another, 0 for a free one, or -1 for none"));
      drawingProblem_ = error.what();
    }
  }
  publish(Channel::geometry, geometryMessage(field_));
  stopDescriptor_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (stopDescriptor_ < 0) throw std::runtime_error("no file descriptor left");
  monitor_.interruptBy(stopDescriptor_);
  thread_ = std::thread([this] { run(); });
}

LiveFeed::~LiveFeed() {
  stop_ = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = write(stopDescriptor_, &one, sizeof one);
  thread_.join();
  close(stopDescriptor_);
  if (!writer_) return;
  try {
    writer_->flush();
  } catch (const std::runtime_error& error) {
    loseRecording(error.what());
  }
}

double LiveFeed::now() const { return steadySeconds() - start_; }

void LiveFeed::command(const PageCommand& command) {
  const std::lock_guard lock(mutex_);
  if (commands_.size() >= maxCommands) return;
  if (const auto* trainer = std::get_if<TrainerCommand>(&command)) commands_.push_back(*trainer);
  if (std::holds_alternative<ResetGame>(command))
    for (TrainerCommand& part : resetGame(field_)) commands_.push_back(std::move(part));
}

void LiveFeed::publish(Channel channel, std::string message) {
  if (writer_) {
    try {
      writer_->add(now(), channel, message);
    } catch (const std::runtime_error& error) {
      loseRecording(error.what());
    }
  }
  broadcast_.publish(channel, std::move(message));
}

void LiveFeed::loseRecording(const std::string& why) {
  writer_.reset();
  status_.recording.clear();
  status_.problem = why;
  if (config_.recordingLost) config_.recordingLost(why);
}

void LiveFeed::publishGame() {
  std::string message = gameMessage(status_, monitor_.scene(), monitor_.clock());
  if (message == sentGame_) return;
  sentGame_ = message;
  publish(Channel::game, std::move(message));
}

/// The server's first message describes the field; a page redraws what it receives again.
void LiveFeed::publishField() {
  const FieldSize& received = monitor_.scene().field;
  if (received == field_) return;
  {
    const std::lock_guard lock(mutex_);
    field_ = received;
  }
  publish(Channel::geometry, geometryMessage(received));
}

void LiveFeed::sendCommands() {
  std::vector<TrainerCommand> taken;
  {
    const std::lock_guard lock(mutex_);
    taken.swap(commands_);
  }
  for (const TrainerCommand& command : taken) {
    const bool clock = std::holds_alternative<ClockCommand>(command);
    if (!clock || monitor_.clock()) monitor_.send(command);
  }
}

void LiveFeed::attach() {
  if (const std::string why = monitor_.connect(config_.host, config_.port, config_.token, connectTimeout);
      !why.empty()) {
    status_.problem = why;
    publishGame();
    for (double waited = 0; waited < reconnectPause && !stop_; waited += 0.05)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return;
  }
  monitor_.send(ViewerCommand{viewInterval});
  monitor_.send(ClockCommand{ClockCommand::Kind::subscribe});
}

void LiveFeed::follow() {
  auto result = monitor_.receive(commandPatience);
  // A server that is faster than the eye: only the last of what has come is shown.
  for (int i = 0; i < 100 && result == Connection::Status::message && now() < lastFrame_ + viewInterval; ++i)
    result = monitor_.receive(commandPatience);
  sendCommands();
  if (result == Connection::Status::closed) {
    status_.connected = false;
    status_.problem = monitor_.error().empty() ? "the simulator has gone" : monitor_.error();
    publishGame();
    return;
  }
  if (result == Connection::Status::message && monitor_.scene().complete()) {
    lastFrame_ = now();
    status_.problem.clear();
    publishField();
    publish(Channel::frame, frameMessage(monitor_.scene()));
  }
  status_.connected = true;
  if (monitor_.scene().complete()) publishGame();
}

void LiveFeed::run() {
  while (!stop_) {
    if (drawings_)
      if (auto message = drawings_->takeChanges()) publish(Channel::drawings, std::move(*message));
    if (monitor_.connected())
      follow();
    else
      attach();
  }
}

}  // namespace plumbline::web
