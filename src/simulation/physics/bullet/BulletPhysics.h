#pragma once
#include <memory>

#include "simulation/physics/Physics.h"

namespace plumbline::simulation::bullet {

/// Bullet (double precision): robots in reduced coordinates (btMultiBody), so hinges cannot gape; contacts as
/// Bullet's collision detection finds them; one exact solution per step and island. A second opinion beside
/// the league's ODE.
std::unique_ptr<Physics> makeBulletPhysics(const PhysicsConfig& config);

}  // namespace plumbline::simulation::bullet
