#pragma once
#include "simulation/physics/Physics.h"

namespace plumbline::simulation {

/// Error: std::invalid_argument for a size that is not positive.
void checkShape(const Shape& shape);

/// What every engine refuses before it makes anything of an assembly: no body, hinges that do not make a tree
/// with parents before their children, impossible shapes. Error: std::invalid_argument.
void checkAssembly(const Assembly& assembly);

/// Radius of the sphere about the shape's centre that holds it [m].
double boundingRadius(const Shape& shape);

}  // namespace plumbline::simulation
