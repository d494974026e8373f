#include "simulation/physics/bullet/BulletAssembly.h"

#include <limits>
#include <stdexcept>

#include "math/Index.h"
#include "simulation/physics/AssemblyCheck.h"
#include "simulation/physics/Drag.h"
#include "simulation/physics/bullet/PrincipalAxes.h"

namespace plumbline::simulation::bullet {

namespace {

// As the league's engine has it.
constexpr int idleSteps = 10;
constexpr double idleSpeed = 0.01;  // [m/s, rad/s]

}  // namespace

std::unique_ptr<btCollisionShape> makeShape(const Shape& shape) {
  checkShape(shape);
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return std::make_unique<btSphereShape>(shape.size.x());
    case Shape::Kind::capsule:
      return std::make_unique<btCapsuleShapeZ>(shape.size.x(), shape.size.z());
    case Shape::Kind::box:
      break;
  }
  return std::make_unique<btBoxShape>(fromVec3(shape.size / 2));
}

BulletAssembly::BulletAssembly(const Assembly& assembly, const Pose3& T_world_root)
    : spec(assembly), stepsToSleep(idleSteps) {
  checkAssembly(spec);
  hingeOfBody.assign(spec.bodies.size(), -1);
  for (std::size_t i = 0; i < spec.hinges.size(); ++i)
    hingeOfBody[at(spec.hinges[i].child)] = static_cast<int>(i);
  motorVelocities.assign(spec.hinges.size(), 0);
  for (const BodySpec& each : spec.bodies) principalAxes.push_back(principalAxesOf(each.inertia));
  addLinks();
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    if (spec.bodies[i].shape) addCollider(static_cast<int>(i));
  rowSet = std::make_unique<BulletRows>(*body);
  AssemblyState start;
  start.root.pose = T_world_root * spec.bodies[0].T_root_body;
  start.angle.assign(spec.hinges.size(), 0);
  start.rate = start.angle;
  setState(start);
}

void BulletAssembly::addLinks() {
  const auto diagonal = [this](std::size_t i) {
    const Mat3& axes = principalAxes[i];
    return fromVec3((axes.transpose() * spec.bodies[i].inertia * axes).diagonal());
  };
  const auto linkPose = [this](int i) {
    Pose3 pose = spec.bodies[at(i)].T_root_body;
    pose.linear() = pose.linear() * principalAxes[at(i)];
    return pose;
  };
  const int links = static_cast<int>(spec.bodies.size()) - 1;
  body = std::make_unique<btMultiBody>(links, spec.bodies[0].mass, diagonal(0), false, false);
  for (int i = 1; i <= links; ++i) {
    const HingeSpec& hinge = spec.hinges[at(hingeOfBody[at(i)])];
    const Pose3 own = linkPose(i), parent = linkPose(hinge.parent);
    body->setupRevolute(i - 1, spec.bodies[at(i)].mass, diagonal(at(i)), hinge.parent - 1,
                        fromMat3(own.linear().transpose() * parent.linear()),
                        fromVec3(own.linear().transpose() * hinge.axis),
                        fromVec3(parent.linear().transpose() * (hinge.anchor - parent.translation())),
                        fromVec3(own.linear().transpose() * (own.translation() - hinge.anchor)), true);
  }
  body->finalizeMultiDof();
  body->setLinearDamping(0);
  body->setAngularDamping(0);
  body->setMaxCoordinateVelocity(1e6);
}

void BulletAssembly::addCollider(int index) {
  const BodySpec& owner = spec.bodies[at(index)];
  Collider collider;
  collider.spec = *owner.shape;
  collider.shape = makeShape(*owner.shape);
  collider.object = std::make_unique<btCollisionObject>();
  collider.object->setCollisionShape(collider.shape.get());
  collider.T_body_shape.linear() = principalAxes[at(index)].transpose();
  collider.T_body_shape = collider.T_body_shape * owner.shape->T_link_shape;
  collider.index = index;
  for (int up = index; hingeOfBody[at(up)] >= 0 && collider.neighbour < 0;) {
    up = spec.hinges[at(hingeOfBody[at(up)])].parent;
    if (spec.bodies[at(up)].shape) collider.neighbour = up;
  }
  collider.radius = boundingRadius(*owner.shape);
  collider.material = owner.material;
  colliderList.push_back(std::move(collider));
}

