#pragma once
#include "simulation/referee/Areas.h"
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

// Where the referee puts players (rcssserver3d soccerruleaspect.cpp: GetSafeReposition, ClearPlayers,
// RepelPlayers, RepositionOutsidePos).

/// Moves a player to the place [m], or to one near it where it would stand in nobody's way. That is not
/// within the agent's radius (0.4) of another robot's bounding box, not in a goal, and not in its own full
/// penalty area. With avoidBall it is a metre from the ball, too. Tried are places in steps of the radius,
/// away from where it is, nearest first; after `attempts` of them the first one is taken.
void moveSafely(Match& match, Participant& player, const Vec3& place, bool avoidBall = true);

/// Place next to the field on the side away from the ball: number n at 0.6 (7 - n) m from midfield, in the
/// own half for n < 7. It is half a metre beyond the line and one metre high.
Vec3 outsidePlace(const FieldSize& field, const Vec3& ball, TeamSide side, int unum);

/// Moves players of a side whose bounding box reaches into a sphere of that radius around the centre to
/// `distance` from it. They move towards their own goal, or towards midfield if that place is behind the goal
/// line.
void clearCircle(Match& match, const Vec3& centre, double radius, double distance, TeamSide side);
/// Players of a side of whom something is in the area are put `distance` before it, towards their own goal.
void clearArea(Match& match, const Area& area, double distance, TeamSide side);
/// Players of a side nearer than the radius are put there, straight away from the centre, `further` than it.
void repel(Match& match, const Vec3& centre, double radius, TeamSide side, double further,
           bool avoidBall = true);
/// As clearCircle, by the distance of restarts, for those a trainer selected, from where they are.
void clearSelected(Match& match);

}  // namespace plumbline::simulation
