#pragma once
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::servo {

/// Distributes a sole's normal force [N] over the foot's sensors. The readings are a linear function of the
/// sensors' places with the same centre of pressure (in the link's frame). No reading is negative, and their
/// sum is the force.
std::vector<double> footSensorForces(const Mechanism::Foot& foot, double normal, const Vec2& centre);

}  // namespace plumbline::servo
