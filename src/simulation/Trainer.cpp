#include "simulation/Trainer.h"

#include <variant>

#include "math/Angle.h"
#include "simulation/Field.h"

namespace plumbline::simulation {

using namespace simspark;

namespace {
const char* const noSuchPlayer = "trainer: no such player";
constexpr double asideDistance = 1;  ///< beyond the side line [m]
}  // namespace

std::string Trainer::carryOut(const TrainerCommand& command) {
  return std::visit([this](const auto& c) { return apply(c); }, command);
}

Player* Trainer::playerOrSelected(const std::optional<PlayerName>& name) {
  if (name) return s.find(*name);
  for (auto& [id, player] : s.players)
    if (player->selected) return player.get();
  return nullptr;
}

std::string Trainer::apply(const MoveAgentCommand& command) {
  if (!command.player) {
    if (Player* player = playerOrSelected({})) moveAside(*player);
    return {};
  }
  const Player* player = s.find(*command.player);
  if (!player) return noSuchPlayer;
  if (!command.position) return {};
  Pose3 pose = translation(*command.position);
  pose.linear() =
      command.heading ? rotationZ(*command.heading).linear() : s.world_->torso(player->robot).pose.linear();
  s.world_->moveRobot(player->robot, pose);
  return {};
}

std::string Trainer::apply(const BallCommand& command) {
  BodyState ball = s.world_->ball();
  if (command.position) ball.pose.translation() = *command.position;
  if (command.velocity) {
    ball.linearVelocity = *command.velocity;
    ball.angularVelocity.setZero();
  }
  s.world_->setBall(ball);
  return {};
}

std::string Trainer::apply(const PlayModeCommand& command) {
  s.game_.setMode(command.mode);
  return {};
}

std::string Trainer::apply(const KickOffCommand& command) {
  s.referee->kickOff(s.game_, command.side);
  return {};
}

std::string Trainer::apply(const DropBallCommand&) {
  s.referee->dropBall(s.game_, *s.world_);
  return {};
}

std::string Trainer::apply(const TimeCommand& command) {
  s.game_.time = command.time;
  return {};
}

std::string Trainer::apply(const ScoreCommand& command) {
  s.game_.score = {command.left, command.right};
  return {};
}

std::string Trainer::apply(const SelectCommand& command) {
  Player* next = nullptr;
  if (command.player) {
    next = s.find(*command.player);
    if (!next) return noSuchPlayer;
  } else if (!command.clear) {  // the one after the selected, the first after the last
    bool passed = false;
    for (auto& [id, player] : s.players) {
      if (passed && !next) next = player.get();
      passed = passed || player->selected;
    }
    if (!next && !s.players.empty()) next = s.players.begin()->second.get();
  }
  for (auto& [id, player] : s.players) player->selected = player.get() == next;
  return {};
}

std::string Trainer::apply(const KillCommand& command) {
  const Player* player = playerOrSelected(command.player);
  if (!player) return noSuchPlayer;
  const PlayerId id = player->id();
  s.removePlayer(id);
  s.killed.push_back(id);
  return {};
}

std::string Trainer::apply(const RepositionCommand& command) {
  Player* player = playerOrSelected(command.player);
  if (!player) return noSuchPlayer;
  moveAside(*player);
  return {};
}

/// Beside the field, on the side away from the ball, each number at its own place of the own half.
void Trainer::moveAside(Player& player) {
  const double x = -(fieldLength / 2 - 1.0 - player.unum);
  const double y = fieldWidth / 2 + asideDistance;
  const double ballY = s.world_->ball().pose.translation().y();
  Pose3 pose = s.world_->torso(player.robot).pose;
  pose.translation() = Vec3(player.side == TeamSide::right ? -x : x, ballY > 0 ? -y : y, 0.4);
  s.world_->moveRobot(player.robot, pose);
}

}  // namespace plumbline::simulation
