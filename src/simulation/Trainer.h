#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "simspark/TrainerCommand.h"
#include "simulation/Player.h"
#include "simulation/referee/Referee.h"

namespace plumbline::simulation {

/// What a trainer may reach of a game.
struct TrainedGame {
  World& world;
  Game& game;
  Referee& referee;
  std::map<PlayerId, std::unique_ptr<Player>>& players;
  std::vector<Member> members;  ///< players with a team
  const FieldSize& field;
  std::function<void(PlayerId)> remove{};  ///< takes a player off the field; its connection is to be closed
};

/// Carries out trainer commands in a game. Each returns why it could not, one line, or nothing.
class Trainer {
public:
  explicit Trainer(TrainedGame game) : s_(std::move(game)) {}
  std::string carryOut(const simspark::TrainerCommand& command);

private:
  std::string apply(const simspark::MoveAgentCommand& command);
  std::string apply(const simspark::BallCommand& command);
  std::string apply(const simspark::PlayModeCommand& command);
  std::string apply(const simspark::KickOffCommand& command);
  std::string apply(const simspark::DropBallCommand& command);
  std::string apply(const simspark::TimeCommand& command);
  std::string apply(const simspark::ScoreCommand& command);
  std::string apply(const simspark::SelectCommand& command);
  std::string apply(const simspark::KillCommand& command);
  std::string apply(const simspark::RepositionCommand& command);
  std::string apply(const simspark::FullStateCommand&) { return {}; }
  std::string apply(const simspark::AcknowledgeCommand&) { return {}; }
  std::string apply(const simspark::KillSimulatorCommand&) { return {}; }
  std::string apply(const simspark::ClockCommand&) { return {}; }
  std::string apply(const simspark::ViewerCommand&) { return {}; }
  std::string apply(const simspark::ResetCommand&) { return {}; }

  Player* find(const simspark::PlayerName& name);
  /// The player of that name, or the selected one without a name; null: there is none.
  Player* playerOrSelected(const std::optional<simspark::PlayerName>& name);
  /// Beside the field, where the referee puts offenders.
  void moveAside(Player& player);

  TrainedGame s_;
};

}  // namespace plumbline::simulation
