#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "simspark/MonitorClient.h"
#include "web/Broadcast.h"
#include "web/DrawingPort.h"
#include "web/Feed.h"
#include "web/GameMessage.h"
#include "web/MatchFile.h"

namespace plumbline::web {

/// Follows the game on a monitor port and connects anew when it goes away; takes the agents' drawings and
/// records what is published, if asked to.
class LiveFeed : public Feed {
public:
  struct Config {
    std::string host = "127.0.0.1";
    int port = 3200;
    std::string token{};               ///< of the monitor port
    int drawingPort = 32769;           ///< UDP on the loopback interface; -1: none
    bool drawingPortOptional = false;  ///< do without if it is in use
    std::string record{};              ///< file; empty: none
  };
  /// Throws std::runtime_error, one line, if the drawing port or the file cannot be had.
  LiveFeed(const Config& config, Broadcast& broadcast);
  ~LiveFeed() override;

  void command(const PageCommand& command) override;
  int drawingPort() const { return drawings ? drawings->port() : -1; }

private:
  void run();
  void attach();
  void follow();
  void sendCommands();
  void publishGame();
  void publish(Channel channel, std::string message);
  double now() const;

  Config config;
  Broadcast& broadcast;
  std::unique_ptr<DrawingPort> drawings;
  std::unique_ptr<MatchWriter> writer;
  simspark::MonitorClient monitor;
  GameStatus status;
  std::string toldGame;
  double start, lastFrame = -1;

  std::mutex mutex;
  std::vector<simspark::TrainerCommand> commands;
  std::atomic<bool> stop = false;
  std::thread thread;
};

}  // namespace plumbline::web
