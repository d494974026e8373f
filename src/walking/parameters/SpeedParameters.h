#pragma once
#include "parameters/Parameter.h"

namespace plumbline::walking {

/// Limits of the speed. Up to omniForward .. any mixture of directions may be asked for; up to maxForward ..
/// one direction alone (SprintParameters).
struct SpeedParameters {
  PARAMETERS(SpeedParameters)
  PARAMETER(double, maxForward, 0.5, "m/s", Range(0.01, 3), "fastest walk straight forward")
  PARAMETER(double, maxBackward, 0.4, "m/s", Range(0.01, 3), "fastest walk straight backward")
  PARAMETER(double, maxSideways, 0.25, "m/s", Range(0.01, 2), "fastest walk straight sideways")
  PARAMETER(double, maxTurn, 1.6, "rad/s", Range(0.01, 10), "fastest turn on the spot")
  PARAMETER(double, omniForward, 0, "m/s", Range(0, 3),
            "omnidirectional limit forward, 0: up to the fastest walk")
  PARAMETER(double, omniBackward, 0, "m/s", Range(0, 3),
            "omnidirectional limit backward, 0: up to the fastest walk")
  PARAMETER(double, omniSideways, 0, "m/s", Range(0, 2),
            "omnidirectional limit sideways, 0: up to the fastest walk")
  PARAMETER(double, omniTurn, 0, "rad/s", Range(0, 10),
            "omnidirectional limit of the turn, 0: up to the fastest turn")
  PARAMETER(double, accelerationForward, 0.5, "m/s^2", Range(0.01, 100), "of the requested velocity",
            "blends")
  PARAMETER(double, decelerationForward, 0.5, "m/s^2", Range(0.01, 100),
            "of the requested velocity when it becomes smaller", "blends")
  PARAMETER(double, accelerationSideways, 0.5, "m/s^2", Range(0.01, 100), "of the requested velocity",
            "blends")
  PARAMETER(double, accelerationTurn, 6, "rad/s^2", Range(0.01, 1000), "of the requested turn rate", "blends")
  PARAMETER(double, trimForward, 0, "m/s", Range(-0.3, 0.3),
            "planned speed with which the robot stays on the spot", "blends")
  PARAMETER(double, brakeLead, 0, "s", Range(-0.5, 0.5),
            "time by which the planned speed is ahead while the robot brakes", "blends")
  PARAMETER(double, scaleWindow, 0, "s", Range(0, 1000),
            "walking time over which it is learnt how much faster than planned the robot walks, 0: it is not",
            "feedback")
};

/// The way to the full speed in one direction and back.
struct SprintParameters {
  PARAMETERS(SprintParameters)
  PARAMETER(double, patience, 0.3, "s", Range(0, 10), "time for which a sprint must be requested")
  PARAMETER(double, lateralShare, 0.23, "", Range(0, 0.35),
            "share of the omnidirectional limits that is allowed in other directions during a sprint")
  PARAMETER(double, riseTime, 0, "s", Range(0, 10),
            "from the omnidirectional limit to full speed, 0: with the usual acceleration")
  PARAMETER(double, fallTime, 0, "s", Range(0, 10),
            "from full speed to the omnidirectional limit, 0: with the usual acceleration")
  PARAMETER(double, settleTime, 0, "s", Range(0, 2), "the robot goes straight on for so long after a sprint")
};

struct StartStopParameters {
  PARAMETERS(StartStopParameters)
  PARAMETER(double, duration, 0.14, "s", Range(0.04, 1), "shift of the weight before the first step")
  PARAMETER(double, speed, 0, "m/s", Range(0, 0.3),
            "speed forward or backward of the first step, if the request is at least this")
  PARAMETER(double, stopVelocity, 0.05, "m/s", Range(0.001, 0.5),
            "both feet carry again only below this forward velocity")
  PARAMETER(
      double, turn, 2, "rad/s", Range(0, 6),
      "until then, but for 0.5 s at most, a robot that is to stop still turns as requested, at most so fast")
  PARAMETER(double, calmRate, 6, "1/s", Range(0.5, 50),
            "on both feet the mass is to move to the middle with this velocity per metre")
  PARAMETER(double, calmTime, 0.15, "s", Range(0.02, 1), "and to have this velocity so soon")
};

}  // namespace plumbline::walking
