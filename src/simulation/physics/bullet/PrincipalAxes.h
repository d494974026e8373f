#pragma once
#include "math/Types.h"

namespace plumbline::simulation::bullet {

/// Right-handed axes in which an inertia is diagonal, as Bullet wants it; the given ones, if they do.
Mat3 principalAxesOf(const Mat3& inertia);

}  // namespace plumbline::simulation::bullet
