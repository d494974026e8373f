#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simspark/ChildProcess.h"
#include "simspark/MonitorClient.h"
#include "simspark/SimulatorProcess.h"

namespace plumbline::bench {

/// Players of a team in a game for trying something.
struct TrainedTeam {
  std::string name;
  std::string programs;                ///< folder of the players' program, whose configuration is beside it
  std::vector<std::string> options{};  ///< of the program
  std::vector<int> types{};            ///< robot types of the players
  int firstNumber = 1;                 ///< the others have the next ones
};

/// Two teams on a simulator of their own, and a trainer that puts ball and robots where they are wanted.
class TrainedGame {
public:
  /// Starts simulator and players, the left team first. `scratch` is a folder for ports and logs. Throws
  /// std::runtime_error, one line.
  TrainedGame(const std::string& programs, const std::string& scratch, std::uint64_t seed,
              const TrainedTeam& left, const TrainedTeam& right);
  ~TrainedGame();
  TrainedGame(const TrainedGame&) = delete;
  TrainedGame& operator=(const TrainedGame&) = delete;

  const simspark::SceneState& scene() const { return trainer_.scene(); }
  template <class Command>
  void send(const Command& command) {
    trainer_.send(command);
  }
  /// Waits for the next scene. Throws std::runtime_error if the simulator has ended.
  void nextScene();
  /// Until a scene is as wanted. Throws std::runtime_error after too many others.
  void await(const char* what, const std::function<bool(const simspark::SceneState&)>& isSo);
  /// Asks for a play mode, and waits until the scene shows it.
  void setMode(simspark::PlayMode mode);
  /// Back to before the kick-off, where all beam to their places and rest. Throws std::runtime_error, one
  /// line, if a player has ended.
  void begin();

private:
  void start(const TrainedTeam& team);

  std::string scratch_;
  simspark::SimulatorProcess simulator_;
  simspark::MonitorClient trainer_;
  std::vector<std::unique_ptr<simspark::ChildProcess>> agents_;
};

}  // namespace plumbline::bench
