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
    : spec_(assembly), stepsToSleep_(idleSteps) {
  checkAssembly(spec_);
  hingeOfBody_.assign(spec_.bodies.size(), -1);
  for (std::size_t i = 0; i < spec_.hinges.size(); ++i)
    hingeOfBody_[at(spec_.hinges[i].child)] = static_cast<int>(i);
  motorVelocities_.assign(spec_.hinges.size(), 0);
  for (const BodySpec& each : spec_.bodies) principalAxes_.push_back(principalAxesOf(each.inertia));
  addLinks();
  for (std::size_t i = 0; i < spec_.bodies.size(); ++i)
    if (spec_.bodies[i].shape) addCollider(static_cast<int>(i));
  rowSet_ = std::make_unique<BulletRows>(*body_);
  AssemblyState start;
  start.root.pose = T_world_root * spec_.bodies[0].T_root_body;
  start.angle.assign(spec_.hinges.size(), 0);
  start.rate = start.angle;
  setState(start);
}

void BulletAssembly::addLinks() {
  const auto diagonal = [this](std::size_t i) {
    const Mat3& axes = principalAxes_[i];
    return fromVec3((axes.transpose() * spec_.bodies[i].inertia * axes).diagonal());
  };
  const auto linkPose = [this](int i) {
    Pose3 pose = spec_.bodies[at(i)].T_root_body;
    pose.linear() = pose.linear() * principalAxes_[at(i)];
    return pose;
  };
  const int links = static_cast<int>(spec_.bodies.size()) - 1;
  body_ = std::make_unique<btMultiBody>(links, spec_.bodies[0].mass, diagonal(0), false, false);
  for (int i = 1; i <= links; ++i) {
    const HingeSpec& hinge = spec_.hinges[at(hingeOfBody_[at(i)])];
    const Pose3 own = linkPose(i), parent = linkPose(hinge.parent);
    body_->setupRevolute(i - 1, spec_.bodies[at(i)].mass, diagonal(at(i)), hinge.parent - 1,
                         fromMat3(own.linear().transpose() * parent.linear()),
                         fromVec3(own.linear().transpose() * hinge.axis),
                         fromVec3(parent.linear().transpose() * (hinge.anchor - parent.translation())),
                         fromVec3(own.linear().transpose() * (own.translation() - hinge.anchor)), true);
  }
  body_->finalizeMultiDof();
  body_->setLinearDamping(0);
  body_->setAngularDamping(0);
  body_->setMaxCoordinateVelocity(1e6);
}

void BulletAssembly::addCollider(int index) {
  const BodySpec& owner = spec_.bodies[at(index)];
  Collider collider;
  collider.spec = *owner.shape;
  collider.shape = makeShape(*owner.shape);
  collider.object = std::make_unique<btCollisionObject>();
  collider.object->setCollisionShape(collider.shape.get());
  collider.T_body_shape.linear() = principalAxes_[at(index)].transpose();
  collider.T_body_shape = collider.T_body_shape * owner.shape->T_link_shape;
  collider.index = index;
  for (int up = index; hingeOfBody_[at(up)] >= 0 && collider.neighbour < 0;) {
    up = spec_.hinges[at(hingeOfBody_[at(up)])].parent;
    if (spec_.bodies[at(up)].shape) collider.neighbour = up;
  }
  collider.radius = boundingRadius(*owner.shape);
  collider.material = owner.material;
  colliderList_.push_back(std::move(collider));
}

Eigen::AlignedBox3d BulletAssembly::bounds() const {
  Eigen::AlignedBox3d box;
  for (const Collider& collider : colliderList_) {
    box.extend(Vec3(collider.centre.array() - collider.radius));
    box.extend(Vec3(collider.centre.array() + collider.radius));
  }
  return box;
}

BodyState BulletAssembly::bodyState(int index) const {
  BodyState state = states_.at(at(index));
  state.pose.linear() = state.pose.linear() * principalAxes_[at(index)].transpose();
  return state;
}

