#pragma once
#include <array>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Corners of a sole's underside (link frame) [m].
std::array<Vec3, 4> soleCorners(const Mechanism::Foot& foot);

/// What a foot's force sensors show of a force [N] that presses at a place of the sole (link frame) [m]. The
/// sole is a rigid plate on equal springs that push and never pull. So the forces are a plane over the
/// sensors' places where that is above 0, and add up to the whole. Beyond the sensors' outline the nearest of
/// them carry all.
std::vector<double> plateForces(const Mechanism::Foot& foot, double normal, const Vec2& centre);

}  // namespace plumbline::gap
