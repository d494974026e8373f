#include "modules/modeling/attitude/AttitudeFilter.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {
constexpr double gravity = 9.81;
constexpr double firstSettled = 10;  ///< what the first orientation counts like [s]
constexpr double fastest = 0.5;      ///< time constant of a new estimate [s]
}  // namespace

void AttitudeFilter::reset() { *this = AttitudeFilter(parameters); }

void AttitudeFilter::update(const Vec3& gyro, const Vec3& acc, double dt) {
  if (!(dt > 0) || !gyro.allFinite() || !acc.allFinite()) return;
  if (fresh) {
    if (std::abs(acc.norm() - gravity) < parameters.stillAcc) correct(acc, 1);
    settledFor = firstSettled;
    fresh = false;
  }
  // The accelerometer tells of the cycle before, so it is turned by the orientation of then.
  const Vec3 accWorld = R_world_torso * acc;
  integrate(gyro, dt);
  tiltVariance += parameters.tiltNoise * parameters.tiltNoise;

  const bool calm = gyro.norm() < parameters.stillGyro &&
                    std::abs(acc.norm() - gravity) < parameters.stillAcc &&
                    (acc - lastAcc).norm() < parameters.stillAcc;
  stillFor = calm ? std::min(stillFor + 1, parameters.stillCycles) : 0;
  lastAcc = acc;

  if (still()) {
    correct(accWorld, std::min(1.0, dt / parameters.stillTimeConstant));
    meanAcc = Vec3(0, 0, gravity);
    lostFor = 0;
    settledFor = parameters.movingTimeConstant;
    return;
  }
  // Accelerations of a walk average out in the world frame, so each sample counts as it is, without
  // normalising it; free fall pulls nothing, an impact what it gave back of a speed.
  const Vec3 pull = (accWorld / gravity).cross(Vec3::UnitZ());
  const double angle = pull.norm();
  // A new estimate is drawn to the mean of all since its start before the pull gets as weak as it shall be.
  settledFor = std::min(settledFor + dt, parameters.movingTimeConstant);
  const double share = dt / std::max(settledFor, std::min(fastest, parameters.movingTimeConstant));
  if (angle > 0) {
    q = Eigen::Quaterniond(Eigen::AngleAxisd(angle * share, pull / angle)) * q;
    R_world_torso = q.toRotationMatrix();
  }

  // After a move by the referee (a beam) no sensor tells the new orientation, and a robot that keeps moving
  // is never still: a mean acceleration that stays tilted is the way out.
  meanAcc += (accWorld - meanAcc) * std::min(1.0, dt / parameters.averageTimeConstant);
  const double strength = meanAcc.norm();
  const bool tilted = strength > 0.7 * gravity && strength < 1.3 * gravity &&
                      meanAcc.z() < std::cos(parameters.lostAngle) * strength;
  lostFor = tilted ? lostFor + dt : 0;
  if (lostFor > parameters.lostSeconds) {
    correct(meanAcc, 1);
    settledFor = 0;
    tiltVariance = unknownTilt;
    meanAcc = Vec3(0, 0, gravity);
    lostFor = 0;
  }
}

void AttitudeFilter::seeGround(const GroundPlane::Fit& ground) {
  const Vec3 up = this->up();
  double distance = 0;
  Vec3 shift = Vec3::Zero();
  for (std::size_t i = 0; i < ground.axes.size(); ++i) {
    // How far the seen up leans away from the estimated one, along an axis of the seen ground.
    const double lean = -up.dot(ground.axes[i]);
    const double variance = tiltVariance + ground.variances[i];
    distance += lean * lean / variance;
    shift += tiltVariance / variance * lean * ground.axes[i];
  }
  const bool differs = distance > parameters.groundGate * parameters.groundGate || up.dot(ground.up) < 0.5;
  if (differs && !groundDiffers) {
    groundDiffers = true;
    return;
  }
  groundDiffers = false;
  if (differs) {
    tiltVariance = unknownTilt;
    shift = ground.up - up;
    settledFor = parameters.movingTimeConstant;
  }
  tiltVariance = 1 / (1 / tiltVariance + 1 / ground.variances[1]);
  // What is vertical: the estimate and its shift, both as the world sees them now.
  correct(R_world_torso * (up + shift), 1);
}

void AttitudeFilter::integrate(const Vec3& gyro, double dt) {
  // First order in the quaternion, then normalised: the step ODE itself takes; against the exponential it
  // errs by (|gyro| dt)^3 / 12, 1e-5 rad at 2.5 rad/s and 20 ms.
  const Vec3 half = 0.5 * dt * gyro;
  q = (q * Eigen::Quaterniond(1, half.x(), half.y(), half.z())).normalized();
  R_world_torso = q.toRotationMatrix();
}

void AttitudeFilter::correct(const Vec3& measuredUp, double part) {
  Vec3 axis = measuredUp.cross(Vec3::UnitZ());
  const double sine = axis.norm();
  const double angle = std::atan2(sine, measuredUp.z());
  if (angle < 1e-9) return;
  axis = sine > 1e-12 ? Vec3(axis / sine) : Vec3::UnitX();  // upside down: any horizontal axis
  q = (Eigen::Quaterniond(Eigen::AngleAxisd(part * angle, axis)) * q).normalized();
  R_world_torso = q.toRotationMatrix();
}

double AttitudeFilter::roll() const { return std::atan2(R_world_torso(2, 1), R_world_torso(2, 2)); }
double AttitudeFilter::pitch() const { return -std::asin(std::clamp(R_world_torso(2, 0), -1.0, 1.0)); }
double AttitudeFilter::heading() const { return std::atan2(R_world_torso(1, 0), R_world_torso(0, 0)); }

}  // namespace plumbline
