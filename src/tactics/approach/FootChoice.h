#pragma once
#include "parameters/Parameter.h"
#include "robot/JointId.h"

namespace plumbline {

struct FootChoiceParameters {
  PARAMETERS(FootChoiceParameters)
  PARAMETER(double, hysteresis, 0.03, "m", Range(0, 1),
            "the robot has to be this far on the other side of the ball's way before the foot changes")
};

/// The foot that plays the ball. side: how far the robot is to the left of the way that the ball is to take
/// [m]; there the ball is in front of its right foot. before: the foot until now.
inline Side footFor(double side, Side before, const FootChoiceParameters& p) {
  if (side > p.hysteresis) return Side::right;
  return side < -p.hysteresis ? Side::left : before;
}

}  // namespace plumbline
