#include "simulation/physics/bullet/BulletRows.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "math/Index.h"
#include "math/Resize.h"

namespace plumbline::simulation::bullet {

BulletRows::BulletRows(const btMultiBody& body) : body_(body), size_(6 + body.getNumDofs()) {
  jacobians_.resize(size_, 64);
  responses_.resize(size_, 64);
}

void BulletRows::reset() {
  count_ = 0;
  basesUsed_ = 0;
  held_.clear();
  places_.clear();
  coordinates_.clear();
  signs_.clear();
  before_ = Eigen::Map<const Eigen::VectorXd>(body_.getVelocityVector(), size_);
}

int BulletRows::newRow(int coordinate, double sign) {
  if (count_ == jacobians_.cols()) {
    jacobians_.conservativeResize(size_, 2 * count_);
    responses_.conservativeResize(size_, 2 * count_);
  }
  places_.push_back(-1);
  coordinates_.push_back(coordinate);
  signs_.push_back(sign);
  return count_++;
}

const BulletRows::Basis& BulletRows::basisOf(int link, const Vec3& origin) {
  for (std::size_t i = 0; i < basesUsed_; ++i)
    if (bases_[i].link == link) return bases_[i];
  if (basesUsed_ == bases_.size()) bases_.emplace_back();
  Basis& basis = bases_[basesUsed_++];
  basis.link = link;
  basis.jacobian.resize(size_, 6);
  basis.response.resize(size_, 6);
  const btVector3 nothing(0, 0, 0), point = fromVec3(origin);
  for (int i = 0; i < 6; ++i) {
    btVector3 unit(0, 0, 0);
    unit[i % 3] = 1;
    body_.fillConstraintJacobianMultiDof(link, point, i < 3 ? nothing : unit, i < 3 ? unit : nothing,
                                         basis.jacobian.col(i).data(), scratchR_, scratchV_, scratchM_);
    body_.calcAccelerationDeltasMultiDof(basis.jacobian.col(i).data(), basis.response.col(i).data(),
                                         scratchR_, scratchV_);
  }
  return basis;
}

int BulletRows::addPoint(int link, const Vec3& origin, const Vec3& point, const Vec3& direction) {
  const Basis& basis = basisOf(link, origin);
  Eigen::Matrix<double, 6, 1> share;
  share << direction, (point - origin).cross(direction);
  const int row = newRow(-1, 1);
  jacobians_.col(row).noalias() = basis.jacobian * share;
  responses_.col(row).noalias() = basis.response * share;
  return row;
}

int BulletRows::addJoint(int coordinate, double sign) {
  const int row = newRow(coordinate, sign);
  jacobians_.col(row).setZero();
  jacobians_(coordinate, row) = sign;
  body_.calcAccelerationDeltasMultiDof(jacobians_.col(row).data(), responses_.col(row).data(), scratchR_,
                                       scratchV_);
  return row;
}

int BulletRows::addJointPair(int first, int second, double ratio) {
  const int row = newRow(-1, 1);
  jacobians_.col(row).setZero();
  jacobians_(first, row) = 1;
  jacobians_(second, row) = -ratio;
  body_.calcAccelerationDeltasMultiDof(jacobians_.col(row).data(), responses_.col(row).data(), scratchR_,
                                       scratchV_);
  return row;
}

void BulletRows::hold(int row, double wanted, double compliance) {
  held_.push_back({row, wanted, compliance});
  places_[at(row)] = -1;
}

/// Velocity along row r by an impulse of 1 along row s.
double BulletRows::response(int r, int s) const {
  if (coordinates_[at(r)] >= 0) return signs_[at(r)] * responses_(coordinates_[at(r)], s);
  if (coordinates_[at(s)] >= 0) return signs_[at(s)] * responses_(coordinates_[at(s)], r);
  return jacobians_.col(r).dot(responses_.col(s));
}

void BulletRows::eliminateHeld(const Eigen::VectorXd& velocity) {
  const auto n = static_cast<Eigen::Index>(held_.size());
  resizeInUse(factor_, n, n);
  resizeInUse(side_, n);
  resizeInUse(across_, n, static_cast<Eigen::Index>(placed_.size()));
  for (Eigen::Index j = 0; j < n; ++j) {
    const Held& own = held_[static_cast<std::size_t>(j)];
    for (Eigen::Index i = j; i < n; ++i)
      factor_(i, j) = response(held_[static_cast<std::size_t>(i)].row, own.row);
    factor_(j, j) += own.compliance;
    side_[j] = own.wanted - jacobians_.col(own.row).dot(velocity);
    for (Eigen::Index k = 0; k < across_.cols(); ++k)
      across_(j, k) = response(own.row, placed_[static_cast<std::size_t>(k)]);
  }
  // Matrices without a row or column are not passed to Eigen: it would form references from null pointers.
  if (n == 0) return;
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(factor_);
  cholesky.matrixL().solveInPlace(side_);
  if (across_.cols() > 0) cholesky.matrixL().solveInPlace(across_);
}

void BulletRows::addTo(BoundedSystem& system) {
  const Eigen::VectorXd velocity = Eigen::Map<const Eigen::VectorXd>(body_.getVelocityVector(), size_);
  placed_.clear();
  for (int r = 0; r < count_; ++r)
    if (places_[at(r)] >= 0) placed_.push_back(r);
  eliminateHeld(velocity);
  const bool holds = !held_.empty();
  for (std::size_t k = 0; k < placed_.size(); ++k) {
    const int r = placed_[k];
    const auto kk = static_cast<Eigen::Index>(k);
    const Eigen::Index global = places_[at(r)];
    system.b[global] -= jacobians_.col(r).dot(velocity) + (holds ? across_.col(kk).dot(side_) : 0);
    for (std::size_t l = 0; l <= k; ++l) {
      const int s = placed_[l];
      const double value =
          response(r, s) - (holds ? across_.col(kk).dot(across_.col(static_cast<Eigen::Index>(l))) : 0);
      // Several rows of one body may share a place: a contact between two of its links.
      const Eigen::Index i = std::max(global, places_[at(s)]), j = std::min(global, places_[at(s)]);
      system.a(i, j) += r != s && i == j ? 2 * value : value;
    }
  }
}

const Eigen::VectorXd& BulletRows::heldImpulses(const Eigen::VectorXd& solution) {
  heldX_ = side_;
  if (held_.empty()) return heldX_;
  for (std::size_t k = 0; k < placed_.size(); ++k)
    heldX_ -= solution[places_[at(placed_[k])]] * across_.col(static_cast<Eigen::Index>(k));
  factor_.triangularView<Eigen::Lower>().transpose().solveInPlace(heldX_);
  return heldX_;
}

void BulletRows::apply(const Eigen::VectorXd& impulses, btMultiBody& mutableBody) const {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(size_);
  for (int r = 0; r < count_; ++r)
    if (places_[at(r)] >= 0) change += impulses[places_[at(r)]] * responses_.col(r);
  for (std::size_t i = 0; i < held_.size(); ++i)
    change += heldX_[static_cast<Eigen::Index>(i)] * responses_.col(held_[i].row);
  mutableBody.applyDeltaVeeMultiDof(change.data(), 1);
}

}  // namespace plumbline::simulation::bullet
