#include "servo/BulletMultiBody.h"

#include "math/Index.h"
#include "simulation/physics/bullet/PrincipalAxes.h"

namespace plumbline::servo {

using namespace simulation::bullet;

namespace {

std::vector<Pose3> centresOf(const Mechanism& mechanism) {
  std::vector<Pose3> all;
  for (const Mechanism::Link& link : mechanism.links) {
    Pose3 pose = translation(link.com);
    pose.linear() = principalAxesOf(link.inertia);
    all.push_back(pose);
  }
  return all;
}

std::unique_ptr<btMultiBody> makeBody(const Mechanism& mechanism, const std::vector<Pose3>& centres,
                                      bool fixedBase) {
  const auto inertia = [&](std::size_t i) {
    const Mat3 axes = centres[i].linear();
    return fromVec3((axes.transpose() * mechanism.links[i].inertia * axes).diagonal());
  };
  auto body = std::make_unique<btMultiBody>(mechanism.numJoints(), mechanism.links[0].mass, inertia(0),
                                            fixedBase, false);
  for (int i = 0; i < mechanism.numJoints(); ++i) {
    const Mechanism::Joint& joint = mechanism.joints[at(i)];
    const std::size_t child = at(i + 1);
    const Pose3 T_parent_pivot = centres[at(joint.parent)].inverse() * joint.T_parent_joint();
    const Mat3 R_child_parent = centres[child].linear().transpose() * T_parent_pivot.linear().transpose();
    const btVector3 axis = fromVec3(centres[child].linear().transpose() * joint.axis);
    const btVector3 toCom = fromVec3(centres[child].linear().transpose() * centres[child].translation());
    const btVector3 toPivot = fromVec3(T_parent_pivot.translation());
    const double mass = mechanism.links[child].mass;
    if (joint.type == Mechanism::Joint::Type::prismatic)
      body->setupPrismatic(i, mass, inertia(child), joint.parent - 1, fromMat3(R_child_parent), axis, toPivot,
                           toCom, true);
    else
      body->setupRevolute(i, mass, inertia(child), joint.parent - 1, fromMat3(R_child_parent), axis, toPivot,
                          toCom, true);
  }
  body->finalizeMultiDof();
  body->setLinearDamping(0);
  body->setAngularDamping(0);
  body->setMaxCoordinateVelocity(1e6);
  return body;
}

}  // namespace

BulletMultiBody::BulletMultiBody(const Mechanism& mechanism, bool fixedBase)
    : T_link_com_(centresOf(mechanism)), body_(makeBody(mechanism, T_link_com_, fixedBase)), rowSet_(*body_) {
  for (const Mechanism::Link& link : mechanism.links) masses_.push_back(link.mass);
  place(Pose3::Identity(), std::vector<double>(at(mechanism.numJoints()), 0));
}

void BulletMultiBody::place(const Pose3& T_world_base, const std::vector<double>& q) {
  body_->setBaseWorldTransform(fromPose3(T_world_base * T_link_com_[0]));
  for (std::size_t i = 0; i < q.size(); ++i) body_->setJointPos(static_cast<int>(i), q[i]);
  body_->clearVelocities();
  body_->clearForcesAndTorques();
  refresh();
}

void BulletMultiBody::addForce(int link, const Vec3& force, const Vec3& point) {
  const Vec3 torque = (point - comState(link).pose.translation()).cross(force);
  if (link == 0) {
    body_->addBaseForce(fromVec3(force));
    body_->addBaseTorque(fromVec3(torque));
  } else {
    body_->addLinkForce(link - 1, fromVec3(force));
    body_->addLinkTorque(link - 1, fromVec3(torque));
  }
}

void BulletMultiBody::begin(const Vec3& gravity, double h) {
  rowSet_.reset();
  for (std::size_t i = 0; i < masses_.size(); ++i)
    addForce(static_cast<int>(i), masses_[i] * gravity, comStates_[i].pose.translation());
  body_->computeAccelerationsArticulatedBodyAlgorithmMultiDof(h, scratchR_, scratchV_, scratchM_, false,
                                                              false, false);
}

void BulletMultiBody::finish(const Eigen::VectorXd& impulses, double h) {
  rowSet_.apply(impulses, *body_);
  body_->stepPositionsMultiDof(h);
  body_->clearForcesAndTorques();
  refresh();
}

void BulletMultiBody::refresh() {
  const int links = body_->getNumLinks();
  body_->forwardKinematics(scratchQ_, scratchV_);
  localVelocities_.resize(2 * links + 2);
  body_->compTreeLinkVelocities(&localVelocities_[0], &localVelocities_[links + 1]);
  states_.resize(at(links + 1));
  comStates_.resize(at(links + 1));
  for (int i = 0; i <= links; ++i) {
    simulation::BodyState &com = comStates_[at(i)], &frame = states_[at(i)];
    com.pose =
        toPose3(i == 0 ? body_->getBaseWorldTransform() : body_->getLink(i - 1).m_cachedWorldTransform);
    com.angularVelocity = com.pose.linear() * toVec3(localVelocities_[i]);
    com.linearVelocity = com.pose.linear() * toVec3(localVelocities_[links + 1 + i]);
    frame.pose = com.pose * T_link_com_[at(i)].inverse();
    frame.angularVelocity = com.angularVelocity;
    frame.linearVelocity = com.linearVelocity +
                           com.angularVelocity.cross(Vec3(frame.pose.translation() - com.pose.translation()));
  }
}

}  // namespace plumbline::servo
