#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/replay/Plant.h"
#include "gap/replay/SmallFactor.h"
#include "gap/replay/TreeDynamics.h"

namespace plumbline::gap {

/// Contacts of the corners of the soles with the ground: unilateral springs along the normal, Coulomb
/// friction along the surface. Projected Gauss-Seidel on the step's own equation finds the impulses, with a
/// warm start.
class Contacts {
public:
  Contacts(const Plant& plant, const TreeDynamics& tree);

  /// Depth and Jacobian of every corner for the tree's present pose. base: position of the base's origin.
  void update(const TreeDynamics& tree, const Vec3& base);
  /// Computes how forces at the corners change the step's new velocity: scale * A^-1 J^T f. factor: of its
  /// matrix A.
  void prepare(const SmallFactor& factor, double scale);
  /// Finds forces so that the new velocity of a step of h seconds obeys the bounds, starting from the forces
  /// of the last step, and adds their effect to it. Call prepare() first.
  void solve(double h, Eigen::VectorXd& velocity);

  /// Force of the ground on a foot's sole: normal force [N] and its point [m], in the foot's link frame.
  struct FootForce {
    double normal = 0;
    Vec2 centre = Vec2::Zero();
  };
  FootForce footForce(int foot, const TreeDynamics& tree) const;

private:
  struct Corner {
    int foot = 0, link = 0;
    Vec3 local = Vec3::Zero(), point = Vec3::Zero();
    double depth = 0;
    bool active = false;
    Vec3 force = Vec3::Zero();  ///< ground's axes: two along the surface, normal last
  };
  std::vector<Corner> corners_;
  Mat3 ground_ = Mat3::Identity();  ///< columns: two along the surface, normal
  double friction_, stiffness_, damping_;
  int dimension_ = 0;
  bool touched_ = false;
  double scale_ = 0;
  Eigen::MatrixXd J_, W_;
  SmallFactor::Rows solved_;
};

}  // namespace plumbline::gap
