#pragma once
#include <Eigen/Core>
#include <vector>

#include "math/Types.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Rigid-body dynamics M(q) dv + bias(q, v) = tau of a mechanism, or of some of its chains with a fixed base.
/// M comes from composite inertias, the bias from recursive Newton-Euler (Featherstone, Rigid Body Dynamics
/// Algorithms, 2008, tables 6.2 and 5.1), everything in world axes about the base's origin. Coordinates: with
/// a free base the first six are its linear velocity (world, of the base frame's origin) and its angular
/// velocity (world); then one per chosen joint, in the mechanism's order.
class TreeDynamics {
public:
  using Mat6X = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  /// joints: ascending indices, including those that carry them; empty with a fixed base: nothing moves.
  TreeDynamics(const Mechanism& mechanism, std::vector<int> joints, bool freeBase);

  int size() const { return offset_ + static_cast<int>(nodes_.size()); }
  int baseSize() const { return offset_; }
  const std::vector<int>& joints() const { return chosen_; }

  /// Poses, mass matrix and bias. Only the rotation of the base matters; q: one per chosen joint [rad, m]; v:
  /// size() velocities. Clears the forces at links (addForce).
  void update(const Mat3& R_world_base, const double* q, const double* v);

  const Eigen::MatrixXd& mass() const { return M_; }          ///< symmetric, armature not included
  const Eigen::VectorXd& bias() const { return biasForce_; }  ///< Coriolis and gravity forces

  /// Of a link (mechanism's index) among those that move, or the base: its rotation, and its origin relative
  /// to the base's origin in world axes. Links that do not move are unknown: std::out_of_range.
  const Mat3& rotation(int link) const { return place(link).R; }
  const Vec3& origin(int link) const { return place(link).p; }
  /// Velocity of a link's point given relative to the base's origin, world axes [m/s].
  Vec3 velocityAt(int link, const Vec3& point) const;
  Vec3 angularVelocity(int link) const { return place(link).w; }
  /// Acceleration minus gravity (specific force) of a link's point for the joints' accelerations dv.
  Vec3 specificForceAt(int link, const Vec3& point, const double* dv) const;
  /// Adds J^T f of a force at a link's point (world axes, relative to the base's origin) to tau.
  void addForce(int link, const Vec3& point, const Vec3& force, Eigen::VectorXd& tau) const;
  /// Rows of J for that point: 3 x size().
  void jacobian(int link, const Vec3& point, Eigen::Ref<Eigen::MatrixXd> J) const;

private:
  struct Place {
    Mat3 R = Mat3::Identity();
    Vec3 p = Vec3::Zero();                      ///< of the link's origin
    Vec3 w = Vec3::Zero(), u = Vec3::Zero();    ///< velocity: angular, and linear of the point at O
    Vec3 aw = Vec3::Zero(), au = Vec3::Zero();  ///< acceleration of the bias, minus gravity
  };
  struct Inertia {  // about O, world axes
    double m = 0;
    Vec3 h = Vec3::Zero();  ///< m times centre of mass
    Mat3 I = Mat3::Zero();
  };
  struct Node {
    int link = 0, parent = -1;  ///< parent: index into nodes, -1: the base
    bool prismatic = false, turned = false;
    Mat3 R0 = Mat3::Identity();
    Vec3 origin = Vec3::Zero(), axis = Vec3::Zero();
    Vec3 sw = Vec3::Zero(), su = Vec3::Zero();  ///< joint's motion: angular, and linear at O
    Place place;
    Inertia own, composite;
    Vec3 fu = Vec3::Zero(), fn = Vec3::Zero();  ///< force and moment about O
    double m = 0;
    Vec3 com = Vec3::Zero();
    Mat3 I = Mat3::Zero();
  };
  const Place& place(int link) const;
  static void setInertia(Inertia& inertia, const Place& place, double m, const Vec3& com, const Mat3& I);

  std::vector<int> chosen_;
  int offset_ = 0;
  Vec3 gravity_;
  std::vector<Node> nodes_;
  std::vector<int> nodeOfLink_;
  Place base_;
  Inertia baseOwn_, baseComposite_;
  double baseMass_ = 0;
  Vec3 baseCom_;
  Mat3 baseI_;
  Eigen::MatrixXd M_;
  Eigen::VectorXd biasForce_;
};

}  // namespace plumbline::gap
