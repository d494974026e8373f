#pragma once
#include "math/Pose2.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// Speed limits and gains of walking to a pose. Speeds in m/s and rad/s, gains in 1/s.
struct WalkToPoseParameters {
  PARAMETERS(WalkToPoseParameters)
  PARAMETER(double, maxForward, 0.5, "m/s", Range(0.01, 3), "fastest walk forward")
  PARAMETER(double, maxBackward, 0.25, "m/s", Range(0.01, 3), "fastest walk backward")
  PARAMETER(double, maxSideways, 0.2, "m/s", Range(0.01, 3), "fastest walk sideways")
  PARAMETER(double, maxTurn, 1.2, "rad/s", Range(0.01, 6), "fastest turn")
  PARAMETER(double, positionGain, 2, "1/s", Range(0.01, 20), "speed per metre to go")
  PARAMETER(double, headingGain, 2, "1/s", Range(0.01, 20), "turn per radian to go")
  PARAMETER(double, nearDistance, 0.5, "m", Range(0, 5),
            "closer than this the robot keeps its final heading and walks in any direction")
  PARAMETER(double, turnFirst, 0.8, "rad", Range(0.1, 3.2),
            "a target farther off than this angle is turned to before walking")
  PARAMETER(double, sprintBearing, 0, "rad", Range(0, 1),
            "if the target is closer than this to straight ahead, the robot sprints; otherwise it walks "
            "slowly and turns, because a sprint hardly turns; 0: turns and walks at the same time")
  PARAMETER(double, sprintHold, 0, "rad", Range(0, 1),
            "a sprint continues until the target is farther from straight ahead than this, because braking "
            "and starting again takes seconds; 0: as sprintBearing")
  PARAMETER(double, sprintPassDistance, 0, "m", Range(0, 3),
            "or if the sprint passes the target within this distance: near the target a sprint continues")
  PARAMETER(
      double, sprintDistance, 1.5, "m", Range(0, 30),
      "no sprint to nearer targets: the path is too short to gain the time of the turn before it, or to stop")
  PARAMETER(double, sprintTurn, 0.1, "rad/s", Range(0, 3),
            "fastest turn that is asked for in a sprint; the walk turns less (its sprint.lateralShare)")
  PARAMETER(double, sprintGain, 1, "1/s", Range(0, 40), "turn per radian to go in a sprint")
  PARAMETER(double, curveSpeed, 0.4, "m/s", Range(0.01, 3),
            "fastest walk forward while it turns to the target")
  PARAMETER(
      double, alignSpeed, 3, "m/s", Range(0, 3),
      "fastest walk forward while it turns to a target far enough for a sprint, because a fast walk hardly "
      "turns; never more than curveSpeed")
  PARAMETER(
      double, alignGain, 0, "1/s", Range(0, 40),
      "turn per radian to go, in place of headingGain, before a sprint to a target far enough for one; 0: "
      "headingGain")
  PARAMETER(double, turnEffort, 0.8, "", Range(0, 1), "share of that speed which the fastest turn takes away")
  PARAMETER(double, turnWalking, 0, "", Range(0, 3),
            "with this share of that speed it walks to the target while it still turns to it, whatever "
            "direction that is of its body; 0: forward only, and only within turnFirst")
};

/// A walk request in the robot's frame [m/s, rad/s].
struct WalkCommand {
  Vec2 velocity = Vec2::Zero();
  double turn = 0;
  bool sprint = false;  ///< input of walkToPose in the next cycle
};

/// The walk that brings the robot to a pose given in its own frame: far away it faces the way it goes, near
/// the target it takes the final heading. Speeds never exceed the limits (an ellipse for forward and
/// sideways). sprinting: whether the command before was a sprint.
WalkCommand walkToPose(const Pose2& T_robot_target, const WalkToPoseParameters& parameters,
                       bool sprinting = false);

/// The walk towards a way point in the robot's frame, at full speed, because the way goes on behind it.
WalkCommand walkPast(const Vec2& wayPoint, const WalkToPoseParameters& parameters, bool sprinting = false);

/// Scales a velocity back onto the ellipse of the limits, keeping its direction.
Vec2 limitVelocity(const Vec2& velocity, const WalkToPoseParameters& parameters);

}  // namespace plumbline
