#include "simulation/physics/AssemblyCheck.h"

#include <stdexcept>

namespace plumbline::simulation {

void checkShape(const Shape& shape) {
  const bool needsAll = shape.kind == Shape::Kind::box;
  const bool needsZ = shape.kind != Shape::Kind::sphere;
  if (!(shape.size.x() > 0) || (needsAll && !(shape.size.y() > 0)) || (needsZ && !(shape.size.z() > 0)))
    throw std::invalid_argument("physics: a shape's size must be positive");
}

void checkAssembly(const Assembly& assembly) {
  if (assembly.bodies.empty()) throw std::invalid_argument("physics: an assembly needs a body");
  const int count = static_cast<int>(assembly.bodies.size());
  std::vector<bool> joined(assembly.bodies.size(), false);
  joined[0] = true;
  for (const HingeSpec& hinge : assembly.hinges) {
    if (hinge.parent < 0 || hinge.parent >= hinge.child || hinge.child >= count ||
        joined[static_cast<std::size_t>(hinge.child)])
      throw std::invalid_argument("physics: hinges must join each child once to a parent before it");
    joined[static_cast<std::size_t>(hinge.child)] = true;
  }
  for (const bool each : joined)
    if (!each) throw std::invalid_argument("physics: each body but the first needs a hinge to its parent");
  for (const BodySpec& body : assembly.bodies)
    if (body.shape) checkShape(*body.shape);
}

double boundingRadius(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return shape.size.x();
    case Shape::Kind::capsule:
      return shape.size.x() + shape.size.z() / 2;
    case Shape::Kind::box:
      break;
  }
  return shape.size.norm() / 2;
}

}  // namespace plumbline::simulation
