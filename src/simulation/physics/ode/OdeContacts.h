#pragma once
#include <vector>

#include "simulation/physics/Islands.h"
#include "simulation/physics/ode/OdeAssembly.h"

namespace plumbline::simulation::ode {

using Assemblies = AssemblyMap<OdeAssembly>;

/// Finds what touches, makes ODE's contact joints for the step to come and reads their forces after it. Pairs
/// are sought by boxes around assemblies, then spheres around bodies; what can never touch is never asked
/// for.
class OdeContacts {
public:
  OdeContacts(dWorldID world, const PhysicsConfig& config);
  ~OdeContacts();
  OdeContacts(const OdeContacts&) = delete;
  OdeContacts& operator=(const OdeContacts&) = delete;

  void addGround(Material material);
  void addStatic(const Shape& shape, const Pose3& T_world_shape, Material material);

  void find(const Assemblies& assemblies);
  /// Makes ODE's joints of what was found.
  void makeJoints();
  /// After ODE's step: takes the forces and lets the joints go.
  void takeForces();

  const std::vector<Contact>& contacts() const { return contactList_; }
  /// The same with their geometry and surface.
  const std::vector<dContact>& found() const { return foundContacts_; }
  void setForce(std::size_t contact, const Vec3& forceOnA) { contactList_[contact].forceOnA = forceOnA; }

private:
  struct Static {
    dGeomID geom;
    Eigen::AlignedBox3d box;
    Material material;
  };
  struct Side {
    int assembly;
    int index;
    dGeomID geom;
    dBodyID body;
    Material material;
  };
  static Side side(int assembly, const OdeAssembly::Collider& c) {
    return {assembly, c.index, c.geom, c.body, c.material};
  }

  void collideWithStatics(int handle, const OdeAssembly& assembly, const Eigen::AlignedBox3d& box);
  void collideAssemblies(int handleA, const OdeAssembly& a, int handleB, const OdeAssembly& b,
                         const Eigen::AlignedBox3d& overlap);
  void collideWithin(int handle, const OdeAssembly& assembly);
  void collide(const Side& a, const Side& b);

  dWorldID world_;
  dJointGroupID group_;
  std::vector<std::vector<dSurfaceParameters>> surfaces_;
  std::vector<Static> statics_;
  dGeomID ground_ = nullptr;
  Material groundMaterial_ = 0;
  std::vector<dContact> foundContacts_;
  std::vector<std::pair<dBodyID, dBodyID>> bodies_;
  std::vector<dJointFeedback> feedback_;
  std::vector<Contact> contactList_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace plumbline::simulation::ode
