#pragma once
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::simulation {

/// A sole's force along its normal [N], shared by the foot's sensors as a plane over them with the same
/// centre of pressure would (in the link's frame); no sensor pulls, and together they carry all.
std::vector<double> footSensorForces(const Mechanism::Foot& foot, double normal, const Vec2& centre);

}  // namespace plumbline::simulation