double BulletAssembly::hingeAngle(int hinge) const { return body_->getJointPos(linkOfHinge(hinge)); }

AssemblyState BulletAssembly::state() const {
  AssemblyState state;
  state.root = bodyState(0);
  for (int i = 0; i < static_cast<int>(spec_.hinges.size()); ++i) {
    state.angle.push_back(body_->getJointPos(linkOfHinge(i)));
    state.rate.push_back(body_->getJointVel(linkOfHinge(i)));
  }
  return state;
}

void BulletAssembly::setState(const AssemblyState& state) {
  checkSize(state);
  Pose3 pose = state.root.pose;
  pose.linear() = pose.linear() * principalAxes_[0];
  body_->setBaseWorldTransform(fromPose3(pose));
  for (int i = 0; i < static_cast<int>(spec_.hinges.size()); ++i)
    body_->setJointPos(linkOfHinge(i), state.angle[at(i)]);
  setVelocities(state);
  wake();
}

void BulletAssembly::setVelocities(const AssemblyState& state) {
  checkSize(state);
  body_->setBaseVel(fromVec3(state.root.linearVelocity));
  body_->setBaseOmega(fromVec3(state.root.angularVelocity));
  for (int i = 0; i < static_cast<int>(spec_.hinges.size()); ++i)
    body_->setJointVel(linkOfHinge(i), state.rate[at(i)]);
  refresh();
}

void BulletAssembly::checkSize(const AssemblyState& state) const {
  if (state.angle.size() != spec_.hinges.size() || state.rate.size() != spec_.hinges.size())
    throw std::invalid_argument("physics: a state needs an angle and a rate for each hinge");
}

void BulletAssembly::moveRigidly(const Pose3& T_world_root) {
  Pose3 pose = T_world_root;
  pose.linear() = pose.linear() * principalAxes_[0];
  body_->setBaseWorldTransform(fromPose3(pose));
  body_->clearVelocities();
  refresh();
}

void BulletAssembly::wake() {
  asleep_ = false;
  stepsToSleep_ = idleSteps;
}

void BulletAssembly::updateSleep(bool touching) {
  if (asleep_ || (spec_.hinges.empty() && !touching)) return;
  bool idle = true;
  for (const BodyState& each : states_)
    idle = idle && each.linearVelocity.squaredNorm() <= idleSpeed * idleSpeed &&
           each.angularVelocity.squaredNorm() <= idleSpeed * idleSpeed;
  stepsToSleep_ = idle ? stepsToSleep_ - 1 : idleSteps;
  if (stepsToSleep_ > 0) return;
  asleep_ = true;
  body_->clearVelocities();
  refresh();
}

/// -1 at or beyond the lower stop, 1 the upper one, 0 between.
int BulletAssembly::stopOf(int hinge) const {
  const double angle = hingeAngle(hinge);
  const HingeSpec& limits = spec_.hinges[at(hinge)];
  return angle <= limits.lower ? -1 : angle >= limits.upper ? 1 : 0;
}

