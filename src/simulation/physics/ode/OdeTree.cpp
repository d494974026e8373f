#include "simulation/physics/ode/OdeTree.h"

#include <Eigen/LU>
#include <limits>

#include "math/Index.h"

namespace plumbline::simulation::ode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<int> parentsOf(const Assembly& assembly) {
  std::vector<int> parents(assembly.bodies.size(), 0);
  parents[0] = -1;
  for (const HingeSpec& hinge : assembly.hinges) parents[at(hinge.child)] = hinge.parent;
  return parents;
}

/// Torque of the turning of a body's own axes, as ODE has it since 0.13: semi-implicit, after C. Lacoursiere,
/// Stabilizing gyroscopic forces in rigid multibody simulations, 2006.
Vec3 gyroscopicTorque(const Mat3& inertia, const Vec3& angularVelocity, double h) {
  const Vec3 momentum = inertia * angularVelocity;
  Mat3 implicit = inertia - h * cross(momentum);
  return (inertia * implicit.inverse() - Mat3::Identity()) * (momentum / h);
}

}  // namespace

OdeTree::OdeTree(const Assembly& assembly, const std::vector<dBodyID>& bodies,
                 const std::vector<dJointID>& hinges)
    : bodies_(bodies), hinges_(hinges), tree_(parentsOf(assembly)) {
  for (const BodySpec& body : assembly.bodies) {
    inertias_.push_back(body.inertia);
    masses_.push_back(body.mass);
  }
  for (const HingeSpec& hinge : assembly.hinges) {
    const Pose3 &child = assembly.bodies[at(hinge.child)].T_root_body,
                &parent = assembly.bodies[at(hinge.parent)].T_root_body;
    HingeFrame frame;
    frame.spec = hinge;
    frame.childAnchor = child.inverse() * hinge.anchor;
    frame.parentAnchor = parent.inverse() * hinge.anchor;
    frame.childAxis = child.linear().transpose() * hinge.axis;
    frame.parentAxis = parent.linear().transpose() * hinge.axis;
    frames_.push_back(frame);
  }
}

void OdeTree::begin(const PhysicsConfig& config) {
  origin_ = toVec3(dBodyGetPosition(bodies_[0]));
  for (std::size_t i = 0; i < bodies_.size(); ++i) readBody(static_cast<int>(i), config);
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    frames_[i].saturated = false;
    readHinge(i, config);
  }
  tree_.factor();
  tree_.solve(config.stepSeconds);
}

void OdeTree::solve(const PhysicsConfig& config) {
  tree_.refactor();
  tree_.solve(config.stepSeconds);
}

void OdeTree::readBody(int i, const PhysicsConfig& config) {
  TreeSystem::Body& body = tree_.body(i);
  dBodyID id = bodies_[at(i)];
  const Mat3 rotation = toMat3(dBodyGetRotation(id));
  body.mass = masses_[at(i)];
  body.inertia = rotation * inertias_[at(i)] * rotation.transpose();
  body.position = toVec3(dBodyGetPosition(id)) - origin_;
  body.linearVelocity = toVec3(dBodyGetLinearVel(id));
  body.angularVelocity = toVec3(dBodyGetAngularVel(id));
  body.force = toVec3(dBodyGetForce(id)) + body.mass * config.gravity;
  body.torque =
      toVec3(dBodyGetTorque(id)) + gyroscopicTorque(body.inertia, body.angularVelocity, config.stepSeconds);
  dBodySetForce(id, 0, 0, 0);
  dBodySetTorque(id, 0, 0, 0);
}

void OdeTree::readHinge(std::size_t index, const PhysicsConfig& config) {
  HingeFrame& hinge = frames_[index];
  const double h = config.stepSeconds;
  TreeSystem::Body &child = tree_.body(hinge.spec.child), &parent = tree_.body(hinge.spec.parent);
  const Mat3 childRotation = toMat3(dBodyGetRotation(bodies_[at(hinge.spec.child)])),
             parentRotation = toMat3(dBodyGetRotation(bodies_[at(hinge.spec.parent)]));
  TreeSystem::Joint& joint = tree_.joint(hinge.spec.child);
  joint.childAnchor = child.position + childRotation * hinge.childAnchor;
  joint.parentAnchor = parent.position + parentRotation * hinge.parentAnchor;
  joint.axis = childRotation * hinge.childAxis;
  const double k = config.constraintErp / h;
  joint.linear = k * (joint.parentAnchor - joint.childAnchor);
  joint.angular = k * joint.axis.cross(Vec3(parentRotation * hinge.parentAxis));
  joint.compliance = config.constraintCfm / h;
  joint.axisCompliance = hinge.spec.cfm / h;

  const double angle = this->angle(index);
  hinge.motorVelocity = dJointGetHingeParam(hinges_[index], dParamVel);
  hinge.stop = angle <= hinge.spec.lower ? -1 : angle >= hinge.spec.upper ? 1 : 0;
  joint.axisFree = hinge.stop != 0 || !(hinge.spec.maxTorque > 0);
  if (hinge.stop == 0) {
    joint.angular += hinge.motorVelocity * joint.axis;
    return;
  }
  hinge.beyond = angle - (hinge.stop < 0 ? hinge.spec.lower : hinge.spec.upper);
  push(child, parent, hinge, joint.axis);
}

