#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "gap/replay/Plant.h"
#include "gap/replay/TreeDynamics.h"

namespace plumbline::gap {

/// The corners of the soles on the ground: unilateral springs along the normal, Coulomb friction along the
/// surface. Impulses are found by projected Gauss-Seidel on the step's own equation, warm-started.
class Contacts {
public:
  Contacts(const Plant& plant, const TreeDynamics& tree);

  /// Depth and Jacobian of every corner for the tree's present pose. base: position of the base's origin.
  void update(const TreeDynamics& tree, const Vec3& base);
  /// What forces at the corners do to the step's new velocity: scale * A^-1 J^T f. factor: of its matrix A.
  void prepare(const Eigen::LLT<Eigen::MatrixXd>& factor, double scale);
  /// Finds forces so that the new velocity of a step of h seconds keeps the bounds, beginning with those of
  /// the last time, and adds their effect to it. Prepared for the step.
  void solve(double h, Eigen::VectorXd& velocity);

  /// Force that the ground puts on a foot along its own sole: normal force [N] and where it acts [m], in the
  /// foot's link frame.
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
  Eigen::MatrixXd J_, solved_, W_;
};

}  // namespace plumbline::gap