void BulletAssembly::begin(const PhysicsConfig& config) {
  asleep_ = false;
  rowSet_->reset();
  rates_.clear();
  for (int i = 0; i < static_cast<int>(spec_.hinges.size()); ++i)
    rates_.push_back(body_->getJointVel(linkOfHinge(i)));
  body_->clearForcesAndTorques();
  for (int i = 0; i < static_cast<int>(spec_.bodies.size()); ++i) {
    const BodySpec& each = spec_.bodies[at(i)];
    const BodyState& moving = states_[at(i)];
    const btVector3 force =
        fromVec3(Vec3(each.mass * config.gravity - each.linearDrag * moving.linearVelocity));
    const btVector3 torque =
        fromVec3(dragTorque(each, moving.pose.linear(), moving.angularVelocity, config.stepSeconds));
    if (i == 0) {
      body_->addBaseForce(force);
      body_->addBaseTorque(torque);
    } else {
      body_->addLinkForce(i - 1, force);
      body_->addLinkTorque(i - 1, torque);
    }
  }
  // At a stop the league's motor is a torque: all it has towards the stop, or a little of it away from it.
  for (int i = 0; i < static_cast<int>(spec_.hinges.size()); ++i) {
    const int stop = stopOf(i);
    if (stop == 0) continue;
    const HingeSpec& hinge = spec_.hinges[at(i)];
    const double speed = motorVelocities_[at(i)];
    double torque = speed > 0 || (speed == 0 && stop > 0) ? hinge.maxTorque : -hinge.maxTorque;
    if (speed * stop < 0) torque *= hinge.fudgeFactor;
    body_->addJointTorque(linkOfHinge(i), torque);
  }
  body_->computeAccelerationsArticulatedBodyAlgorithmMultiDof(config.stepSeconds, scratchR_, scratchV_,
                                                              scratchM_, false, false, false);
}

int BulletAssembly::addPointRow(int index, const Vec3& point, const Vec3& direction) {
  return rowSet_->addPoint(index - 1, states_[at(index)].pose.translation(), point, direction);
}

const std::vector<BulletAssembly::HingeRow>& BulletAssembly::addHingeRows(const PhysicsConfig& config) {
  const double h = config.stepSeconds;
  hingeRows_.clear();
  for (int i = 0; i < static_cast<int>(spec_.hinges.size()); ++i) {
    const HingeSpec& hinge = spec_.hinges[at(i)];
    const int stop = stopOf(i);
    if (stop == 0 && !(hinge.maxTorque > 0)) continue;
    HingeRow row;
    row.hinge = i;
    row.stop = stop != 0;
    row.local = rowSet_->addJoint(6 + body_->getLink(linkOfHinge(i)).m_dofOffset, 1);
    if (!row.stop) {
      row.wanted = motorVelocities_[at(i)];
      row.compliance = hinge.cfm / h;
      row.lower = -infinity;
      row.upper = infinity;
    } else {
      const double beyond = hingeAngle(i) - (stop < 0 ? hinge.lower : hinge.upper);
      row.wanted = -hinge.stopErp / h * beyond;
      row.compliance = hinge.stopCfm / h;
      row.lower = stop < 0 ? 0 : -infinity;
      row.upper = stop < 0 ? infinity : 0;
      const double rebound = -hinge.stopBounce * rates_[at(i)];
      if (rebound * stop < row.wanted * stop && rebound * stop < 0) row.wanted = rebound;
    }
    hingeRows_.push_back(row);
  }
  return hingeRows_;
}

void BulletAssembly::finish(const PhysicsConfig& config) {
  body_->stepPositionsMultiDof(config.stepSeconds);
  refresh();
}

/// Poses and velocities of all bodies and colliders from the coordinates.
void BulletAssembly::refresh() {
  const int links = body_->getNumLinks();
  body_->forwardKinematics(scratchQ_, scratchV_);
  localVelocities_.resize(2 * links + 2);
  body_->compTreeLinkVelocities(&localVelocities_[0], &localVelocities_[links + 1]);
  states_.resize(at(links + 1));
  for (int i = 0; i <= links; ++i) {
    BodyState& state = states_[at(i)];
    state.pose =
        toPose3(i == 0 ? body_->getBaseWorldTransform() : body_->getLink(i - 1).m_cachedWorldTransform);
    state.angularVelocity = state.pose.linear() * toVec3(localVelocities_[i]);
    state.linearVelocity = state.pose.linear() * toVec3(localVelocities_[links + 1 + i]);
  }
  for (Collider& collider : colliderList_) {
    const Pose3 pose = states_[at(collider.index)].pose * collider.T_body_shape;
    collider.centre = pose.translation();
    collider.object->setWorldTransform(fromPose3(pose));
  }
}

}  // namespace plumbline::simulation::bullet
