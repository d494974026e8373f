#pragma once
#include <vector>

#include "simulation/physics/bullet/BulletContacts.h"
#include "simulation/physics/tree/BoundedSystem.h"
#include "simulation/physics/tree/CoulombFriction.h"

namespace plumbline::simulation::bullet {

/// One step of everything that is awake. Assemblies that touch make an island; contacts, motors and stops of
/// an island are the rows of one bounded system over what Bullet says they do to its multi-bodies. It is
/// solved exactly, as links of 1e-6 kg m^2 leave Bullet's own iterative solvers far from the solution.
class BulletStep {
public:
  void step(const PhysicsConfig& config, const Assemblies& assemblies, BulletContacts& contacts);

private:
  struct HingeRow {
    BulletAssembly* assembly;
    BulletAssembly::HingeRow row;
    bool saturated = false, newlySaturated = false;
  };

  void stepIsland(const PhysicsConfig& config, BulletContacts& contacts);
  void addContactRows(const BulletContacts& contacts, std::size_t index);
  void fillSystem(const PhysicsConfig& config, const BulletContacts& contacts);
  bool solve(const PhysicsConfig& config, const BulletContacts& contacts);

  Islands<BulletAssembly> islands_;
  std::vector<BulletAssembly*> members_;     ///< of the island
  std::vector<std::size_t> contactIndices_;  ///< of the same
  std::vector<Vec3> directions_;             ///< three for each of these
  std::vector<double> outgoing_;             ///< speed of these contacts before the step
  std::vector<HingeRow> hingeRows_;
  std::vector<FrictionLimit> frictionLimits_;
  BoundedSystem system_;
};

}  // namespace plumbline::simulation::bullet
