#pragma once
#include <array>

#include "math/Types.h"
#include "robot/JointId.h"

namespace plumbline::walking {

/// What the walk is told every cycle.
struct WalkSensors {
  JointArray angles{};                ///< measured [rad]
  Vec2 torsoAngles = Vec2::Zero();    ///< torso against gravity: roll (about x) and pitch (about y) [rad]
  Vec3 gyro = Vec3::Zero();           ///< torso frame [rad/s]
  std::array<double, 2> footForce{};  ///< vertical force on the left and right sole [N]
  double dt = 0.02;                   ///< of one cycle [s]
};

}  // namespace plumbline::walking
