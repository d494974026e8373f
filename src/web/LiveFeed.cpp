#include "web/LiveFeed.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "web/Frame.h"
#include "web/Geometry.h"

namespace plumbline::web {

using namespace simspark;

namespace {

constexpr double viewInterval = 0.03;  ///< between two frames: 25 a second at the league's 0.04 [s]
constexpr double patience = 0.02;      ///< longest time a command waits [s]
constexpr double connectTimeout = 1, reconnectPause = 0.5;
constexpr std::size_t maxCommands = 1000;

double wallClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

LiveFeed::LiveFeed(const Config& config_, Broadcast& broadcast_)
    : config(config_), broadcast(broadcast_), start(wallClock()) {
  status.source = config.host + ':' + std::to_string(config.port);
  if (!config.record.empty()) writer = std::make_unique<MatchWriter>(config.record);
  status.recording = config.record;
  if (config.drawingPort >= 0) {
    try {
      drawings = std::make_unique<DrawingPort>(config.drawingPort);
    } catch (const std::runtime_error& error) {
      if (!config.drawingPortOptional)
        throw std::runtime_error(
            error.what() + std::string("; give --drawing-port another, 0 for a free one, or -1 for none"));
      drawingProblem_ = error.what();
    }
  }
  publish(Channel::geometry, geometryMessage(field));
  stopDescriptor = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (stopDescriptor < 0) throw std::runtime_error("no file descriptor left");
  monitor.interruptBy(stopDescriptor);
  thread = std::thread([this] { run(); });
}

LiveFeed::~LiveFeed() {
  stop = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = write(stopDescriptor, &one, sizeof one);
  thread.join();
  close(stopDescriptor);
  if (!writer) return;
  try {
    writer->flush();
  } catch (const std::runtime_error& error) {
    loseRecording(error.what());
  }
}

double LiveFeed::now() const { return wallClock() - start; }

void LiveFeed::command(const PageCommand& command) {
  const std::lock_guard lock(mutex);
  if (commands.size() >= maxCommands) return;
  if (const auto* trainer = std::get_if<TrainerCommand>(&command)) commands.push_back(*trainer);
  if (std::holds_alternative<ResetGame>(command))
    for (TrainerCommand& part : resetGame(field)) commands.push_back(std::move(part));
}

void LiveFeed::publish(Channel channel, std::string message) {
  if (writer) {
    try {
      writer->add(now(), channel, message);
    } catch (const std::runtime_error& error) {
      loseRecording(error.what());
    }
  }
  broadcast.publish(channel, std::move(message));
}

void LiveFeed::loseRecording(const std::string& why) {
  writer.reset();
  status.recording.clear();
  status.problem = why;
  if (config.recordingLost) config.recordingLost(why);
}

void LiveFeed::publishGame() {
  std::string message = gameMessage(status, monitor.scene(), monitor.clock());
  if (message == toldGame) return;
  toldGame = message;
  publish(Channel::game, std::move(message));
}

/// The server's first message tells what field it is; a page draws anew what it is told anew.
void LiveFeed::publishField() {
  const FieldSize& told = monitor.scene().field;
  if (told == field) return;
  {
    const std::lock_guard lock(mutex);
    field = told;
  }
  publish(Channel::geometry, geometryMessage(told));
}

void LiveFeed::sendCommands() {
  std::vector<TrainerCommand> taken;
  {
    const std::lock_guard lock(mutex);
    taken.swap(commands);
  }
  for (const TrainerCommand& command : taken) {
    const bool clock = std::holds_alternative<ClockCommand>(command);
    if (!clock || monitor.clock()) monitor.send(command);
  }
}

void LiveFeed::attach() {
  if (const std::string why = monitor.connect(config.host, config.port, config.token, connectTimeout);
      !why.empty()) {
    status.problem = why;
    publishGame();
    for (double waited = 0; waited < reconnectPause && !stop; waited += 0.05)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return;
  }
  monitor.send(ViewerCommand{viewInterval});
  monitor.send(ClockCommand{ClockCommand::Kind::tell});
}

void LiveFeed::follow() {
  auto result = monitor.receive(patience);
  // A server that is faster than the eye: only the last of what has come is shown.
  for (int i = 0; i < 100 && result == Connection::Status::message && now() < lastFrame + viewInterval; ++i)
    result = monitor.receive(patience);
  sendCommands();
  if (result == Connection::Status::closed) {
    status.connected = false;
    status.problem = monitor.error().empty() ? "the simulator has gone" : monitor.error();
    publishGame();
    return;
  }
  if (result == Connection::Status::message && monitor.scene().complete()) {
    lastFrame = now();
    status.problem.clear();
    publishField();
    publish(Channel::frame, frameMessage(monitor.scene()));
  }
  status.connected = true;
  if (monitor.scene().complete()) publishGame();
}

void LiveFeed::run() {
  while (!stop) {
    if (drawings)
      if (auto message = drawings->takeChanges()) publish(Channel::drawings, std::move(*message));
    if (monitor.connected())
      follow();
    else
      attach();
  }
}

}  // namespace plumbline::web
