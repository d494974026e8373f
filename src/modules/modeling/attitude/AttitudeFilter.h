#pragma once
#include "math/Types.h"
#include "modules/modeling/attitude/GroundPlane.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// Orientation of the torso from its gyroscope and accelerometer: the gyroscope is integrated, the
/// accelerometer's mean direction pulls the tilt back slowly, and quickly while the robot is still.
/// A complementary filter after Mahony, Hamel and Pflimlin, "Nonlinear Complementary Filters on the Special
/// Orthogonal Group" (2008), eq. 32, with a gain that depends on the motion. Where the camera sees the
/// ground, a Kalman filter on the tilt takes that in as well.
class AttitudeFilter {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(double, movingTimeConstant, 40, "s", Range(0.1, 1e4),
              "time constant of the pull towards the accelerometer while the robot moves")
    PARAMETER(double, stillTimeConstant, 0.2, "s", Range(0.01, 1e4),
              "the same time constant while the robot is still")
    PARAMETER(double, stillGyro, 0.05, "rad/s", Range(0, 10), "a still robot turns no faster")
    PARAMETER(double, stillAcc, 0.1, "m/s^2", Range(0, 10),
              "largest difference of a still robot's acceleration from gravity and between two cycles")
    PARAMETER(int, stillCycles, 10, "", Range(1, 1000),
              "number of cycles after which the robot counts as still")
    PARAMETER(double, averageTimeConstant, 0.5, "s", Range(0.01, 100),
              "time constant of the mean acceleration that shows a lost orientation")
    PARAMETER(double, lostAngle, 0.35, "rad", Range(0.01, 3.2),
              "angle between mean acceleration and estimate that means a lost orientation")
    PARAMETER(double, lostSeconds, 1, "s", Range(0, 100), "time for which that angle must last")
    PARAMETER(double, tiltNoise, 1e-4, "rad", Range(0, 1),
              "growth of the standard deviation of the tilt in a cycle")
    PARAMETER(double, groundGate, 5, "", Range(0.1, 1000),
              "a seen ground farther off must be seen twice, in standard deviations")
  };

  AttitudeFilter() = default;
  explicit AttitudeFilter(const Parameters& parameters) : parameters_(parameters) {}

  /// The state stays.
  void setParameters(const Parameters& changed) { parameters_ = changed; }
  /// Forgets everything: heading 0 and upright, unless the next accelerometer reading has gravity's strength.
  void reset();

  /// One cycle. gyro: turn speed in the torso frame over the last dt [rad/s]; acc: specific force in the
  /// torso frame of the cycle before (SimSpark's accelerometer is one cycle late) [m/s^2]; dt [s].
  void update(const Vec3& gyro, const Vec3& acc, double dt);

  /// The ground as the camera sees it at the same time, in the torso frame. The first one that does not fit
  /// is ignored; if the next one agrees with it, the robot was put down differently.
  void seeGround(const GroundPlane::Fit& ground);

  /// World (z up, heading counted from where the filter was reset) from torso.
  const Mat3& rotation() const { return R_world_torso_; }
  /// R_world_torso = Rz(heading) * Ry(pitch) * Rx(roll) [rad].
  double roll() const;
  double pitch() const;
  double heading() const;
  /// Up in the torso frame, length 1.
  Vec3 up() const { return R_world_torso_.row(2); }
  bool still() const { return stillFor_ >= parameters_.stillCycles; }

private:
  void integrate(const Vec3& gyro, double dt);
  /// Turns the estimate about a horizontal axis so that the torso's direction `up` (world frame, any length)
  /// comes closer to vertical by the given part of the angle, 0 to 1.
  void correct(const Vec3& measuredUp, double part);

  static constexpr double unknownTilt = 0.01;  ///< [rad^2]

  Parameters parameters_;
  Eigen::Quaterniond q_ = Eigen::Quaterniond::Identity();
  Mat3 R_world_torso_ = Mat3::Identity();
  Vec3 lastAcc_ = Vec3::Zero();
  Vec3 meanAcc_ = Vec3::Zero();  ///< world frame
  bool fresh_ = true;  ///< before the first update, whose accelerometer is believed if it reads gravity
  int stillFor_ = 0;
  bool groundDiffers_ = false;         ///< the last seen ground did not fit
  double tiltVariance_ = unknownTilt;  ///< of each component of the tilt [rad^2]
  double settledFor_ = 0;  ///< since the estimate was started or lost, up to movingTimeConstant [s]
  double lostFor_ = 0;
};

}  // namespace plumbline
