#pragma once
#include <memory>

#include "simulation/world/World.h"

namespace plumbline::simulation {

/// The league's soccer world on the physics engine and with the effects that the configuration names. Errors:
/// std::invalid_argument for an unknown engine (names those there are), ConfigurationError for effects that
/// robots here cannot have.
std::unique_ptr<World> makeWorld(const WorldConfig& config = {});

}  // namespace plumbline::simulation
