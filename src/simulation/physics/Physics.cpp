#include "simulation/physics/Physics.h"

#include <stdexcept>
#include <tuple>

#include "framework/SelfRegistration.h"
#include "simulation/physics/PhysicsEngine.h"

namespace plumbline::simulation {

namespace {

std::vector<PhysicsEngine>& registered() {
  static std::vector<PhysicsEngine> engines;
  return engines;
}

}  // namespace

PhysicsLoader::PhysicsLoader(const PhysicsEngine& engine) {
  registerInOrder(registered(), engine, "physics engines",
                  [](const PhysicsEngine& e) { return std::tuple(e.order, std::string_view(e.name)); });
}

const std::vector<std::string>& physicsEngines() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const PhysicsEngine& engine : registered()) list.emplace_back(engine.name);
    return list;
  }();
  return names;
}

std::unique_ptr<Physics> makePhysics(std::string_view engine, const PhysicsConfig& config) {
  for (const auto& row : config.surfaces)
    if (row.size() != config.surfaces.size())
      throw std::invalid_argument("physics: the table of contact surfaces must be square");
  for (const PhysicsEngine& known : registered())
    if (known.name == engine) return known.make(config);
  std::string names;
  for (const std::string& name : physicsEngines()) names += (names.empty() ? "" : ", ") + name;
  throw std::invalid_argument("unknown physics engine \"" + std::string(engine) + "\"; there are: " + names);
}

}  // namespace plumbline::simulation
