#pragma once
#include <string>

#include "gap/inference/PerJointFit.h"

namespace plumbline::gap {

/// Whether causes can differ from joint to joint: the robot has several motors, and one of them sits at
/// joints.
bool differsByJoint(const Mechanism& robot, const Explanation& causes);

/// The causes, with a value in every joint of each kind that sits at joints, fitted to the positions
/// (fitPerJoint, doc/decisions/0017). A search can afford one value for all joints, or one in the joint that
/// shows most; the other joints have it too. Values begin at those given; those that do nothing are left out.
/// The causes themselves where none can differ.
Explanation withJointValues(const Replayer& replayer, const Explanation& causes);

/// A line per kind: "  coulomb_friction in 6 joints: 0.05 to 0.21 N m".
std::string jointValuesText(const Explanation& model);

}  // namespace plumbline::gap
