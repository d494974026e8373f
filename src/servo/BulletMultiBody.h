#pragma once
#include <memory>
#include <vector>

#include "robot/Mechanism.h"
#include "simulation/physics/BodyState.h"
#include "simulation/physics/bullet/BulletRows.h"
#include "simulation/physics/bullet/BulletTypes.h"

namespace plumbline::servo {

/// A Mechanism as one btMultiBody of Bullet's: link i of the mechanism is Bullet's link i-1, whose frame is
/// at the centre of mass in the principal axes; joint i is Bullet's joint i.
class BulletMultiBody {
public:
  BulletMultiBody(const Mechanism& mechanism, bool fixedBase);

  void place(const Pose3& T_world_base, const std::vector<double>& q);
  double position(int joint) const { return body_->getJointPos(joint); }
  double velocity(int joint) const { return body_->getJointVel(joint); }
  /// Of a link's frame; the velocity is that of the frame's origin, world axes.
  const simulation::BodyState& link(int index) const { return states_.at(static_cast<std::size_t>(index)); }

  /// A force at a point for the step to come, world.
  void addForce(int link, const Vec3& force, const Vec3& point);
  /// A torque along a joint for the step to come.
  void addTorque(int joint, double torque) { body_->addJointTorque(joint, torque); }
  /// Moves on freely under gravity and forces for h [s]; then rows are gathered.
  void begin(const Vec3& gravity, double h);
  simulation::bullet::BulletRows& rows() { return rowSet_; }
  int addPointRow(int link, const Vec3& point, const Vec3& direction) {
    return rowSet_.addPoint(link - 1, comState(link).pose.translation(), point, direction);
  }
  /// Row along a joint, in the coordinates of rows().
  int addJointRow(int joint) { return rowSet_.addJoint(coordinate(joint), 1); }
  int addDriveRow(int joint, int driver, double ratio) {
    return rowSet_.addJointPair(coordinate(joint), coordinate(driver), ratio);
  }
  /// Takes the rows' impulses and moves on by the new velocities.
  void finish(const Eigen::VectorXd& impulses, double h);

private:
  const simulation::BodyState& comState(int link) const { return comStates_[static_cast<std::size_t>(link)]; }
  int coordinate(int joint) const { return 6 + body_->getLink(joint).m_dofOffset; }
  void refresh();

  std::vector<double> masses_;
  std::vector<Pose3> T_link_com_;  ///< centre of mass and principal axes
  std::unique_ptr<btMultiBody> body_;
  simulation::bullet::BulletRows rowSet_;
  std::vector<simulation::BodyState> states_, comStates_;
  btAlignedObjectArray<btScalar> scratchR_;
  btAlignedObjectArray<btVector3> scratchV_, localVelocities_;
  btAlignedObjectArray<btMatrix3x3> scratchM_;
  btAlignedObjectArray<btQuaternion> scratchQ_;
};

}  // namespace plumbline::servo
