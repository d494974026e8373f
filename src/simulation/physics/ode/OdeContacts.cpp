#include "simulation/physics/ode/OdeContacts.h"

#include <cmath>
#include <stdexcept>

#include "simulation/physics/BroadPhase.h"

namespace plumbline::simulation::ode {

namespace {

constexpr int maxContactsPerPair = 4;  // as on the league's server

dSurfaceParameters toOde(const ContactSurface& surface) {
  dSurfaceParameters result{};
  // Without dContactApprox1 friction has no Coulomb limit and holds at zero normal force, too.
  result.mode = dContactSoftERP | dContactSoftCFM | dContactSlip1 | dContactSlip2;
  result.mu = dInfinity;
  if (std::isfinite(surface.friction)) {
    result.mode |= dContactApprox1;
    result.mu = surface.friction;
  }
  result.soft_erp = surface.softErp;
  result.soft_cfm = surface.softCfm;
  result.slip1 = result.slip2 = surface.slip;
  if (surface.bounce > 0) {
    result.mode |= dContactBounce;
    result.bounce = surface.bounce;
    result.bounce_vel = surface.bounceVelocity;
  }
  return result;
}

}  // namespace

OdeContacts::OdeContacts(dWorldID world, const PhysicsConfig& config)
    : world_(world), group_(dJointGroupCreate(0)) {
  for (const auto& row : config.surfaces) {
    auto& converted = surfaces_.emplace_back();
    for (const ContactSurface& surface : row) converted.push_back(toOde(surface));
  }
}

OdeContacts::~OdeContacts() {
  dJointGroupDestroy(group_);
  for (const Static& s : statics_) dGeomDestroy(s.geom);
  if (ground_) dGeomDestroy(ground_);
}

void OdeContacts::addGround(Material material) {
  if (ground_) throw std::logic_error("physics: there is a ground already");
  ground_ = dCreatePlane(nullptr, 0, 0, 1, 0);
  groundMaterial_ = material;
}

void OdeContacts::addStatic(const Shape& shape, const Pose3& T_world_shape, Material material) {
  dGeomID geom = makeGeom(shape);
  const Pose3 pose = T_world_shape * shape.T_link_shape;
  dMatrix3 rotation;
  fromMat3(pose.linear(), rotation);
  dGeomSetPosition(geom, pose.translation().x(), pose.translation().y(), pose.translation().z());
  dGeomSetRotation(geom, rotation);
  dReal aabb[6];
  dGeomGetAABB(geom, aabb);
  statics_.push_back({geom, {Vec3(aabb[0], aabb[2], aabb[4]), Vec3(aabb[1], aabb[3], aabb[5])}, material});
}

void OdeContacts::find(const Assemblies& assemblies) {
  contactList_.clear();
  foundContacts_.clear();
  bodies_.clear();
  findNear(
      assemblies, boxes_,
      [this](int handle, const OdeAssembly& assembly, const Eigen::AlignedBox3d& box) {
        collideWithStatics(handle, assembly, box);
        if (assembly.selfCollision()) collideWithin(handle, assembly);
      },
      [this](int handleA, const OdeAssembly& a, int handleB, const OdeAssembly& b,
             const Eigen::AlignedBox3d& overlap) { collideAssemblies(handleA, a, handleB, b, overlap); });
}

void OdeContacts::makeJoints() {
  feedback_.assign(foundContacts_.size(), dJointFeedback{});
  for (std::size_t k = 0; k < foundContacts_.size(); ++k) {
    dJointID joint = dJointCreateContact(world_, group_, &foundContacts_[k]);
    dJointAttach(joint, bodies_[k].first, bodies_[k].second);
    dJointSetFeedback(joint, &feedback_[k]);
  }
}

void OdeContacts::collideWithStatics(int handle, const OdeAssembly& assembly,
                                     const Eigen::AlignedBox3d& box) {
  if (ground_ && box.min().z() <= 0)
    for (const auto& collider : assembly.colliders())
      if (dGeomGetPosition(collider.geom)[2] <= collider.radius)
        collide(side(handle, collider), {-1, -1, ground_, nullptr, groundMaterial_});
  for (const Static& s : statics_) {
    if (!s.box.intersects(box)) continue;
    for (const auto& collider : assembly.colliders())
      if (s.box.intersects(sphereBox(toVec3(dGeomGetPosition(collider.geom)), collider.radius)))
        collide(side(handle, collider), {-1, -1, s.geom, nullptr, s.material});
  }
}

void OdeContacts::collideAssemblies(int handleA, const OdeAssembly& a, int handleB, const OdeAssembly& b,
                                    const Eigen::AlignedBox3d& overlap) {
  for (const auto& ca : a.colliders()) {
    const Vec3 centreA = toVec3(dGeomGetPosition(ca.geom));
    if (!overlap.intersects(sphereBox(centreA, ca.radius))) continue;
    for (const auto& cb : b.colliders()) {
      const double reach = ca.radius + cb.radius;
      if ((toVec3(dGeomGetPosition(cb.geom)) - centreA).squaredNorm() <= reach * reach)
        collide(side(handleA, ca), side(handleB, cb));
    }
  }
}

void OdeContacts::collideWithin(int handle, const OdeAssembly& assembly) {
  const auto& colliders = assembly.colliders();
  for (std::size_t i = 0; i < colliders.size(); ++i)
    for (std::size_t j = i + 1; j < colliders.size(); ++j) {
      // Neighbours along a limb always overlap at their joint.
      if (colliders[j].neighbour == colliders[i].index) continue;
      const double reach = colliders[i].radius + colliders[j].radius;
      const Vec3 centre = toVec3(dGeomGetPosition(colliders[i].geom));
      if ((toVec3(dGeomGetPosition(colliders[j].geom)) - centre).squaredNorm() <= reach * reach)
        collide(side(handle, colliders[i]), side(handle, colliders[j]));
    }
}

void OdeContacts::collide(const Side& a, const Side& b) {
  dContactGeom points[maxContactsPerPair];
  const int count = dCollide(a.geom, b.geom, maxContactsPerPair, points, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) {
    dContact contact{};
    contact.surface = surfaces_[static_cast<std::size_t>(a.material)][static_cast<std::size_t>(b.material)];
    contact.geom = points[i];
    foundContacts_.push_back(contact);
    bodies_.emplace_back(a.body, b.body);
    contactList_.push_back({a.assembly, a.index, b.assembly, b.index, toVec3(points[i].pos), Vec3::Zero()});
  }
}

void OdeContacts::takeForces() {
  for (std::size_t i = 0; i < contactList_.size(); ++i) contactList_[i].forceOnA = toVec3(feedback_[i].f1);
  dJointGroupEmpty(group_);
}

}  // namespace plumbline::simulation::ode
