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

Player::Player(PlayerId id, int type, const PlayerConfig& config_, std::uint64_t seed)
    : id_(id),
      type_(type),
      config(config_),
      model_(simsparkRobot(type)),
      random(seed, static_cast<std::uint64_t>(id)),
      vision(config.vision, random) {
  for (std::size_t i = 0; i < partLinks.size(); ++i) parts[i] = model_.linkIndex(partLinks[i].second);
}

void Player::drive(World& world, const std::array<std::optional<double>, numHumanoidJoints>& velocity) const {
  for (std::size_t i = 0; i < numHumanoidJoints; ++i)
    if (const auto joint = static_cast<JointId>(i); velocity[i] && model_.has(joint))
      world.setJointVelocity(robot, joint, frozen[i] ? 0 : *velocity[i]);
}

Pose2 Player::disturbed(const Pose2& place) {
  const double x = place.x() + config.beamNoise * random.uniform(-1, 1);
  const double y = place.y() + config.beamNoise * random.uniform(-1, 1);
  return Pose2(x, y, place.heading + config.beamTurnNoise * random.uniform(-1, 1));
}

VisibleWorld::Player Player::visibleParts(const World& world, std::string_view team) const {
  VisibleWorld::Player seen{team, unum, {}};
  for (std::size_t i = 0; i < parts.size(); ++i)
    seen.parts.push_back({partLinks[i].first, world.linkState(robot, parts[i]).pose.translation()});
  return seen;
}

void Player::sense(const World& world, const Game& game, double time, const VisibleWorld& visible,
                   const simspark::GroundTruth* truth) {
  // As on the league's server: the first cycle of a robot makes no message, the second one with an image.
  if (++cycle == 1) return;
  const RobotReadings& readings = world.readings(robot);
  senses = simspark::ServerMessage();
  senses.time = time;
  senses.gameState.scoreLeft = game.score[0];
  senses.gameState.scoreRight = game.score[1];
  senses.gameState.time = game.time;
  senses.gameState.playMode = simspark::playModeName(game.mode);
  if (side != TeamSide::none && !toldPlace) {
    toldPlace = true;
    senses.gameState.unum = unum;
    senses.gameState.side = simspark::sideName(side);
  }
  senses.heard = hearing.collect(game.teams[Game::index(side)], game.time);
  senses.gyro = readings.gyro;
  senses.acc = readings.acc;
  for (std::size_t i = 0; i < numHumanoidJoints; ++i)
    if (model_.has(static_cast<JointId>(i))) senses.angle[i] = readings.angle[i];
  senses.leftFoot = reading(readings.leftFoot);
  senses.rightFoot = reading(readings.rightFoot);
  senses.leftToe = reading(readings.leftToe);
  senses.rightToe = reading(readings.rightToe);
  if ((cycle + 1) % config.visionInterval == 0)
    senses.see = vision.see(world.linkState(robot, parts[0]).pose, visible);
  if (truth) {
    senses.groundTruth = *truth;
    senses.groundTruth->T_world_torso = world.torso(robot).pose;
  }
  text.clear();
  simspark::appendServerMessage(text, senses, config.groundTruthDecimals);
}

}  // namespace plumbline::simulation
