#include "modules/modeling/ball/BallFilter.h"

#include <cmath>

#include "tactics/RollingBall.h"

namespace plumbline {

void BallFilter::reset() { *this = BallFilter(parameters_); }

void BallFilter::start(const Vec2& position, const Mat2& covariance, const Vec2& velocity) {
  started_ = true;
  state_ << position, velocity;
  covariance_.setZero();
  covariance_.topLeftCorner<2, 2>() = covariance;
  const double v = parameters_.startSpeedDeviation;
  covariance_.bottomRightCorner<2, 2>() = v * v * Mat2::Identity();
  unconfirmed_.reset();
  atRest_ = velocity.isZero();
}

void BallFilter::predict(double dt, bool touchable, double drift) {
  if (!started_ || !(dt > 0)) return;
  const double keep = std::exp(-dt / ballRollingSeconds), way = ballRollingSeconds * (1 - keep);
  Mat4 transition = Mat4::Identity();
  transition.topRightCorner<2, 2>() = way * Mat2::Identity();
  transition.bottomRightCorner<2, 2>() = keep * Mat2::Identity();
  // Most balls lie still; the noise of the estimated speed would let them roll away while unseen.
  if (!atRest_) state_.head<2>() += way * state_.tail<2>();
  state_.tail<2>() *= keep;
  covariance_ = transition * covariance_ * transition.transpose();
  const double noise = touchable ? parameters_.touchedSpeedNoise : parameters_.speedNoise;
  const double q = noise * noise * dt;
  covariance_.topLeftCorner<2, 2>().diagonal().array() += drift * drift + q * dt * dt / 3;
  covariance_.bottomRightCorner<2, 2>().diagonal().array() += q;
  covariance_.topRightCorner<2, 2>().diagonal().array() += q * dt / 2;
  covariance_.bottomLeftCorner<2, 2>().diagonal().array() += q * dt / 2;
  if (unconfirmed_) unconfirmed_->age += dt;
}

bool BallFilter::update(const Vec2& position, const Mat2& covariance) {
  if (!position.allFinite()) return false;
  if (!started_) {
    start(position, covariance, Vec2::Zero());
    return true;
  }
  const Mat2 innovationInverse = (covariance_.topLeftCorner<2, 2>() + covariance).inverse();
  const Vec2 innovation = position - state_.head<2>();
  if (innovation.dot(innovationInverse * innovation) > parameters_.gate * parameters_.gate) {
    if (unconfirmed_ && unconfirmed_->age > 0 && unconfirmed_->age < parameters_.agreementSeconds) {
      const Vec2 velocity = (position - unconfirmed_->position) / unconfirmed_->age;
      if (velocity.norm() < parameters_.agreementSpeed) {
        start(position, covariance, velocity);
        return true;
      }
    }
    unconfirmed_ = Unconfirmed{position, 0};
    return false;
  }
  unconfirmed_.reset();
  const Eigen::Matrix<double, 4, 2> gain = covariance_.leftCols<2>() * innovationInverse;
  state_ += gain * innovation;
  const Mat4 remaining = covariance_ - gain * covariance_.topRows<2>();
  covariance_ = 0.5 * (remaining + remaining.transpose());
  const double variance = 0.5 * (covariance_(2, 2) + covariance_(3, 3));
  atRest_ =
      state_.tail<2>().squaredNorm() < parameters_.restDeviations * parameters_.restDeviations * variance;
  return true;
}

double BallFilter::deviation() const { return std::sqrt(0.5 * (covariance_(0, 0) + covariance_(1, 1))); }

}  // namespace plumbline
