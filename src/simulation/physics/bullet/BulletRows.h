#pragma once
#include <Eigen/Core>
#include <vector>

#include "simulation/physics/bullet/BulletTypes.h"
#include "simulation/physics/tree/BoundedSystem.h"

namespace plumbline::simulation::bullet {

/// The rows of a step's equations that reach one btMultiBody: what an impulse of 1 along each does to its
/// coordinates (base's turn and way in world axes, then joints).
class BulletRows {
public:
  explicit BulletRows(const btMultiBody& body);

  /// Forgets which rows are held.
  void releaseAll() { held_.clear(); }
  /// Forgets all rows; the velocities are those before the step.
  void reset();
  /// A row for an impulse on a link of Bullet's (-1: base) at a point along a direction (world); its local
  /// index. `origin`: any point that stays the same for the link throughout the step.
  int addPoint(int link, const Vec3& origin, const Vec3& point, const Vec3& direction);
  /// A row along one joint coordinate.
  int addJoint(int coordinate, double sign);
  /// A row along one joint coordinate against another: first - ratio * second.
  int addJointPair(int first, int second, double ratio);

  /// Place of a local row in the system of its island.
  void place(int row, Eigen::Index global) { places_[static_cast<std::size_t>(row)] = global; }
  /// A row along one joint that has no bounds and so no place: it is eliminated here, as no other body's rows
  /// reach it. Its velocity is wanted with this compliance.
  void hold(int row, double wanted, double compliance);
  /// Adds what the placed rows do to each other, held joints holding, and takes their free velocities from
  /// the right-hand side.
  void addTo(BoundedSystem& system);
  /// Impulses of the held rows, in the order of hold(), for the solution of the system.
  const Eigen::VectorXd& heldImpulses(const Eigen::VectorXd& solution);
  /// Velocity along a row before the step.
  double velocityBefore(int row) const { return jacobians_.col(row).dot(before_); }
  /// Adds the solved impulses, and those of held rows as last asked for, to the multi-body's velocities.
  void apply(const Eigen::VectorXd& impulses, btMultiBody& body) const;

private:
  /// What impulses and angular impulses on a link along the world's axes do: all rows of its contacts are
  /// sums of these six.
  struct Basis {
    int link;
    Eigen::Matrix<double, Eigen::Dynamic, 6> jacobian, response;
  };
  const Basis& basisOf(int link, const Vec3& origin);
  int newRow(int coordinate, double sign);
  double response(int r, int s) const;
  void eliminateHeld(const Eigen::VectorXd& velocity);

  const btMultiBody& body_;
  Eigen::Index size_;
  Eigen::MatrixXd jacobians_, responses_;  ///< a column for each row
  Eigen::VectorXd before_;
  std::vector<Eigen::Index> places_;
  std::vector<int> coordinates_;  ///< of rows along one joint, else -1
  std::vector<double> signs_;
  struct Held {
    int row;
    double wanted, compliance;
  };
  std::vector<Held> held_;
  std::vector<int> placed_;  ///< rows that are not held, while a system is made
  Eigen::MatrixXd factor_,
      across_;                    ///< L of the held rows' own matrix, and L^-1 of what they do to the placed
  Eigen::VectorXd side_, heldX_;  ///< L^-1 of their right-hand side; their impulses
  int count_ = 0;
  std::vector<Basis> bases_;  ///< the first of them are of this step
  std::size_t basesUsed_ = 0;
  btAlignedObjectArray<btScalar> scratchR_;
  btAlignedObjectArray<btVector3> scratchV_;
  btAlignedObjectArray<btMatrix3x3> scratchM_;
};

}  // namespace plumbline::simulation::bullet
