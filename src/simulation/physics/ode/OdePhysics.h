#pragma once
#include <memory>

#include "simulation/physics/Physics.h"

namespace plumbline::simulation::ode {

/// Who solves a step's equations: trees of hinges in linear time, or ODE's own dense solver. Both exactly.
enum class Solver { tree, dense };

/// The Open Dynamics Engine (double precision): rigid bodies, one exact solution per step and island, as on
/// the league's server.
std::unique_ptr<Physics> makeOdePhysics(const PhysicsConfig& config, Solver solver);

}  // namespace plumbline::simulation::ode
