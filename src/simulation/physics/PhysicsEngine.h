#pragma once
#include <memory>

#include "simulation/physics/Physics.h"

namespace plumbline::simulation {

/// An engine that a simulation can be run with. Its own file makes it known by MAKE_PHYSICS.
struct PhysicsEngine {
  const char* name;  ///< as in --engine
  int order;         ///< its place in lists; those of the same order by their names
  std::unique_ptr<Physics> (*make)(const PhysicsConfig& config);
};

/// Takes an engine in before main. A second one of the same name ends the program start: that is a mistake of
/// the build.
class PhysicsLoader {
public:
  explicit PhysicsLoader(const PhysicsEngine& engine);
};

/// MAKE_PHYSICS(ode, {"ode", 10, makeOde}): in the engine's .cpp.
#define MAKE_PHYSICS(id, ...)                                            \
  static const ::plumbline::simulation::PhysicsLoader id##PhysicsLoader( \
      ::plumbline::simulation::PhysicsEngine __VA_ARGS__)

}  // namespace plumbline::simulation