Eigen::AlignedBox3d BulletAssembly::bounds() const {
  Eigen::AlignedBox3d box;
  for (const Collider& collider : colliderList) {
    box.extend(Vec3(collider.centre.array() - collider.radius));
    box.extend(Vec3(collider.centre.array() + collider.radius));
  }
  return box;
}

BodyState BulletAssembly::bodyState(int index) const {
  BodyState state = states.at(at(index));
  state.pose.linear() = state.pose.linear() * principalAxes[at(index)].transpose();
  return state;
}

double BulletAssembly::hingeAngle(int hinge) const { return body->getJointPos(linkOfHinge(hinge)); }

AssemblyState BulletAssembly::state() const {
  AssemblyState state;
  state.root = bodyState(0);
  for (int i = 0; i < static_cast<int>(spec.hinges.size()); ++i) {
    state.angle.push_back(body->getJointPos(linkOfHinge(i)));
    state.rate.push_back(body->getJointVel(linkOfHinge(i)));
  }
  return state;
}

void BulletAssembly::setState(const AssemblyState& state) {
  checkSize(state);
  Pose3 pose = state.root.pose;
  pose.linear() = pose.linear() * principalAxes[0];
  body->setBaseWorldTransform(fromPose3(pose));
  for (int i = 0; i < static_cast<int>(spec.hinges.size()); ++i)
    body->setJointPos(linkOfHinge(i), state.angle[at(i)]);
  setVelocities(state);
  wake();
}

void BulletAssembly::setVelocities(const AssemblyState& state) {
  checkSize(state);
  body->setBaseVel(fromVec3(state.root.linearVelocity));
  body->setBaseOmega(fromVec3(state.root.angularVelocity));
  for (int i = 0; i < static_cast<int>(spec.hinges.size()); ++i)
    body->setJointVel(linkOfHinge(i), state.rate[at(i)]);
  refresh();
}

void BulletAssembly::checkSize(const AssemblyState& state) const {
  if (state.angle.size() != spec.hinges.size() || state.rate.size() != spec.hinges.size())
    throw std::invalid_argument("physics: a state needs an angle and a rate for each hinge");
}

void BulletAssembly::moveRigidly(const Pose3& T_world_root) {
  Pose3 pose = T_world_root;
  pose.linear() = pose.linear() * principalAxes[0];
  body->setBaseWorldTransform(fromPose3(pose));
  body->clearVelocities();
  refresh();
}

void BulletAssembly::wake() {
  asleep_ = false;
  stepsToSleep = idleSteps;
}

void BulletAssembly::doze(bool touching) {
  if (asleep_ || (spec.hinges.empty() && !touching)) return;
  bool idle = true;
  for (const BodyState& each : states)
    idle = idle && each.linearVelocity.squaredNorm() <= idleSpeed * idleSpeed &&
           each.angularVelocity.squaredNorm() <= idleSpeed * idleSpeed;
  stepsToSleep = idle ? stepsToSleep - 1 : idleSteps;
  if (stepsToSleep > 0) return;
  asleep_ = true;
  body->clearVelocities();
  refresh();
}

/// -1 at or beyond the lower stop, 1 the upper one, 0 between.
int BulletAssembly::stopOf(int hinge) const {
  const double angle = hingeAngle(hinge);
  const HingeSpec& limits = spec.hinges[at(hinge)];
  return angle <= limits.lower ? -1 : angle >= limits.upper ? 1 : 0;
}

