#include "simulation/physics/Physics.h"

#include <stdexcept>

#include "simulation/physics/bullet/BulletPhysics.h"
#include "simulation/physics/ode/OdePhysics.h"

namespace plumbline::simulation {

const std::vector<std::string>& physicsEngines() {
  static const std::vector<std::string> names = {"ode", "ode-dense", "bullet"};
  return names;
}

std::unique_ptr<Physics> makePhysics(std::string_view engine, const PhysicsConfig& config) {
  for (const auto& row : config.surfaces)
    if (row.size() != config.surfaces.size())
      throw std::invalid_argument("physics: the table of contact surfaces must be square");
  if (engine == "ode") return ode::makeOdePhysics(config, ode::Solver::tree);
  if (engine == "ode-dense") return ode::makeOdePhysics(config, ode::Solver::dense);
  if (engine == "bullet") return bullet::makeBulletPhysics(config);
  std::string known;
  for (const std::string& name : physicsEngines()) known += (known.empty() ? "" : ", ") + name;
  throw std::invalid_argument("unknown physics engine \"" + std::string(engine) + "\"; there are: " + known);
}

}  // namespace plumbline::simulation
