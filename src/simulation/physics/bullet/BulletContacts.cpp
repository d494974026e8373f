#include "simulation/physics/bullet/BulletContacts.h"

#include <algorithm>
#include <stdexcept>

#include "simulation/physics/BroadPhase.h"

namespace plumbline::simulation::bullet {

namespace {

constexpr std::size_t maxContactsPerPair = 4;

bool reach(const BulletAssembly::Collider& a, const BulletAssembly::Collider& b) {
  const double sum = a.radius + b.radius;
  return (a.centre - b.centre).squaredNorm() <= sum * sum;
}

}  // namespace

/// Takes the points of a pair as Bullet's algorithms report them.
class BulletContacts::Result : public btManifoldResult {
public:
  struct Point {
    Vec3 point, normal;
    double depth;
  };

  Result(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b) : btManifoldResult(a, b) {}

  void addContactPoint(const btVector3& normalOnB, const btVector3& onB, btScalar distance) override {
    if (distance > 0) return;
    // An algorithm may have taken the two the other way round.
    const bool swapped = m_manifoldPtr->getBody0() != m_body0Wrap->getCollisionObject();
    points.push_back(swapped ? Point{toVec3(onB + normalOnB * distance), toVec3(-normalOnB), -distance}
                             : Point{toVec3(onB), toVec3(normalOnB), -distance});
  }

  std::vector<Point> points;
};

BulletContacts::BulletContacts(const PhysicsConfig& config) : surfaces_(config.surfaces) {
  btDefaultCollisionConstructionInfo pools;  // pairs are asked for one by one
  pools.m_defaultMaxPersistentManifoldPoolSize = 8;
  pools.m_defaultMaxCollisionAlgorithmPoolSize = 8;
  configuration_ = std::make_unique<btDefaultCollisionConfiguration>(pools);
  dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
}

void BulletContacts::addGround(Material material) {
  if (hasGround_) throw std::logic_error("physics: there is a ground already");
  hasGround_ = true;
  groundMaterial_ = material;
}

void BulletContacts::addStatic(const Shape& shape, const Pose3& T_world_shape, Material material) {
  Static added;
  added.shape = makeShape(shape);
  added.object = std::make_unique<btCollisionObject>();
  added.object->setCollisionShape(added.shape.get());
  const btTransform pose = fromPose3(T_world_shape * shape.T_link_shape);
  added.object->setWorldTransform(pose);
  btVector3 lower, upper;
  added.shape->getAabb(pose, lower, upper);
  added.box = {toVec3(lower), toVec3(upper)};
  added.material = material;
  statics_.push_back(std::move(added));
}

void BulletContacts::find(const Assemblies& assemblies) {
  contactList_.clear();
  geometries_.clear();
  findNear(
      assemblies, boxes_,
      [this](int handle, const BulletAssembly& assembly, const Eigen::AlignedBox3d& box) {
        collideWithStatics(handle, assembly, box);
        if (assembly.selfCollision()) collideWithin(handle, assembly);
      },
      [this](int handleA, const BulletAssembly& a, int handleB, const BulletAssembly& b,
             const Eigen::AlignedBox3d& overlap) { collideAssemblies(handleA, a, handleB, b, overlap); });
}

void BulletContacts::collideWithStatics(int handle, const BulletAssembly& assembly,
                                        const Eigen::AlignedBox3d& box) {
  if (hasGround_ && box.min().z() <= 0)
    for (const Collider& collider : assembly.colliders())
      if (collider.centre.z() <= collider.radius) collideWithGround(handle, collider);
  for (const Static& s : statics_) {
    if (!s.box.intersects(box)) continue;
    for (const Collider& collider : assembly.colliders())
      if (s.box.intersects(sphereBox(collider.centre, collider.radius)))
        collide(side(handle, collider), {-1, -1, s.object.get(), s.material});
  }
}

void BulletContacts::collideWithGround(int handle, const Collider& collider) {
  const Pose3 pose = toPose3(collider.object->getWorldTransform());
  const Vec3 half = collider.spec.size / 2;
  std::vector<Vec3> points;
  switch (collider.spec.kind) {
    case Shape::Kind::sphere:
      points = {pose.translation() - collider.spec.size.x() * Vec3::UnitZ()};
      break;
    case Shape::Kind::capsule:
      for (const double end : {-half.z(), half.z()})
        points.emplace_back(pose * Vec3(0, 0, end) - collider.spec.size.x() * Vec3::UnitZ());
      break;
    case Shape::Kind::box:
      for (int corner = 0; corner < 8; ++corner)
        points.push_back(pose * Vec3(corner & 1 ? half.x() : -half.x(), corner & 2 ? half.y() : -half.y(),
                                     corner & 4 ? half.z() : -half.z()));
      break;
  }
  std::erase_if(points, [](const Vec3& p) { return p.z() > 0; });
  if (points.size() > maxContactsPerPair) {
    std::stable_sort(points.begin(), points.end(),
                     [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
    points.resize(maxContactsPerPair);
  }
  for (const Vec3& point : points)
    add(side(handle, collider), {-1, -1, nullptr, groundMaterial_}, point, Vec3::UnitZ(), -point.z());
}

void BulletContacts::collideAssemblies(int handleA, const BulletAssembly& a, int handleB,
                                       const BulletAssembly& b, const Eigen::AlignedBox3d& overlap) {
  for (const Collider& ca : a.colliders()) {
    if (!overlap.intersects(sphereBox(ca.centre, ca.radius))) continue;
    for (const Collider& cb : b.colliders())
      if (reach(ca, cb)) collide(side(handleA, ca), side(handleB, cb));
  }
}

void BulletContacts::collideWithin(int handle, const BulletAssembly& assembly) {
  const auto& colliders = assembly.colliders();
  for (std::size_t i = 0; i < colliders.size(); ++i)
    for (std::size_t j = i + 1; j < colliders.size(); ++j)
      // Neighbours along a limb always overlap at their joint.
      if (colliders[j].neighbour != colliders[i].index && reach(colliders[i], colliders[j]))
        collide(side(handle, colliders[i]), side(handle, colliders[j]));
}

void BulletContacts::collide(const Side& a, const Side& b) {
  const btCollisionObjectWrapper wrapA(nullptr, a.object->getCollisionShape(), a.object,
                                       a.object->getWorldTransform(), -1, -1);
  const btCollisionObjectWrapper wrapB(nullptr, b.object->getCollisionShape(), b.object,
                                       b.object->getWorldTransform(), -1, -1);
  btCollisionAlgorithm* algorithm =
      dispatcher_->findAlgorithm(&wrapA, &wrapB, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  if (!algorithm) return;
  Result result(&wrapA, &wrapB);
  algorithm->processCollision(&wrapA, &wrapB, dispatchInfo_, &result);
  algorithm->~btCollisionAlgorithm();
  dispatcher_->freeCollisionAlgorithm(algorithm);
  if (result.points.size() > maxContactsPerPair) {
    std::stable_sort(result.points.begin(), result.points.end(),
                     [](const auto& p, const auto& q) { return p.depth > q.depth; });
    result.points.resize(maxContactsPerPair);
  }
  for (const Result::Point& p : result.points) add(a, b, p.point, p.normal, p.depth);
}

void BulletContacts::add(const Side& a, const Side& b, const Vec3& point, const Vec3& normal, double depth) {
  contactList_.push_back({a.assembly, a.index, b.assembly, b.index, point, Vec3::Zero()});
  geometries_.push_back(
      {normal, depth, surfaces_[static_cast<std::size_t>(a.material)][static_cast<std::size_t>(b.material)]});
}

}  // namespace plumbline::simulation::bullet
