#pragma once
#include "math/Types.h"
#include "robot/LegKinematics.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// Limits of a step by the robot's body; the swing foot in the frame of the centre of mass when it lands.
struct StepLimits {
  double forward = 0.1, backward = 0.08;  ///< before and behind [m]
  double minOutward = 0.045;              ///< the feet do not cross: half of their smallest distance [m]
  double maxOutward = 0.14;               ///< [m]
  double hipY = 0.055, reach = 0.2;       ///< foot at most this far from the point under the hip [m]
  double minDuration = 0.12, maxDuration = 0.3;  ///< of a whole step [s]
  double maxTurnRate = 2.5;                      ///< of the torso over the supporting foot [rad/s]
  double restX = 0;                  ///< centre of mass before the soles' centres when standing [m]
  double calmRate = 6;               ///< of its way to there, on both feet [1/s]
  double calmTime = 0.15;            ///< in which it takes up that velocity [s]
  Vec2 pressure = Vec2(0.05, 0.02);  ///< centre of pressure at most this far from a sole's centre [m]
};

/// The limits that a walk's parameters and a leg's length set.
StepLimits stepLimits(const WalkParameters& p, const LegKinematics& leg);

}  // namespace plumbline::walking
