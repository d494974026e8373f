#include "modules/modeling/others/RobotTrack.h"

#include <cmath>

namespace plumbline {

void RobotTrack::start(const Vec2& position, const Mat2& covariance, const Parameters& parameters) {
  started_ = true;
  robot_.position = position;
  robot_.velocity.setZero();
  robot_.covariance = covariance;
  cross_.setZero();
  velocityCovariance_ = parameters.startSpeed * parameters.startSpeed * Mat2::Identity();
}

void RobotTrack::predict(double dt, const Parameters& parameters) {
  if (!started_ || !(dt > 0)) return;
  const double keep = std::exp(-dt / parameters.walkSeconds);
  const double way = parameters.walkSeconds * (1 - keep);
  robot_.position += way * robot_.velocity;
  robot_.velocity *= keep;
  const double q = parameters.walkNoise * parameters.walkNoise * dt;
  robot_.covariance += way * (cross_ + cross_.transpose()) + way * way * velocityCovariance_;
  robot_.covariance.diagonal().array() += q * dt * dt / 3;
  cross_ = keep * (cross_ + way * velocityCovariance_);
  cross_.diagonal().array() += q * dt / 2;
  velocityCovariance_ *= keep * keep;
  velocityCovariance_.diagonal().array() += q;
}

void RobotTrack::see(const Vec2& position, const Mat2& covariance, double time,
                     const Parameters& parameters) {
  missed = 0;
  robot_.lastSeen = time;
  if (!started_) return start(position, covariance, parameters);
  const Mat2 inverse = (robot_.covariance + covariance).inverse();
  const Vec2 innovation = position - robot_.position;
  if (innovation.dot(inverse * innovation) > parameters.gate * parameters.gate)
    return start(position, covariance, parameters);
  const Mat2 gain = robot_.covariance * inverse, velocityGain = cross_.transpose() * inverse;
  robot_.position += gain * innovation;
  robot_.velocity = shortened(robot_.velocity + velocityGain * innovation, parameters.maxSpeed);
  velocityCovariance_ -= velocityGain * cross_;
  cross_ -= gain * cross_;
  const Mat2 remaining = robot_.covariance - gain * robot_.covariance;
  robot_.covariance = 0.5 * (remaining + remaining.transpose());
  velocityCovariance_ = 0.5 * (velocityCovariance_ + velocityCovariance_.transpose()).eval();
}

}  // namespace plumbline
