#pragma once
#include <string>

#include "simspark/TrainerCommand.h"
#include "simulation/Simulation.h"

namespace plumbline::simulation {

/// Carries out trainer commands in a simulation. Each returns why it could not, one line, or nothing.
class Trainer {
public:
  explicit Trainer(Simulation& simulation_) : s(simulation_) {}
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

  /// The player of that name, or the selected one without a name; null: there is none.
  Player* playerOrSelected(const std::optional<simspark::PlayerName>& name);
  /// Beside the field, where the referee puts offenders.
  void moveAside(Player& player);

  Simulation& s;
};

}  // namespace plumbline::simulation
