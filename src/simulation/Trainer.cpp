#include "simulation/Trainer.h"

#include <variant>

#include "simulation/referee/Reposition.h"

namespace plumbline::simulation {

using namespace simspark;

namespace {
const char* const noSuchPlayer = "trainer: no such player";
}  // namespace

std::string Trainer::carryOut(const TrainerCommand& command) {
  return std::visit([this](const auto& c) { return apply(c); }, command);
}

Player* Trainer::find(const PlayerName& name) {
  for (auto& [id, player] : s_.players)
    if (player->unum == name.unum && player->side == name.side) return player.get();
  return nullptr;
}

Player* Trainer::playerOrSelected(const std::optional<PlayerName>& name) {
  if (name) return find(*name);
  for (auto& [id, player] : s_.players)
    if (player->selected) return player.get();
  return nullptr;
}

std::string Trainer::apply(const MoveAgentCommand& command) {
  if (!command.player) {
    s_.referee.clearSelected(s_.game, s_.world, s_.members);
    return {};
  }
  const Player* player = find(*command.player);
  if (!player) return noSuchPlayer;
  if (!command.position) return {};
  Pose3 pose = translation(*command.position);
  pose.linear() =
      command.heading ? rotationZ(*command.heading).linear() : s_.world.torso(player->robot).pose.linear();
  s_.world.moveRobot(player->robot, pose);
  return {};
}

std::string Trainer::apply(const BallCommand& command) {
  BodyState ball = s_.world.ball();
  if (command.position) ball.pose.translation() = *command.position;
  if (command.velocity) {
    ball.linearVelocity = *command.velocity;
    ball.angularVelocity.setZero();
  }
  s_.world.setBall(ball);
  return {};
}

std::string Trainer::apply(const PlayModeCommand& command) {
  s_.game.setMode(command.mode);
  return {};
}

std::string Trainer::apply(const KickOffCommand& command) {
  s_.referee.kickOff(s_.game, s_.world, command.side);
  return {};
}

std::string Trainer::apply(const DropBallCommand&) {
  s_.referee.dropBall(s_.game, s_.world);
  return {};
}

std::string Trainer::apply(const TimeCommand& command) {
  s_.game.time = command.time;
  return {};
}

std::string Trainer::apply(const ScoreCommand& command) {
  s_.game.score = {command.left, command.right};
  return {};
}

std::string Trainer::apply(const SelectCommand& command) {
  Player* next = nullptr;
  if (command.player) {
    next = find(*command.player);
    if (!next) return noSuchPlayer;
  } else if (!command.clear) {  // the one after the selected, the first after the last
    bool passed = false;
    for (auto& [id, player] : s_.players) {
      if (passed && !next) next = player.get();
      passed = passed || player->selected;
    }
    if (!next && !s_.players.empty()) next = s_.players.begin()->second.get();
  }
  for (auto& [id, player] : s_.players) player->selected = player.get() == next;
  return {};
}

std::string Trainer::apply(const KillCommand& command) {
  const Player* player = playerOrSelected(command.player);
  if (!player) return noSuchPlayer;
  s_.remove(player->id());
  return {};
}

std::string Trainer::apply(const RepositionCommand& command) {
  Player* player = playerOrSelected(command.player);
  if (!player) return noSuchPlayer;
  moveAside(*player);
  return {};
}

void Trainer::moveAside(Player& player) {
  Pose3 pose = s_.world.torso(player.robot).pose;
  pose.translation() = outsidePlace(s_.field, s_.world.ball().pose.translation(), player.side, player.unum);
  s_.world.moveRobot(player.robot, pose);
}

}  // namespace plumbline::simulation
