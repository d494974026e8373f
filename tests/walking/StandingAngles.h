#pragma once
#include "walking/engine/BodyPosture.h"

namespace plumbline::walking {

/// Joint angles [rad] of a robot that stands upright on two feet 0.11 m apart, its hips at this height [m].
inline JointArray standingAngles(const RobotModel& robot, double hipHeight) {
  std::array<FootPlacement, 2> feet;
  feet[0].ground = Pose2(0, 0.055);
  feet[1].ground = Pose2(0, -0.055);
  BodyPosture posture(robot);
  JointArray angles{};
  for (int i = 0; i < 5; ++i) posture.solve(feet, {.hipHeight = hipHeight}, angles);
  return angles;
}

}  // namespace plumbline::walking
