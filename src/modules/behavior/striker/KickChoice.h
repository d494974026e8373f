#pragma once
#include <vector>

#include "math/Pose2.h"
#include "parameters/Parameter.h"
#include "representations/modeling/OtherRobots.h"

namespace plumbline {

struct KickChoiceParameters {
  PARAMETERS(KickChoiceParameters)
  PARAMETER(int, directions, 15, "", Range(3, 101), "directions that are compared")
  PARAMETER(double, widest, 1.4, "rad", Range(0.1, 3.1), "the outermost ones, off the direction of the goal")
  PARAMETER(double, turnCost, 0.5, "m/rad", Range(0, 10),
            "way that a kick must gain for the robot to go further round the ball")
  PARAMETER(double, pressedTurnCost, 1.5, "m/rad", Range(0, 10), "the same with an opponent near to the ball")
  PARAMETER(double, pressedDistance, 1.2, "m", Range(0, 10), "an opponent this near to the ball presses")
  PARAMETER(double, blockWidth, 0.4, "m", Range(0, 3), "robots this near to the ball's way stop it")
  PARAMETER(double, blockCost, 2, "m", Range(0, 30), "of a way that an opponent blocks")
  PARAMETER(
      double, mateGain, 0.5, "", Range(0, 5),
      "gain per metre that the nearest mate is nearer than the nearest opponent to where the ball rests")
  PARAMETER(double, mostMateGain, 1, "m", Range(0, 10), "no more than this is gained or lost so")
  PARAMETER(double, stays, 0.3, "m", Range(0, 10), "gain of the direction that was chosen last")
};

/// What the striker knows; team's frame [m, rad].
struct KickSituation {
  Pose2 robot;
  Vec2 ball = Vec2::Zero();
  double toGoal = 0;      ///< direction in which to shoot
  double reach = 3;       ///< how far a kick carries [m]
  double halfWidth = 10;  ///< of the field: beyond it the ball is lost
  std::vector<OtherRobot> others;
};

/// The direction of the kick that gains most way towards the goal against what it costs: going round the
/// ball, opponents on the way, opponents nearer than mates to where it rests. last: the choice before, if
/// there was one within widest, else any number far off.
double chooseKick(const KickSituation& situation, double last, const KickChoiceParameters& parameters);

/// Distance of the nearest opponent that stands from a place, a large number without any [m].
double nearestOpponent(const std::vector<OtherRobot>& others, const Vec2& place);

}  // namespace plumbline
