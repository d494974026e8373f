#include "simulation/physics/ode/OdeAssembly.h"

#include <stdexcept>

#include "math/Index.h"
#include "simulation/physics/AssemblyCheck.h"
#include "simulation/physics/Drag.h"

namespace plumbline::simulation::ode {

namespace {

// ODE's defaults, which the league's server uses.
constexpr int idleSteps = 10;
constexpr double idleSpeed = 0.01;  // [m/s, rad/s]

}  // namespace

dGeomID makeGeom(const Shape& shape) {
  checkShape(shape);
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return dCreateSphere(nullptr, shape.size.x());
    case Shape::Kind::capsule:
      return dCreateCapsule(nullptr, shape.size.x(), shape.size.z());
    case Shape::Kind::box:
      break;
  }
  return dCreateBox(nullptr, shape.size.x(), shape.size.y(), shape.size.z());
}

OdeAssembly::OdeAssembly(dWorldID world, const Assembly& assembly, const Pose3& T_world_root)
    : spec_(assembly) {
  checkAssembly(spec_);
  hingeOfBody_.assign(spec_.bodies.size(), -1);
  for (std::size_t i = 0; i < spec_.hinges.size(); ++i)
    hingeOfBody_[at(spec_.hinges[i].child)] = static_cast<int>(i);
  for (const BodySpec& body : spec_.bodies) addBody(world, body, T_world_root);
  for (const HingeSpec& hinge : spec_.hinges) addHinge(world, hinge, T_world_root);
  stepsToSleep_.assign(bodies_.size(), idleSteps);
  equations_.emplace(spec_, bodies_, hinges_);
}

OdeAssembly::~OdeAssembly() {
  for (const Collider& collider : colliderList_) dGeomDestroy(collider.geom);
  for (dJointID hinge : hinges_) dJointDestroy(hinge);
  for (dBodyID body : bodies_) dBodyDestroy(body);
}

void OdeAssembly::addBody(dWorldID world, const BodySpec& body, const Pose3& T_world_root) {
  const int index = static_cast<int>(bodies_.size());
  dBodyID id = dBodyCreate(world);
  bodies_.push_back(id);
  dMass mass;
  const Mat3& inertia = body.inertia;
  dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1),
                     inertia(0, 2), inertia(1, 2));
  dBodySetMass(id, &mass);
  setBodyPose(id, T_world_root * body.T_root_body);
  if (!body.shape) return;
  dGeomID geom = makeGeom(*body.shape);
  dGeomSetBody(geom, id);
  const Pose3& offset = body.shape->T_link_shape;
  if (!offset.isApprox(Pose3::Identity(), 0)) {
    dMatrix3 rotation;
    fromMat3(offset.linear(), rotation);
    dGeomSetOffsetPosition(geom, offset.translation().x(), offset.translation().y(),
                           offset.translation().z());
    dGeomSetOffsetRotation(geom, rotation);
  }
  colliderList_.push_back(
      {geom, id, index, nearestColliderAbove(index), boundingRadius(*body.shape), body.material});
}

int OdeAssembly::nearestColliderAbove(int body) const {
  while (hingeOfBody_[at(body)] >= 0) {
    body = spec_.hinges[at(hingeOfBody_[at(body)])].parent;
    if (spec_.bodies[at(body)].shape) return body;
  }
  return -1;
}

void OdeAssembly::addHinge(dWorldID world, const HingeSpec& hinge, const Pose3& T_world_root) {
  dJointID id = dJointCreateHinge(world, nullptr);
  hinges_.push_back(id);
  // The child is the first body: then angles and velocities are the child's against the parent's.
  dJointAttach(id, body(hinge.child), body(hinge.parent));
  const Vec3 anchor = T_world_root * hinge.anchor;
  const Vec3 axis = T_world_root.linear() * hinge.axis;
  dJointSetHingeAnchor(id, anchor.x(), anchor.y(), anchor.z());
  dJointSetHingeAxis(id, axis.x(), axis.y(), axis.z());
  dJointSetHingeParam(id, dParamFMax, hinge.maxTorque);
  dJointSetHingeParam(id, dParamCFM, hinge.cfm);
  dJointSetHingeParam(id, dParamStopCFM, hinge.stopCfm);
  dJointSetHingeParam(id, dParamStopERP, hinge.stopErp);
  dJointSetHingeParam(id, dParamFudgeFactor, hinge.fudgeFactor);
  dJointSetHingeParam(id, dParamBounce, hinge.stopBounce);
  dJointSetHingeParam(id, dParamLoStop, hinge.lower);
  dJointSetHingeParam(id, dParamHiStop, hinge.upper);
}

void OdeAssembly::applyDrag(double h) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodySpec& body = spec_.bodies[i];
    const dReal* v = dBodyGetLinearVel(bodies_[i]);
    dBodyAddForce(bodies_[i], -body.linearDrag * v[0], -body.linearDrag * v[1], -body.linearDrag * v[2]);
    const Vec3 torque =
        dragTorque(body, toMat3(dBodyGetRotation(bodies_[i])), toVec3(dBodyGetAngularVel(bodies_[i])), h);
    dBodyAddTorque(bodies_[i], torque.x(), torque.y(), torque.z());
  }
}

