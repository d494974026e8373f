#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "simspark/MonitorClient.h"
#include "simspark/StandardPorts.h"
#include "web/Broadcast.h"
#include "web/DrawingPort.h"
#include "web/Feed.h"
#include "web/GameMessage.h"
#include "web/MatchFile.h"

namespace plumbline::web {

/// Follows the game on a monitor port and reconnects after a disconnection; receives the agents' drawings and
/// can record what is published.
class LiveFeed : public Feed {
public:
  struct Config {
    std::string host = "127.0.0.1";
    int port = simspark::standardMonitorPort;
    std::string token{};               ///< of the monitor port
    int drawingPort = 32769;           ///< UDP on the loopback interface; -1: none
    bool drawingPortOptional = false;  ///< go without if it cannot be had
    std::string record{};              ///< file; empty: none
    /// Called once, in the feed's thread or its destructor, with the reason why the recording ended before
    /// the match.
    std::function<void(const std::string&)> recordingLost{};
  };
  /// Throws std::runtime_error, one line, if the drawing port or the file cannot be had.
  LiveFeed(const Config& config, Broadcast& broadcast);
  ~LiveFeed() override;

  void command(const PageCommand& command) override;
  int drawingPort() const { return drawings_ ? drawings_->port() : -1; }
  /// Why it goes without the agents' drawings, one line; empty: it does not, or nobody asked for them.
  const std::string& drawingProblem() const { return drawingProblem_; }

private:
  void run();
  void attach();
  void follow();
  void sendCommands();
  void publishGame();
  void publishField();
  void publish(Channel channel, std::string message);
  void loseRecording(const std::string& why);
  double now() const;

  Config config_;
  Broadcast& broadcast_;
  std::unique_ptr<DrawingPort> drawings_;
  std::unique_ptr<MatchWriter> writer_;
  simspark::MonitorClient monitor_;
  GameStatus status_;
  std::string sentGame_, drawingProblem_;
  double start_, lastFrame_ = -1;

  std::mutex mutex_;  ///< of the field, where the feed's thread does not only read it, and of the commands
  FieldSize field_;
  std::vector<simspark::TrainerCommand> commands_;
  std::atomic<bool> stop_ = false;
  int stopDescriptor_;  ///< readable from then on
  std::thread thread_;
};

}  // namespace plumbline::web