/// At a stop ODE's motor is a torque: all it has towards the stop, or a little of it away from it.
void OdeTree::push(TreeSystem::Body& child, TreeSystem::Body& parent, const HingeFrame& hinge,
                   const Vec3& axis) {
  const double speed = hinge.motorVelocity;
  const bool positive = speed > 0 || (speed == 0 && hinge.stop > 0);
  double torque = positive ? hinge.spec.maxTorque : -hinge.spec.maxTorque;
  if (speed * hinge.stop < 0) torque *= hinge.spec.fudgeFactor;
  child.torque += torque * axis;
  parent.torque -= torque * axis;
}

void OdeTree::appendRows(const PhysicsConfig& config, std::vector<OutsideRow>& rows) {
  const double h = config.stepSeconds;
  for (const HingeFrame& hinge : frames_) {
    if (hinge.stop == 0 && !hinge.saturated) continue;
    const TreeSystem::Body &child = tree_.body(hinge.spec.child), &parent = tree_.body(hinge.spec.parent);
    const Vec3& axis = tree_.joint(hinge.spec.child).axis;
    OutsideRow row;
    row.sides[0] = {this, hinge.spec.child, Vec6::Zero()};
    row.sides[1] = {this, hinge.spec.parent, Vec6::Zero()};
    row.sides[0].direction.tail<3>() = axis;
    row.sides[1].direction.tail<3>() = -axis;
    if (hinge.saturated) {
      row.wanted = hinge.motorVelocity;
      row.compliance = hinge.spec.cfm / h;
      row.lower = -hinge.spec.maxTorque * h;
      row.upper = hinge.spec.maxTorque * h;
    } else {
      row.wanted = -hinge.spec.stopErp / h * hinge.beyond;
      row.compliance = hinge.spec.stopCfm / h;
      row.lower = hinge.stop < 0 ? 0 : -infinity;
      row.upper = hinge.stop < 0 ? infinity : 0;
      const double rebound =
          -hinge.spec.stopBounce * axis.dot(Vec3(child.angularVelocity - parent.angularVelocity));
      if (hinge.spec.stopBounce > 0 && rebound * hinge.stop < row.wanted * hinge.stop &&
          rebound * hinge.stop < 0)
        row.wanted = rebound;
    }
    rows.push_back(row);
  }
}

bool OdeTree::finish(const PhysicsConfig& config) {
  tree_.resolve();
  bool ok = true;
  for (HingeFrame& hinge : frames_) {
    TreeSystem::Joint& joint = tree_.joint(hinge.spec.child);
    if (joint.axisFree) continue;
    if (std::abs(tree_.motorImpulse(hinge.spec.child)) <= hinge.spec.maxTorque * config.stepSeconds) continue;
    hinge.saturated = true;
    tree_.freeAxis(hinge.spec.child);
    joint.angular -= hinge.motorVelocity * joint.axis;
    ok = false;
  }
  return ok;
}

double OdeTree::angle(std::size_t hinge) {
  if (!anglesKnown_) {
    angles_.clear();
    for (dJointID id : hinges_) angles_.push_back(dJointGetHingeAngle(id));
    anglesKnown_ = true;
  }
  return angles_.at(hinge);
}

void OdeTree::integrate(const PhysicsConfig& config) {
  forgetAngles();
  const double h = config.stepSeconds;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Vec6& spatial = tree_.velocity(static_cast<int>(i));
    const Vec3 v = velocityAt(spatial, tree_.body(static_cast<int>(i)).position);
    const Vec3 w = spatial.tail<3>();
    dBodyID id = bodies_[i];
    dBodySetLinearVel(id, v.x(), v.y(), v.z());
    dBodySetAngularVel(id, w.x(), w.y(), w.z());
    const dReal* p = dBodyGetPosition(id);
    dBodySetPosition(id, p[0] + h * v.x(), p[1] + h * v.y(), p[2] + h * v.z());
    // q' = q + h/2 (0, w) q; setting it normalises.
    const dReal* q = dBodyGetQuaternion(id);
    const dQuaternion turned = {q[0] + h / 2 * (-w.x() * q[1] - w.y() * q[2] - w.z() * q[3]),
                                q[1] + h / 2 * (w.x() * q[0] + w.y() * q[3] - w.z() * q[2]),
                                q[2] + h / 2 * (-w.x() * q[3] + w.y() * q[0] + w.z() * q[1]),
                                q[3] + h / 2 * (w.x() * q[2] - w.y() * q[1] + w.z() * q[0])};
    dBodySetQuaternion(id, turned);
    if (!dBodyIsEnabled(id)) dBodyEnable(id);
  }
}

}  // namespace plumbline::simulation::ode