Eigen::AlignedBox3d OdeAssembly::bounds() const {
  Eigen::AlignedBox3d box;
  for (const Collider& collider : colliderList_) {
    const Vec3 centre = toVec3(dGeomGetPosition(collider.geom));
    box.extend(Vec3(centre.array() - collider.radius));
    box.extend(Vec3(centre.array() + collider.radius));
  }
  return box;
}

AssemblyState OdeAssembly::state() const {
  AssemblyState state;
  state.root.pose = bodyPose(bodies_[0]);
  state.root.linearVelocity = toVec3(dBodyGetLinearVel(bodies_[0]));
  state.root.angularVelocity = toVec3(dBodyGetAngularVel(bodies_[0]));
  for (dJointID hinge : hinges_) {
    state.angle.push_back(dJointGetHingeAngle(hinge));
    state.rate.push_back(dJointGetHingeAngleRate(hinge));
  }
  return state;
}

void OdeAssembly::setState(const AssemblyState& state) {
  checkSize(state);
  equations_->forgetAngles();
  std::vector<Pose3> poses(bodies_.size(), state.root.pose);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (const int h = hingeOfBody_[i]; h >= 0) {
      const HingeSpec& hinge = spec_.hinges[at(h)];
      // Both bodies' frames and the hinge are known in the root's frame with all hinges at zero.
      const Pose3 T_world_zero =
          poses[at(hinge.parent)] * spec_.bodies[at(hinge.parent)].T_root_body.inverse();
      poses[i] = T_world_zero * translation(hinge.anchor) * rotation(hinge.axis, state.angle[at(h)]) *
                 translation(-hinge.anchor) * spec_.bodies[i].T_root_body;
    }
    setBodyPose(bodies_[i], poses[i]);
    wake(static_cast<int>(i));
  }
  setVelocities(state);
}

void OdeAssembly::setVelocities(const AssemblyState& state) {
  checkSize(state);
  struct Velocity {
    Vec3 linear, angular;
  };
  std::vector<Velocity> velocities(bodies_.size(), {state.root.linearVelocity, state.root.angularVelocity});
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Velocity& own = velocities[i];
    if (const int h = hingeOfBody_[i]; h >= 0) {
      const int parent = spec_.hinges[at(h)].parent;
      dVector3 anchor, axis;
      dJointGetHingeAnchor(hinges_[at(h)], anchor);
      dJointGetHingeAxis(hinges_[at(h)], axis);
      own = velocities[at(parent)];
      own.linear += own.angular.cross(toVec3(anchor) - toVec3(dBodyGetPosition(bodies_[at(parent)])));
      own.angular += toVec3(axis) * state.rate[at(h)];
      own.linear += own.angular.cross(toVec3(dBodyGetPosition(bodies_[i])) - toVec3(anchor));
    }
    dBodySetLinearVel(bodies_[i], own.linear.x(), own.linear.y(), own.linear.z());
    dBodySetAngularVel(bodies_[i], own.angular.x(), own.angular.y(), own.angular.z());
  }
}

void OdeAssembly::checkSize(const AssemblyState& state) const {
  if (state.angle.size() != hinges_.size() || state.rate.size() != hinges_.size())
    throw std::invalid_argument("physics: a state needs an angle and a rate for each hinge");
}

void OdeAssembly::moveRigidly(const Pose3& T_world_root) {
  equations_->forgetAngles();
  Pose3 T_new_old = T_world_root * bodyPose(bodies_[0]).inverse();
  // The inverse of a rotation that is off by a bit is off by twice as much the next time: stay a rotation.
  T_new_old.linear() = Eigen::Quaterniond(T_new_old.linear()).normalized().toRotationMatrix();
  for (dBodyID body : bodies_) {
    setBodyPose(body, T_new_old * bodyPose(body));
    dBodySetLinearVel(body, 0, 0, 0);
    dBodySetAngularVel(body, 0, 0, 0);
  }
}

void OdeAssembly::wake(int index) {
  dBodyEnable(body(index));
  stepsToSleep_[at(index)] = idleSteps;
}

void OdeAssembly::updateSleep(bool touching) {
  if (hinges_.empty() && !touching) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!dBodyIsEnabled(bodies_[i])) continue;
    const bool idle = toVec3(dBodyGetLinearVel(bodies_[i])).squaredNorm() <= idleSpeed * idleSpeed &&
                      toVec3(dBodyGetAngularVel(bodies_[i])).squaredNorm() <= idleSpeed * idleSpeed;
    stepsToSleep_[i] = idle ? stepsToSleep_[i] - 1 : idleSteps;
    if (stepsToSleep_[i] > 0) continue;
    dBodyDisable(bodies_[i]);
    dBodySetLinearVel(bodies_[i], 0, 0, 0);
    dBodySetAngularVel(bodies_[i], 0, 0, 0);
  }
}

bool OdeAssembly::asleep() const {
  for (dBodyID body : bodies_)
    if (dBodyIsEnabled(body)) return false;
  return true;
}

}  // namespace plumbline::simulation::ode
