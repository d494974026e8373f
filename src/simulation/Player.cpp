#include "simulation/Player.h"

#include "simspark/LeagueRobots.h"
#include "simspark/ServerMessageWriter.h"

namespace plumbline::simulation {

namespace {
std::optional<simspark::ForceReading> reading(const std::optional<FootForce>& force) {
  if (!force) return std::nullopt;
  return simspark::ForceReading{force->point, force->force};
}
}  // namespace

Player::Player(PlayerId id, int type, const PlayerConfig& config, std::uint64_t seed)
    : id_(id),
      type_(type),
      config_(config),
      model_(simsparkRobot(type)),
      random_(seed, static_cast<std::uint64_t>(id)),
      vision_(config_.vision, random_) {
  for (std::size_t i = 0; i < partLinks.size(); ++i) parts_[i] = model_.linkIndex(partLinks[i].second);
}

void Player::drive(World& world, const std::array<std::optional<double>, numHumanoidJoints>& velocity) const {
  for (std::size_t i = 0; i < numHumanoidJoints; ++i)
    if (const auto joint = static_cast<JointId>(i); velocity[i] && model_.has(joint))
      world.setJointVelocity(robot, joint, frozen[i] ? 0 : *velocity[i]);
}

Pose2 Player::disturbed(const Pose2& place) {
  const double x = place.x() + config_.beamNoise * random_.uniform(-1, 1);
  const double y = place.y() + config_.beamNoise * random_.uniform(-1, 1);
  return Pose2(x, y, place.heading + config_.beamTurnNoise * random_.uniform(-1, 1));
}

VisibleWorld::Player Player::visibleParts(const World& world, std::string_view team) const {
  VisibleWorld::Player seen{team, unum, {}};
  for (std::size_t i = 0; i < parts_.size(); ++i)
    seen.parts.push_back({partLinks[i].first, world.linkState(robot, parts_[i]).pose.translation()});
  return seen;
}

void Player::sense(const World& world, const Game& game, double time, const VisibleWorld& visible,
                   const simspark::GroundTruth* truth) {
  // As on the league's server: the first cycle of a robot makes no message, the second one with an image.
  if (++cycle_ == 1) return;
  const RobotReadings& readings = world.readings(robot);
  senses_ = simspark::ServerMessage();
  senses_.time = time;
  senses_.gameState.scoreLeft = game.score[0];
  senses_.gameState.scoreRight = game.score[1];
  senses_.gameState.time = game.time;
  senses_.gameState.playMode = simspark::playModeName(game.mode);
  if (side != TeamSide::none && !placeReported_) {
    placeReported_ = true;
    senses_.gameState.unum = unum;
    senses_.gameState.side = simspark::sideName(side);
  }
  senses_.heard = hearing.collect(game.teams[Game::index(side)], game.time);
  senses_.gyro = readings.gyro;
  senses_.acc = readings.acc;
  for (std::size_t i = 0; i < numHumanoidJoints; ++i)
    if (model_.has(static_cast<JointId>(i))) senses_.angle[i] = readings.angle[i];
  senses_.leftFoot = reading(readings.leftFoot);
  senses_.rightFoot = reading(readings.rightFoot);
  senses_.leftToe = reading(readings.leftToe);
  senses_.rightToe = reading(readings.rightToe);
  if ((cycle_ + 1) % static_cast<std::uint64_t>(config_.visionInterval) == 0)
    senses_.see = vision_.see(world.linkState(robot, parts_[0]).pose, visible);
  if (truth) {
    senses_.groundTruth = *truth;
    senses_.groundTruth->T_world_torso = world.torso(robot).pose;
  }
  text_.clear();
  simspark::appendServerMessage(text_, senses_, config_.groundTruthDecimals);
}

}  // namespace plumbline::simulation
