#pragma once
#include <set>
#include <stdexcept>
#include <string>

#include "simulation/physics/Islands.h"

namespace plumbline::simulation {

/// The part of a physics engine that only passes on to its assemblies, and the errors of handles and
/// materials that do not exist. `EngineAssembly` is the engine's own assembly.
template <class EngineAssembly>
class AssembliesPhysics : public Physics {
public:
  void removeAssembly(int assembly) override {
    get(assembly);
    assemblies.erase(assembly);
  }
  AssemblyState state(int assembly) const override { return get(assembly).state(); }
  void setState(int assembly, const AssemblyState& state) override { get(assembly).setState(state); }
  void setVelocities(int assembly, const AssemblyState& state) override {
    get(assembly).setVelocities(state);
  }
  void moveRigidly(int assembly, const Pose3& T_world_root) override {
    get(assembly).moveRigidly(T_world_root);
  }
  bool asleep(int assembly) const override { return get(assembly).asleep(); }

protected:
  explicit AssembliesPhysics(const PhysicsConfig& config) : config(config) {}

  /// `arguments`: what an engine's assembly is made with.
  template <class... Arguments>
  int add(const Assembly& assembly, const Arguments&... arguments) {
    for (const BodySpec& body : assembly.bodies) check(body.material);
    assemblies.emplace(nextHandle, std::make_unique<EngineAssembly>(arguments...));
    return nextHandle++;
  }

  /// Sees who falls asleep and who wakes up, after contacts were found.
  void updateSleep() {
    std::set<int> touching;
    for (const Contact& contact : contacts()) {
      touching.insert(contact.assemblyA);
      touching.insert(contact.assemblyB);
    }
    for (const auto& [handle, assembly] : assemblies) assembly->updateSleep(touching.contains(handle));
  }

  void check(Material material) const {
    if (material < 0 || static_cast<std::size_t>(material) >= config.surfaces.size())
      throw std::invalid_argument("physics: no contact surfaces for material " + std::to_string(material));
  }

  EngineAssembly& get(int assembly) const {
    const auto it = assemblies.find(assembly);
    if (it == assemblies.end())
      throw std::out_of_range("physics: no assembly " + std::to_string(assembly) + " in this world");
    return *it->second;
  }

  PhysicsConfig config;
  AssemblyMap<EngineAssembly> assemblies;
  int nextHandle = 0;
};

}  // namespace plumbline::simulation
