#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Charging: running into an opponent. If two standing opponents touch, one charges if it moves at 0.4 m/s or
/// more, and at 0.2 m/s or more towards the collision. Near the ball (1 m) it must also move more towards the
/// opponent than the ball (30 degrees off), or come second to the ball from another direction. There is no
/// charge if both do it, at the ball itself, or by a goalie in its own area. Nor is there one within a second
/// of touching the ball, or within 0.2 s of a harmless collision. Speeds are means of three cycles.
/// (AnalyseChargingFouls)
class Charging : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, true, "", {}, "whether it is a foul")
    PARAMETER(double, minSpeed, 0.4, "m/s", Range::atLeast(0), "of a player who charges")
    PARAMETER(double, minBallAngle, 0.5235987755982988, "rad", Range::atLeast(0),
              "of its speed from the ball: 30 degrees")
    PARAMETER(double, minDistanceDifference, 0.05, "m", Range::atLeast(0),
              "from the ball, of the two players")
    PARAMETER(double, minAngleDifference, 0.2617993877991494, "rad", Range::atLeast(0),
              "of their ways from each other: 15 degrees")
    PARAMETER(double, immunity, 1, "s", Range::atLeast(0), "after a touch of the ball")
    PARAMETER(double, minInterval, 0.2, "s", Range::atLeast(0), "between two collisions that are judged")
    PARAMETER(double, maxBallDistance, 1, "m", Range::atLeast(0),
              "of one of the two, for their way to the ball to matter")
    PARAMETER(double, minCollisionBallDistance, 0.1, "m", Range::atLeast(0),
              "collisions nearer to the ball are none")
    PARAMETER(double, minCollisionSpeed, 0.2, "m/s", Range::atLeast(0), "towards the collision")
  };
  void judgeAll(Match& match) override;
};

}  // namespace plumbline::simulation
