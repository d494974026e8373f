#include "gap/replay/Contacts.h"

#include <algorithm>
#include <cmath>

#include "gap/replay/SolePlate.h"

namespace plumbline::gap {

namespace {

constexpr int sweeps = 15;             // from the forces of the step before: 40 change squares by 0.05 %
constexpr double slipSoftness = 1e-5;  // [m/(s N)]: keeps opposed feet from an infinite strain

}  // namespace

Contacts::Contacts(const Plant& plant, const TreeDynamics& tree)
    : friction_(plant.ground.friction),
      stiffness_(1 / std::max(plant.ground.compliance, 1e-9)),
      dimension_(tree.size()) {
  const double mass = plant.mechanism.totalMass() / 8;
  damping_ = 2 * std::sqrt(stiffness_ * mass);
  ground_ = rotationOfGround(plant.ground);
  for (std::size_t f = 0; f < plant.mechanism.feet.size(); ++f) {
    const auto& foot = plant.mechanism.feet[f];
    for (const Vec3& place : soleCorners(foot)) {
      Corner corner;
      corner.foot = static_cast<int>(f);
      corner.link = foot.link;
      corner.local = place;
      corners_.push_back(corner);
    }
  }
  J_.setZero(static_cast<Eigen::Index>(3 * corners_.size()), dimension_);
}

void Contacts::update(const TreeDynamics& tree, const Vec3& base) {
  touched_ = false;
  Eigen::MatrixXd world(3, tree.size());
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    Corner& corner = corners_[i];
    corner.point = tree.origin(corner.link) + tree.rotation(corner.link) * corner.local;
    corner.depth = -ground_.col(2).dot(base + corner.point);
    corner.active = corner.depth > -0.002;
    if (!corner.active) {
      corner.force.setZero();
      continue;
    }
    touched_ = true;
    tree.jacobian(corner.link, corner.point, world);
    J_.block(static_cast<Eigen::Index>(3 * i), 0, 3, tree.size()).noalias() = ground_.transpose() * world;
  }
}

void Contacts::prepare(const SmallFactor& factor, double scale) {
  if (!touched_) return;
  scale_ = scale;
  solved_.setZero(factor.rows(), J_.rows());
  solved_.topRows(J_.cols()) = J_.transpose();
  factor.solveInPlace(solved_);
  W_.noalias() = J_ * solved_.topRows(J_.cols());
  W_ *= scale_;
}

void Contacts::solve(double h, Eigen::VectorXd& velocity) {
  if (!touched_) return;
  Eigen::VectorXd r = J_ * velocity.head(J_.cols());
  // Implicit spring and damper along the normal: force = k (depth - h v) - d v.
  const double give = 1 / (h * stiffness_ + damping_), pull = h * stiffness_ * give;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (!corners_[i].active) continue;
    const auto at = static_cast<Eigen::Index>(3 * i);
    for (int a = 0; a < 3; ++a) r += W_.col(at + a) * corners_[i].force[a];
  }
  const auto change = [&](Eigen::Index row, double& force, double wanted) {
    const double delta = wanted - force;
    if (delta == 0) return 0.0;
    force = wanted;
    r += W_.col(row) * delta;
    return std::abs(delta);
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double moved = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Corner& corner = corners_[i];
      if (!corner.active) continue;
      const auto at = static_cast<Eigen::Index>(3 * i);
      const double error = r[at + 2] - pull * corner.depth / h + give * corner.force.z();
      moved += change(at + 2, corner.force.z(),
                      std::max(0.0, corner.force.z() - error / (W_(at + 2, at + 2) + give)));
      Vec2 wanted;
      for (int a = 0; a < 2; ++a) {
        wanted[a] = corner.force[a] -
                    (r[at + a] + slipSoftness * corner.force[a]) / (W_(at + a, at + a) + slipSoftness);
      }
      const double most = friction_ * corner.force.z(), norm = wanted.norm();
      if (norm > most) wanted *= norm > 0 ? most / norm : 0;
      for (int a = 0; a < 2; ++a) moved += change(at + a, corner.force[a], wanted[a]);
    }
    if (moved < 1e-4) break;
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (!corners_[i].active) continue;
    velocity.noalias() +=
        solved_.middleCols(static_cast<Eigen::Index>(3 * i), 3) * (corners_[i].force * scale_);
  }
}

Contacts::FootForce Contacts::footForce(int foot, const TreeDynamics& tree) const {
  FootForce result;
  for (const Corner& corner : corners_) {
    if (corner.foot != foot || !corner.active) continue;
    const Vec3 local = tree.rotation(corner.link).transpose() * (ground_ * corner.force);
    result.normal += local.z();
    result.centre += local.z() * corner.local.head<2>();
  }
  if (result.normal > 0) result.centre /= result.normal;
  return result;
}

}  // namespace plumbline::gap
