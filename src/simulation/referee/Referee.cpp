#include "simulation/referee/Referee.h"

#include <algorithm>
#include <cmath>

#include "simulation/Field.h"

namespace plumbline::simulation {

using simspark::opponent;

namespace {

constexpr double penaltyDepth = 1.8, penaltyHalfWidth = 3;
constexpr double goalKickDistance = 1;  ///< of the ball from the goal line [m]
constexpr double touchDelay = 0.03;     ///< a touch counts so long after the pause [s]

/// A mode of the left team, or its twin of the right one, which follows it in the list.
PlayMode forSide(PlayMode left, TeamSide side) {
  return static_cast<PlayMode>(static_cast<int>(left) + (side == TeamSide::right ? 1 : 0));
}

TeamSide sideOf(PlayMode mode, PlayMode left) { return mode == left ? TeamSide::left : TeamSide::right; }

bool inPenaltyArea(const Vec3& p, TeamSide side) {
  const double depth = fieldLength / 2 - (side == TeamSide::left ? -p.x() : p.x());
  return depth >= 0 && depth <= penaltyDepth && std::fabs(p.y()) <= penaltyHalfWidth;
}

}  // namespace

void Referee::update(Game& game, World& world, const Observation& observation, double seconds) {
  game.advance(seconds);
  ball.update(world.ball().pose.translation());
  if (observation.touch) {
    BallWatch::Touch touch = *observation.touch;
    touch.time = game.time;
    ball.touched(touch);
  }
  checkTime(game);
  switch (game.mode) {
    case PlayMode::beforeKickOff:
      return beforeKickOff(game, world, observation);
    case PlayMode::kickOffLeft:
    case PlayMode::kickOffRight:
      return kickingOff(game, world);
    case PlayMode::goalLeft:
    case PlayMode::goalRight:
      return goalPause(game, world);
    case PlayMode::playOn:
    case PlayMode::passLeft:
    case PlayMode::passRight:
      return playOn(game, world);
    case PlayMode::gameOver:
      return;
    default:
      return deadBall(game, world);
  }
}

void Referee::checkTime(Game& game) {
  if (game.half == 1 && game.time >= rules.halfTime) {
    game.setMode(PlayMode::beforeKickOff);
    game.half = 2;
  } else if (game.half == 2 && game.time >= 2 * rules.halfTime) {
    game.setMode(PlayMode::gameOver);
  }
}

void Referee::kickOff(Game& game, TeamSide side) {
  if (side == TeamSide::none) {
    side = random.uniform(0, 1) <= 0.5 ? TeamSide::left : TeamSide::right;
    if (game.half != lastKickOffHalf) {
      if (nextHalfKickOff != TeamSide::none) side = nextHalfKickOff;
      nextHalfKickOff = opponent(side);
    }
  }
  game.setMode(forSide(PlayMode::kickOffLeft, side));
  lastKickOffHalf = game.half;
}

void Referee::beforeKickOff(Game& game, World& world, const Observation& observation) {
  if (!observation.playersPresent) return;
  placeBall(world, Vec3(0, 0, ballRadius));
  if (rules.kickOffAfter && game.modeTime() >= *rules.kickOffAfter) kickOff(game, TeamSide::none);
}

void Referee::kickingOff(Game& game, World& world) {
  if (rules.dropBall > 0 && game.modeTime() > rules.dropBall) return drop(game, world, ball.position());
  if (ball.lastTouch().side != TeamSide::none && ball.lastTouch().time > game.lastModeChange)
    game.setMode(PlayMode::playOn);
}

void Referee::playOn(Game& game, World& world) {
  if (const TeamSide goal = ball.inGoalOf(); goal != TeamSide::none) {
    const TeamSide scorer = opponent(goal);
    ++game.score[Game::index(scorer)];
    game.setMode(forSide(PlayMode::goalLeft, scorer));
  } else if (!ball.onField()) {
    ballLeftField(game, world);
  } else {
    kickPosition = ball.lastOnField();
    kickPosition.z() = ballRadius;
  }
}

void Referee::ballLeftField(Game& game, World&) {
  const TeamSide toucher = ball.lastTouch().side;
  if (toucher == TeamSide::none) return;  // nobody's fault: the league's server leaves it where it is
  const Vec3& out = ball.position();
  if (std::fabs(out.x()) >= fieldLength / 2) {
    const TeamSide end = out.x() < 0 ? TeamSide::left : TeamSide::right;
    const double sign = out.x() < 0 ? -1 : 1;
    if (toucher != end) {
      award(game, PlayMode::goalKickLeft, end,
            Vec3(sign * (fieldLength / 2 - goalKickDistance), 0, ballRadius));
    } else {
      const double y = (fieldWidth + goalWidth) / 4 - ballRadius;
      award(game, PlayMode::cornerKickLeft, opponent(end),
            Vec3(sign * (fieldLength / 2 - ballRadius), out.y() > 0 ? y : -y, ballRadius));
    }
  } else {
    const double y = fieldWidth / 2 - ballRadius;
    award(game, PlayMode::kickInLeft, opponent(toucher),
          Vec3(ball.lastOnField().x(), ball.lastOnField().y() > 0 ? y : -y, ballRadius));
  }
}

void Referee::award(Game& game, PlayMode left, TeamSide side, const Vec3& position) {
  kickPosition = position;
  kickTaken = false;
  game.setMode(forSide(left, side));
}

/// Kick-in, corner, goal and free kicks: after a pause the ball lies at its place until a player touches it.
void Referee::deadBall(Game& game, World& world) {
  if (game.modeTime() < rules.kickInPause) {
    kickTaken = false;
    return;
  }
  if (rules.dropBall > 0 && game.modeTime() > rules.dropBall) return drop(game, world, kickPosition);
  kickTaken = kickTaken || (ball.lastTouch().side != TeamSide::none &&
                            ball.lastTouch().time > game.lastModeChange + rules.kickInPause + touchDelay);
  if (!kickTaken) return placeBall(world, kickPosition);
  const bool goalKick = game.mode == PlayMode::goalKickLeft || game.mode == PlayMode::goalKickRight;
  if (!goalKick || !inPenaltyArea(ball.position(), sideOf(game.mode, PlayMode::goalKickLeft)))
    game.setMode(PlayMode::playOn);
}

void Referee::goalPause(Game& game, World& world) {
  if (game.modeTime() < rules.goalPause) return;
  placeBall(world, Vec3(0, 0, ballRadius));
  const TeamSide scorer = sideOf(game.mode, PlayMode::goalLeft);
  game.setMode(forSide(PlayMode::kickOffLeft, opponent(scorer)));
  lastKickOffHalf = game.half;
}

void Referee::dropBall(Game& game, World& world) { drop(game, world, world.ball().pose.translation()); }

void Referee::drop(Game& game, World& world, Vec3 position) {
  for (const TeamSide side : {TeamSide::left, TeamSide::right})
    if (inPenaltyArea(position, side)) {
      position.x() = (side == TeamSide::left ? -1 : 1) * (fieldLength / 2 - penaltyDepth);
      position.y() = position.y() < 0 ? -penaltyHalfWidth : penaltyHalfWidth;
    }
  const double limit = fieldWidth / 2 - ballRadius;
  position.y() = std::clamp(position.y(), -limit, limit);
  placeBall(world, position);
  game.setMode(PlayMode::playOn);
}

void Referee::placeBall(World& world, const Vec3& position) {
  world.setBall(position, Vec3::Zero());
  kickPosition = Vec3(position.x(), position.y(), ballRadius);
}

}  // namespace plumbline::simulation
