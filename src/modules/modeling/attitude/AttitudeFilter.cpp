#include "modules/modeling/attitude/AttitudeFilter.h"

#include <algorithm>
#include <cmath>

#include "math/Gravity.h"

namespace plumbline {
namespace {
constexpr double firstSettled = 10;  ///< what the first orientation counts like [s]
constexpr double fastest = 0.5;      ///< time constant of a new estimate [s]
}  // namespace

void AttitudeFilter::reset() { *this = AttitudeFilter(parameters_); }

void AttitudeFilter::update(const Vec3& gyro, const Vec3& acc, double dt) {
  if (!(dt > 0) || !gyro.allFinite() || !acc.allFinite()) return;
  if (fresh_) {
    if (std::abs(acc.norm() - earthGravity) < parameters_.stillAcc) correct(acc, 1);
    settledFor_ = firstSettled;
    fresh_ = false;
  }
  // The accelerometer is a cycle late, so it is turned by the orientation of that cycle.
  const Vec3 accWorld = R_world_torso_ * acc;
  integrate(gyro, dt);
  tiltVariance_ += parameters_.tiltNoise * parameters_.tiltNoise;

  const bool calm = gyro.norm() < parameters_.stillGyro &&
                    std::abs(acc.norm() - earthGravity) < parameters_.stillAcc &&
                    (acc - lastAcc_).norm() < parameters_.stillAcc;
  stillFor_ = calm ? std::min(stillFor_ + 1, parameters_.stillCycles) : 0;
  lastAcc_ = acc;

  if (still()) {
    correct(accWorld, std::min(1.0, dt / parameters_.stillTimeConstant));
    meanAcc_ = Vec3(0, 0, earthGravity);
    lostFor_ = 0;
    settledFor_ = parameters_.movingTimeConstant;
    return;
  }
  // Accelerations of a walk average out in the world frame, so each sample counts as it is, without
  // normalising it; free fall pulls nothing, an impact what it gave back of a speed.
  const Vec3 pull = (accWorld / earthGravity).cross(Vec3::UnitZ());
  const double angle = pull.norm();
  // A new estimate is drawn to the mean of all since its start before the pull gets as weak as it shall be.
  settledFor_ = std::min(settledFor_ + dt, parameters_.movingTimeConstant);
  const double share = dt / std::max(settledFor_, std::min(fastest, parameters_.movingTimeConstant));
  if (angle > 0) {
    q_ = Eigen::Quaterniond(Eigen::AngleAxisd(angle * share, pull / angle)) * q_;
    R_world_torso_ = q_.toRotationMatrix();
  }

  // After a move by the referee (a beam) no sensor shows the new orientation, and a robot that keeps moving
  // is never still: a mean acceleration that stays tilted is the way out.
  meanAcc_ += (accWorld - meanAcc_) * std::min(1.0, dt / parameters_.averageTimeConstant);
  const double strength = meanAcc_.norm();
  const bool tilted = strength > 0.7 * earthGravity && strength < 1.3 * earthGravity &&
                      meanAcc_.z() < std::cos(parameters_.lostAngle) * strength;
  lostFor_ = tilted ? lostFor_ + dt : 0;
  if (lostFor_ > parameters_.lostSeconds) {
    correct(meanAcc_, 1);
    settledFor_ = 0;
    tiltVariance_ = unknownTilt;
    meanAcc_ = Vec3(0, 0, earthGravity);
    lostFor_ = 0;
  }
}

void AttitudeFilter::seeGround(const GroundPlane::Fit& ground) {
  const Vec3 up = this->up();
  double distance = 0;
  Vec3 shift = Vec3::Zero();
  for (std::size_t i = 0; i < ground.axes.size(); ++i) {
    // How far the seen up leans away from the estimated one, along an axis of the seen ground.
    const double lean = -up.dot(ground.axes[i]);
    const double variance = tiltVariance_ + ground.variances[i];
    distance += lean * lean / variance;
    shift += tiltVariance_ / variance * lean * ground.axes[i];
  }
  const bool differs = distance > parameters_.groundGate * parameters_.groundGate || up.dot(ground.up) < 0.5;
  if (differs && !groundDiffers_) {
    groundDiffers_ = true;
    return;
  }
  groundDiffers_ = false;
  if (differs) {
    tiltVariance_ = unknownTilt;
    shift = ground.up - up;
    settledFor_ = parameters_.movingTimeConstant;
  }
  tiltVariance_ = 1 / (1 / tiltVariance_ + 1 / ground.variances[1]);
  // What is vertical: the estimate and its shift, both as the world sees them now.
  correct(R_world_torso_ * (up + shift), 1);
}

void AttitudeFilter::integrate(const Vec3& gyro, double dt) {
  // First order in the quaternion, then normalised: the step ODE itself takes; against the exponential it
  // errs by (|gyro| dt)^3 / 12, 1e-5 rad at 2.5 rad/s and 20 ms.
  const Vec3 half = 0.5 * dt * gyro;
  q_ = (q_ * Eigen::Quaterniond(1, half.x(), half.y(), half.z())).normalized();
  R_world_torso_ = q_.toRotationMatrix();
}

void AttitudeFilter::correct(const Vec3& measuredUp, double part) {
  Vec3 axis = measuredUp.cross(Vec3::UnitZ());
  const double sine = axis.norm();
  const double angle = std::atan2(sine, measuredUp.z());
  if (angle < 1e-9) return;
  axis = sine > 1e-12 ? Vec3(axis / sine) : Vec3::UnitX();  // upside down: any horizontal axis
  q_ = (Eigen::Quaterniond(Eigen::AngleAxisd(part * angle, axis)) * q_).normalized();
  R_world_torso_ = q_.toRotationMatrix();
}

double AttitudeFilter::roll() const { return std::atan2(R_world_torso_(2, 1), R_world_torso_(2, 2)); }
double AttitudeFilter::pitch() const { return -std::asin(std::clamp(R_world_torso_(2, 0), -1.0, 1.0)); }
double AttitudeFilter::heading() const { return std::atan2(R_world_torso_(1, 0), R_world_torso_(0, 0)); }

}  // namespace plumbline
