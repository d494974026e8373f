#include "simulation/referee/Conduct.h"

#include <cmath>

#include "simulation/referee/Areas.h"

namespace plumbline::simulation {

namespace {

constexpr double lying = 0.15, upright = 0.25;  ///< height of a torso [m]
constexpr double upFor = 0.5;                   ///< then it stands [s]
constexpr double sideMargin = 0.1;              ///< the side line: further out nobody has to stand [m]

void observePosture(const Match& match, Participant& player) {
  const Vec3 place = player.torso.pose.translation();
  const bool onField = std::fabs(place.y()) < match.field.width / 2 + sideMargin;
  if (place.z() < upright && onField) {
    ++player.notStanding;
    player.standing = 0;
  }
  if (place.z() < lying && onField) ++player.onGround;
  if (place.z() >= upright) {
    ++player.standing;
    player.onGround = 0;
  }
  if (player.standing > match.cycles(upFor)) player.notStanding = 0;
}

constexpr double farAway = 1000;  ///< [m]

/// Of those in the penalty area already; newcomers have to go anyway.
double goalDistance(const Match& match, const Participant& player) {
  if (!player.inOwnArea) return farAway;
  if (player.goalie()) return 0;
  if (!player.wasInOwnArea) return farAway;
  return (player.place() - Vec2(sign(player.side) * match.field.length / 2, 0)).norm();
}

/// Place in the order of distances within the team; offenders do not count; if equal, the higher number is
/// first.
template <typename Distance>
int rank(Match& match, const Participant& player, const Distance& distance) {
  int rank = 1;
  for (const Participant& other : match.participants())
    if (other.side == player.side && &other != &player && !other.offends() &&
        (distance(other) < distance(player) ||
         (distance(other) == distance(player) && other.unum > player.unum)))
      ++rank;
  return rank;
}

}  // namespace

void forgive(const Match& match, Participant& player) {
  player.onGround = player.notStanding = 0;
  player.standing = static_cast<int>(match.cycles(5));
  player.inOwnArea = player.wasInOwnArea = false;
  player.foul = Foul::Kind::none;
  player.foulCycles = 0;
  player.sinceBallTouch = player.sinceCollision = Participant::longAgo;
}

void observeConduct(Match& match) {
  match.memory.inOwnArea.fill(0);
  match.memory.movedInside.fill(0);
  const Vec2 ball = match.ball().position().head<2>();
  for (Participant& player : match.participants()) {
    player.ballDistance = (player.place() - ball).norm();
    player.wasInOwnArea = player.inOwnArea;
    player.inOwnArea = penaltyArea(match.field, player.side).contains(player.place()) && !player.offends();
    if (player.inOwnArea) ++match.memory.inOwnArea[Game::index(player.side)];
    observePosture(match, player);
    ++player.sinceBallTouch;
    ++player.sinceCollision;
    ++player.sinceMoved;
  }
  for (Participant& player : match.participants()) {
    player.ballRank = rank(match, player, [](const Participant& p) { return p.ballDistance; });
    if (player.inOwnArea)
      player.goalRank =
          rank(match, player, [&match](const Participant& p) { return goalDistance(match, p); });
  }
}

void observeBallTouches(Match& match) {
  for (const BallTouch& touch : match.ball().touching())
    if (Participant* player = match.find(touch.side, touch.unum)) player->sinceBallTouch = 0;
}

void observeVelocities(Match& match) {
  for (Participant& player : match.participants()) {
    player.velocities[2] = player.velocities[1];
    player.velocities[1] = player.velocities[0];
    player.velocities[0] = player.torso.linearVelocity;
  }
}

}  // namespace plumbline::simulation
