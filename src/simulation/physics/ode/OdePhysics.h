#pragma once
#include <memory>

#include "simulation/physics/Physics.h"

namespace plumbline::simulation::ode {

/// The Open Dynamics Engine (double precision): rigid bodies, one exact LCP per step and island (dWorldStep),
/// as on the league's server.
std::unique_ptr<Physics> makeOdePhysics(const PhysicsConfig& config);

}  // namespace plumbline::simulation::ode
