#pragma once
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline {

/// Inertia at each joint's motor at positions q, including its own, with the other joints still [kg m^2].
std::vector<double> feltInertias(const Mechanism& robot, const std::vector<double>& q);

}  // namespace plumbline
