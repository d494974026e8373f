#include "simulation/physics/bullet/BulletRows.h"

#include <algorithm>

namespace plumbline::simulation::bullet {

namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

BulletRows::BulletRows(const btMultiBody& body_) : body(body_), size(6 + body_.getNumDofs()) {
  jacobians.resize(size, 64);
  responses.resize(size, 64);
}

void BulletRows::reset() {
  count = 0;
  basesUsed = 0;
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

void BulletRows::addTo(BoundedSystem& system) const {
  const Eigen::Map<const Eigen::VectorXd> velocity(body.getVelocityVector(), size);
  for (int r = 0; r < count; ++r) {
    const Eigen::Index global = places[at(r)];
    system.b[global] -= jacobians.col(r).dot(velocity);
    for (int s = 0; s <= r; ++s) {
      double response;
      if (coordinates[at(r)] >= 0)
        response = signs[at(r)] * responses(coordinates[at(r)], s);
      else if (coordinates[at(s)] >= 0)
        response = signs[at(s)] * responses(coordinates[at(s)], r);
      else
        response = jacobians.col(r).dot(responses.col(s));
      // Several rows of one body may share a place: a contact between two of its links.
      const Eigen::Index i = std::max(global, places[at(s)]), j = std::min(global, places[at(s)]);
      system.a(i, j) += r != s && i == j ? 2 * response : response;
    }
  }
}

void BulletRows::apply(const Eigen::VectorXd& impulses, btMultiBody& mutableBody) const {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(size);
  for (int r = 0; r < count; ++r) change += impulses[places[at(r)]] * responses.col(r);
  mutableBody.applyDeltaVeeMultiDof(change.data(), 1);
}

}  // namespace plumbline::simulation::bullet
