#pragma once
#include <memory>
#include <vector>

#include "simulation/physics/Physics.h"
#include "simulation/physics/bullet/BulletRows.h"
#include "simulation/physics/bullet/BulletTypes.h"

namespace plumbline::simulation::bullet {

/// Makes a shape of Bullet's. Error: std::invalid_argument for a size that is not positive.
std::unique_ptr<btCollisionShape> makeShape(const Shape& shape);

/// An assembly as one btMultiBody with colliders; owns them. Body i is link i-1 of Bullet's, whose frames
/// have the bodies' principal axes.
class BulletAssembly {
public:
  BulletAssembly(const Assembly& assembly, const Pose3& T_world_root);

  /// A body that can touch something.
  struct Collider {
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btCollisionObject> object;
    Shape spec;
    Pose3 T_body_shape = Pose3::Identity();
    int index = 0;       ///< of the body
    int neighbour = -1;  ///< nearest body up the tree that has a collider, -1: none
    double radius = 0;   ///< of the sphere that holds the shape
    Material material = 0;
    Vec3 centre = Vec3::Zero();  ///< world
  };

  const std::vector<Collider>& colliders() const { return colliderList_; }
  bool selfCollision() const { return spec_.selfCollision; }
  /// Box around all colliders.
  Eigen::AlignedBox3d bounds() const;

  BodyState bodyState(int body) const;
  AssemblyState state() const;
  void setState(const AssemblyState& state);
  void setVelocities(const AssemblyState& state);
  void moveRigidly(const Pose3& T_world_root);
  double hingeAngle(int hinge) const;
  void setMotor(int hinge, double velocity) {
    motorVelocities_.at(static_cast<std::size_t>(hinge)) = velocity;
  }

  void wake();
  bool asleep() const { return asleep_; }
  /// Slow for ten steps, all bodies: stops and sleeps. A free body in the air does not sleep.
  void updateSleep(bool touching);

  /// Moves on freely: gravity, drag and the torque of motors at a stop. Then rows are gathered.
  void begin(const PhysicsConfig& config);
  BulletRows& rows() { return *rowSet_; }
  const BulletRows& rows() const { return *rowSet_; }
  /// A row for an impulse on a body at a point along a direction (world); its local index.
  int addPointRow(int body, const Vec3& point, const Vec3& direction);
  /// Rows of motors, then of stops, as they are in this step.
  struct HingeRow {
    int local = 0, hinge = 0;
    bool stop = false;
    double wanted = 0, compliance = 0, lower = 0, upper = 0;
  };
  const std::vector<HingeRow>& addHingeRows(const PhysicsConfig& config);
  double maxTorque(int hinge) const { return spec_.hinges[static_cast<std::size_t>(hinge)].maxTorque; }
  void applyImpulses(const Eigen::VectorXd& impulses) { rowSet_->apply(impulses, *body_); }
  /// Moves on by the new velocities.
  void finish(const PhysicsConfig& config);

private:
  void addLinks();
  void addCollider(int body);
  void checkSize(const AssemblyState& state) const;
  int linkOfHinge(int hinge) const { return spec_.hinges.at(static_cast<std::size_t>(hinge)).child - 1; }
  int stopOf(int hinge) const;
  void refresh();

  Assembly spec_;
  std::unique_ptr<btMultiBody> body_;
  std::vector<int> hingeOfBody_;     ///< -1: root
  std::vector<Mat3> principalAxes_;  ///< R_body_link
  std::vector<double> motorVelocities_;
  std::vector<Collider> colliderList_;
  std::vector<BodyState> states_;  ///< of Bullet's link frames
  std::vector<double> rates_;      ///< of the hinges before the step
  std::vector<HingeRow> hingeRows_;
  std::unique_ptr<BulletRows> rowSet_;
  bool asleep_ = false;
  int stepsToSleep_;
  btAlignedObjectArray<btScalar> scratchR_;
  btAlignedObjectArray<btVector3> scratchV_, localVelocities_;
  btAlignedObjectArray<btMatrix3x3> scratchM_;
  btAlignedObjectArray<btQuaternion> scratchQ_;
};

}  // namespace plumbline::simulation::bullet
