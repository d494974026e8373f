#pragma once
#include <optional>
#include <vector>

#include "simulation/physics/Physics.h"
#include "simulation/physics/ode/OdeTree.h"
#include "simulation/physics/ode/OdeTypes.h"

namespace plumbline::simulation::ode {

/// Makes the geom of a shape, in no space: pairs are found by OdeContacts. Error: std::invalid_argument for a
/// size that is not positive.
dGeomID makeGeom(const Shape& shape);

/// An assembly as ODE's bodies, geoms and hinge joints; owns them.
class OdeAssembly {
public:
  OdeAssembly(dWorldID world, const Assembly& assembly, const Pose3& T_world_root);
  ~OdeAssembly();
  OdeAssembly(const OdeAssembly&) = delete;
  OdeAssembly& operator=(const OdeAssembly&) = delete;

  /// A body that can touch something.
  struct Collider {
    dGeomID geom;
    dBodyID body;
    int index;      ///< of the body
    int neighbour;  ///< nearest body up the tree that has a collider, -1: none
    double radius;  ///< of the sphere that holds the geom
    Material material;
  };

  /// Adds drag to the forces of the next step, of h seconds.
  void applyDrag(double h);
  /// Box around all colliders.
  Eigen::AlignedBox3d bounds() const;
  const std::vector<Collider>& colliders() const { return colliderList_; }
  bool selfCollision() const { return spec_.selfCollision; }

  dBodyID body(int index) const { return bodies_.at(static_cast<std::size_t>(index)); }
  dJointID hinge(int index) const { return hinges_.at(static_cast<std::size_t>(index)); }
  double hingeAngle(int index) { return equations_->angle(static_cast<std::size_t>(index)); }
  AssemblyState state() const;
  void setState(const AssemblyState& state);
  void setVelocities(const AssemblyState& state);
  void moveRigidly(const Pose3& T_world_root);
  /// Wakes one body.
  void wake(int body);
  bool asleep() const;
  /// ODE's auto-disabling: a body that has been slow for ten steps stops and sleeps; whatever it is joined to
  /// or touches wakes it again in the same step. A free body in the air does not sleep.
  void updateSleep(bool touching);
  OdeTree& tree() { return *equations_; }

private:
  void addBody(dWorldID world, const BodySpec& body, const Pose3& T_world_root);
  void addHinge(dWorldID world, const HingeSpec& hinge, const Pose3& T_world_root);
  void checkSize(const AssemblyState& state) const;
  int nearestColliderAbove(int body) const;

  Assembly spec_;
  std::vector<dBodyID> bodies_;
  std::vector<dJointID> hinges_;
  std::vector<int> hingeOfBody_;  ///< the hinge to the parent, -1: root
  std::vector<Collider> colliderList_;
  std::vector<int> stepsToSleep_;
  std::optional<OdeTree> equations_;
};

}  // namespace plumbline::simulation::ode
