#pragma once
#include "math/Angle.h"
#include "robot/JointId.h"

namespace plumbline::test {

/// The left lower arm through the torso: the elbow bent inwards; all else straight [rad].
inline JointArray armIntoTorso() {
  JointArray angles{};
  angles[lShoulderRoll] = fromDegrees(-1);
  angles[lShoulderPitch] = fromDegrees(70);
  angles[lElbowYaw] = fromDegrees(40);
  angles[lElbowRoll] = fromDegrees(-60);
  return angles;
}

}  // namespace plumbline::test