void BulletAssembly::begin(const PhysicsConfig& config) {
  asleep_ = false;
  rowSet->reset();
  rates.clear();
  for (int i = 0; i < static_cast<int>(spec.hinges.size()); ++i)
    rates.push_back(body->getJointVel(linkOfHinge(i)));
  body->clearForcesAndTorques();
  for (int i = 0; i < static_cast<int>(spec.bodies.size()); ++i) {
    const BodySpec& each = spec.bodies[at(i)];
    const BodyState& moving = states[at(i)];
    const btVector3 force =
        fromVec3(Vec3(each.mass * config.gravity - each.linearDrag * moving.linearVelocity));
    const btVector3 torque =
        fromVec3(dragTorque(each, moving.pose.linear(), moving.angularVelocity, config.stepSeconds));
    if (i == 0) {
      body->addBaseForce(force);
      body->addBaseTorque(torque);
    } else {
      body->addLinkForce(i - 1, force);
      body->addLinkTorque(i - 1, torque);
    }
  }
  // At a stop the league's motor is a torque: all it has towards the stop, or a little of it away from it.
  for (int i = 0; i < static_cast<int>(spec.hinges.size()); ++i) {
    const int stop = stopOf(i);
    if (stop == 0) continue;
    const HingeSpec& hinge = spec.hinges[at(i)];
    const double speed = motorVelocities[at(i)];
    double torque = speed > 0 || (speed == 0 && stop > 0) ? hinge.maxTorque : -hinge.maxTorque;
    if (speed * stop < 0) torque *= hinge.fudgeFactor;
    body->addJointTorque(linkOfHinge(i), torque);
  }
  body->computeAccelerationsArticulatedBodyAlgorithmMultiDof(config.stepSeconds, scratchR, scratchV, scratchM,
                                                             false, false, false);
}

int BulletAssembly::addPointRow(int index, const Vec3& point, const Vec3& direction) {
  return rowSet->addPoint(index - 1, states[at(index)].pose.translation(), point, direction);
}

const std::vector<BulletAssembly::HingeRow>& BulletAssembly::addHingeRows(const PhysicsConfig& config) {
  const double h = config.stepSeconds;
  hingeRows.clear();
  for (int i = 0; i < static_cast<int>(spec.hinges.size()); ++i) {
    const HingeSpec& hinge = spec.hinges[at(i)];
    const int stop = stopOf(i);
    if (stop == 0 && !(hinge.maxTorque > 0)) continue;
    HingeRow row;
    row.hinge = i;
    row.stop = stop != 0;
    row.local = rowSet->addJoint(6 + body->getLink(linkOfHinge(i)).m_dofOffset, 1);
    if (!row.stop) {
      row.wanted = motorVelocities[at(i)];
      row.compliance = hinge.cfm / h;
      row.lower = -infinity;
      row.upper = infinity;
    } else {
      const double beyond = hingeAngle(i) - (stop < 0 ? hinge.lower : hinge.upper);
      row.wanted = -hinge.stopErp / h * beyond;
      row.compliance = hinge.stopCfm / h;
      row.lower = stop < 0 ? 0 : -infinity;
      row.upper = stop < 0 ? infinity : 0;
      const double rebound = -hinge.stopBounce * rates[at(i)];
      if (rebound * stop < row.wanted * stop && rebound * stop < 0) row.wanted = rebound;
    }
    hingeRows.push_back(row);
  }
  return hingeRows;
}

void BulletAssembly::finish(const PhysicsConfig& config) {
  body->stepPositionsMultiDof(config.stepSeconds);
  refresh();
}

/// Poses and velocities of all bodies and colliders from the coordinates.
void BulletAssembly::refresh() {
  const int links = body->getNumLinks();
  body->forwardKinematics(scratchQ, scratchV);
  localVelocities.resize(2 * links + 2);
  body->compTreeLinkVelocities(&localVelocities[0], &localVelocities[links + 1]);
  states.resize(at(links + 1));
  for (int i = 0; i <= links; ++i) {
    BodyState& state = states[at(i)];
    state.pose =
        toPose3(i == 0 ? body->getBaseWorldTransform() : body->getLink(i - 1).m_cachedWorldTransform);
    state.angularVelocity = state.pose.linear() * toVec3(localVelocities[i]);
    state.linearVelocity = state.pose.linear() * toVec3(localVelocities[links + 1 + i]);
  }
  for (Collider& collider : colliderList) {
    const Pose3 pose = states[at(collider.index)].pose * collider.T_body_shape;
    collider.centre = pose.translation();
    collider.object->setWorldTransform(fromPose3(pose));
  }
}

}  // namespace plumbline::simulation::bullet
