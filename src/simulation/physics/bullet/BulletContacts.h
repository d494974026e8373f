#pragma once
#include <memory>
#include <vector>

#include "simulation/physics/Islands.h"
#include "simulation/physics/bullet/BulletAssembly.h"

namespace plumbline::simulation::bullet {

using Assemblies = AssemblyMap<BulletAssembly>;

/// Where two bodies touch, besides what Contact says.
struct ContactGeometry {
  Vec3 normal = Vec3::UnitZ();  ///< world, out of B into A
  double depth = 0;             ///< [m]
  ContactSurface surface;
};

/// Finds what touches. Pairs are sought by boxes around assemblies, then spheres around bodies; Bullet's
/// algorithms find their points, without memory of the step before. The ground is met exactly: by corners of
/// boxes, ends of capsules and lowest points of spheres, as Bullet's plane gives one point at a time.
class BulletContacts {
public:
  explicit BulletContacts(const PhysicsConfig& config);

  void addGround(Material material);
  void addStatic(const Shape& shape, const Pose3& T_world_shape, Material material);
  void find(const Assemblies& assemblies);

  const std::vector<Contact>& contacts() const { return contactList_; }
  const std::vector<ContactGeometry>& geometry() const { return geometries_; }
  void setForce(std::size_t contact, const Vec3& forceOnA) { contactList_[contact].forceOnA = forceOnA; }

private:
  using Collider = BulletAssembly::Collider;
  struct Static {
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btCollisionObject> object;
    Eigen::AlignedBox3d box;
    Material material;
  };
  struct Side {
    int assembly, index;
    const btCollisionObject* object;
    Material material;
  };
  class Result;

  static Side side(int assembly, const Collider& c) {
    return {assembly, c.index, c.object.get(), c.material};
  }
  void collideWithStatics(int handle, const BulletAssembly& assembly, const Eigen::AlignedBox3d& box);
  void collideWithGround(int handle, const Collider& collider);
  void collideAssemblies(int handleA, const BulletAssembly& a, int handleB, const BulletAssembly& b,
                         const Eigen::AlignedBox3d& overlap);
  void collideWithin(int handle, const BulletAssembly& assembly);
  void collide(const Side& a, const Side& b);
  void add(const Side& a, const Side& b, const Vec3& point, const Vec3& normal, double depth);

  std::vector<std::vector<ContactSurface>> surfaces_;
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  btDispatcherInfo dispatchInfo_;
  std::vector<Static> statics_;
  bool hasGround_ = false;
  Material groundMaterial_ = 0;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<Contact> contactList_;
  std::vector<ContactGeometry> geometries_;
};

}  // namespace plumbline::simulation::bullet
