#pragma once
#include "robot/JointId.h"

namespace plumbline {

/// The joints of the body, as a walk or a motion moves them, are those from here to maxJoints: arms, legs and
/// the robot's own joints. The two before are the head's, which looks around meanwhile.
constexpr JointId firstBodyJoint = lShoulderPitch;
static_assert(firstBodyJoint == headPitch + 1);

}  // namespace plumbline
