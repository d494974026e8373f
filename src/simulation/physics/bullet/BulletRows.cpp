#include "simulation/physics/bullet/BulletRows.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "math/Index.h"

namespace plumbline::simulation::bullet {

BulletRows::BulletRows(const btMultiBody& body_) : body(body_), size(6 + body_.getNumDofs()) {
  jacobians.resize(size, 64);
  responses.resize(size, 64);
}

void BulletRows::reset() {
  count = 0;
  basesUsed = 0;
  held.clear();
  places.clear();
  coordinates.clear();
  signs.clear();
  before = Eigen::Map<const Eigen::VectorXd>(body.getVelocityVector(), size);
}

int BulletRows::newRow(int coordinate, double sign) {
  if (count == jacobians.cols()) {
    jacobians.conservativeResize(size, 2 * count);
    responses.conservativeResize(size, 2 * count);
  }
  places.push_back(-1);
  coordinates.push_back(coordinate);
  signs.push_back(sign);
  return count++;
}

const BulletRows::Basis& BulletRows::basisOf(int link, const Vec3& origin) {
  for (std::size_t i = 0; i < basesUsed; ++i)
    if (bases[i].link == link) return bases[i];
  if (basesUsed == bases.size()) bases.emplace_back();
  Basis& basis = bases[basesUsed++];
  basis.link = link;
  basis.jacobian.resize(size, 6);
  basis.response.resize(size, 6);
  const btVector3 nothing(0, 0, 0), point = fromVec3(origin);
  for (int i = 0; i < 6; ++i) {
    btVector3 unit(0, 0, 0);
    unit[i % 3] = 1;
    body.fillConstraintJacobianMultiDof(link, point, i < 3 ? nothing : unit, i < 3 ? unit : nothing,
                                        basis.jacobian.col(i).data(), scratchR, scratchV, scratchM);
    body.calcAccelerationDeltasMultiDof(basis.jacobian.col(i).data(), basis.response.col(i).data(), scratchR,
                                        scratchV);
  }
  return basis;
}

int BulletRows::addPoint(int link, const Vec3& origin, const Vec3& point, const Vec3& direction) {
  const Basis& basis = basisOf(link, origin);
  Eigen::Matrix<double, 6, 1> share;
  share << direction, (point - origin).cross(direction);
  const int row = newRow(-1, 1);
  jacobians.col(row).noalias() = basis.jacobian * share;
  responses.col(row).noalias() = basis.response * share;
  return row;
}

int BulletRows::addJoint(int coordinate, double sign) {
  const int row = newRow(coordinate, sign);
  jacobians.col(row).setZero();
  jacobians(coordinate, row) = sign;
  body.calcAccelerationDeltasMultiDof(jacobians.col(row).data(), responses.col(row).data(), scratchR,
                                      scratchV);
  return row;
}

int BulletRows::addJointPair(int first, int second, double ratio) {
  const int row = newRow(-1, 1);
  jacobians.col(row).setZero();
  jacobians(first, row) = 1;
  jacobians(second, row) = -ratio;
  body.calcAccelerationDeltasMultiDof(jacobians.col(row).data(), responses.col(row).data(), scratchR,
                                      scratchV);
  return row;
}

void BulletRows::hold(int row, double wanted, double compliance) {
  held.push_back({row, wanted, compliance});
  places[at(row)] = -1;
}

/// Velocity along row r by an impulse of 1 along row s.
double BulletRows::response(int r, int s) const {
  if (coordinates[at(r)] >= 0) return signs[at(r)] * responses(coordinates[at(r)], s);
  if (coordinates[at(s)] >= 0) return signs[at(s)] * responses(coordinates[at(s)], r);
  return jacobians.col(r).dot(responses.col(s));
}

void BulletRows::eliminateHeld(const Eigen::VectorXd& velocity) {
  const auto n = static_cast<Eigen::Index>(held.size());
  factor.resize(n, n);
  side.resize(n);
  across.resize(n, static_cast<Eigen::Index>(placed.size()));
  for (Eigen::Index j = 0; j < n; ++j) {
    const Held& own = held[static_cast<std::size_t>(j)];
    for (Eigen::Index i = j; i < n; ++i)
      factor(i, j) = response(held[static_cast<std::size_t>(i)].row, own.row);
    factor(j, j) += own.compliance;
    side[j] = own.wanted - jacobians.col(own.row).dot(velocity);
    for (Eigen::Index k = 0; k < across.cols(); ++k)
      across(j, k) = response(own.row, placed[static_cast<std::size_t>(k)]);
  }
  // Eigen is not asked about matrices without a row or column: it would form references from null pointers.
  if (n == 0) return;
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(factor);
  cholesky.matrixL().solveInPlace(side);
  if (across.cols() > 0) cholesky.matrixL().solveInPlace(across);
}

void BulletRows::addTo(BoundedSystem& system) {
  const Eigen::VectorXd velocity = Eigen::Map<const Eigen::VectorXd>(body.getVelocityVector(), size);
  placed.clear();
  for (int r = 0; r < count; ++r)
    if (places[at(r)] >= 0) placed.push_back(r);
  eliminateHeld(velocity);
  const bool holds = !held.empty();
  for (std::size_t k = 0; k < placed.size(); ++k) {
    const int r = placed[k];
    const auto kk = static_cast<Eigen::Index>(k);
    const Eigen::Index global = places[at(r)];
    system.b[global] -= jacobians.col(r).dot(velocity) + (holds ? across.col(kk).dot(side) : 0);
    for (std::size_t l = 0; l <= k; ++l) {
      const int s = placed[l];
      const double value =
          response(r, s) - (holds ? across.col(kk).dot(across.col(static_cast<Eigen::Index>(l))) : 0);
      // Several rows of one body may share a place: a contact between two of its links.
      const Eigen::Index i = std::max(global, places[at(s)]), j = std::min(global, places[at(s)]);
      system.a(i, j) += r != s && i == j ? 2 * value : value;
    }
  }
}

const Eigen::VectorXd& BulletRows::heldImpulses(const Eigen::VectorXd& solution) {
  heldX = side;
  if (held.empty()) return heldX;
  for (std::size_t k = 0; k < placed.size(); ++k)
    heldX -= solution[places[at(placed[k])]] * across.col(static_cast<Eigen::Index>(k));
  factor.triangularView<Eigen::Lower>().transpose().solveInPlace(heldX);
  return heldX;
}

void BulletRows::apply(const Eigen::VectorXd& impulses, btMultiBody& mutableBody) const {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(size);
  for (int r = 0; r < count; ++r)
    if (places[at(r)] >= 0) change += impulses[places[at(r)]] * responses.col(r);
  for (std::size_t i = 0; i < held.size(); ++i)
    change += heldX[static_cast<Eigen::Index>(i)] * responses.col(held[i].row);
  mutableBody.applyDeltaVeeMultiDof(change.data(), 1);
}

}  // namespace plumbline::simulation::bullet
