#pragma once
#include <memory>

#include "simulation/physics/Physics.h"

namespace plumbline::simulation::bullet {

/// Bullet (double precision): robots in reduced coordinates (btMultiBody), so hinges are rigid; contacts from
/// Bullet's collision detection; one exact solution per step and island. A second engine to compare with the
/// league's ODE.
std::unique_ptr<Physics> makeBulletPhysics(const PhysicsConfig& config);

}  // namespace plumbline::simulation::bullet
