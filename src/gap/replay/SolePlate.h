#pragma once
#include <array>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Corners of a sole's underside (link frame) [m].
std::array<Vec3, 4> soleCorners(const Mechanism::Foot& foot);

/// Readings of a foot's force sensors for a force [N] at a point of the sole (link frame) [m]. The sole is a
/// rigid plate on equal springs that push and never pull. So the readings are a linear function of the
/// sensors' places where that is above 0, and their sum is the force. Outside the sensors' outline the
/// nearest of them carry everything.
std::vector<double> plateForces(const Mechanism::Foot& foot, double normal, const Vec2& centre);

}  // namespace plumbline::gap
