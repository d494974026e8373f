#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/replay/Triple.h"
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
  Mat3 rotation(int link) const { return matrixOf(place(link).R); }
  Vec3 origin(int link) const { return vectorOf(place(link).p); }
  /// Velocity of a link's point given relative to the base's origin, world axes [m/s].
  Vec3 velocityAt(int link, const Vec3& point) const;
  Vec3 angularVelocity(int link) const { return vectorOf(place(link).w); }
  /// Acceleration minus gravity (specific force) of a link's point for the joints' accelerations dv.
  Vec3 specificForceAt(int link, const Vec3& point, const double* dv) const;
  /// Adds J^T f of a force at a link's point (world axes, relative to the base's origin) to tau.
  void addForce(int link, const Vec3& point, const Vec3& force, Eigen::VectorXd& tau) const;
  /// Rows of J for that point: 3 x size().
  void jacobian(int link, const Vec3& point, Eigen::Ref<Eigen::MatrixXd> J) const;

private:
  struct Place {
    TripleMatrix R;
    Triple p;       ///< of the link's origin
    Triple w, u;    ///< velocity: angular, and linear of the point at O
    Triple aw, au;  ///< acceleration of the bias, minus gravity
  };
  struct Body {  // in the link's frame
    double m = 0;
    Triple com;
    TripleMatrix I;  ///< about the centre of mass
  };
  struct Inertia {  // about O, world axes
    double m = 0;
    Triple h;  ///< m times centre of mass
    TripleMatrix I;
  };
  struct Force {  // and moment about O
    Triple f, n;
  };
  struct Node {
    enum class Motion { aboutX, aboutY, aboutZ, aboutAxis, alongAxis };
    int link = 0, parent = -1;  ///< parent: index into nodes, -1: the base
    Motion motion = Motion::aboutZ;
    double sense = 1;             ///< -1: the axis is the negative x, y or z
    double cosine = 1, sine = 0;  ///< of the position
    bool turned = false;
    TripleMatrix R0;
    Triple origin, axis;
    Triple sw, su;  ///< joint's motion: angular, and linear at O
    Place place;
    Body body;
    Inertia composite;
    Force force;
  };
  const Place& place(int link) const;
  static void move(Node& node, const Place& parent, double q, double rate);
  static void take(const Body& body, const Place& here, Inertia& inertia, Force& force);

  std::vector<int> chosen_;
  int offset_ = 0;
  Vec3 gravity_;
  std::vector<Node> nodes_;
  std::vector<int> nodeOfLink_;
  Place base_;
  Body baseBody_;
  Inertia baseComposite_;
  Force baseForce_;
  Eigen::MatrixXd M_;
  Eigen::VectorXd biasForce_;
};

}  // namespace plumbline::gap
