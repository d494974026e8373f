#pragma once
#include "math/Types.h"
#include "modules/modeling/attitude/GroundPlane.h"

namespace plumbline {

/// Orientation of the torso from its gyroscope and accelerometer: the gyroscope is integrated, the
/// accelerometer's mean direction pulls the tilt back slowly, and quickly while the robot is still.
/// A complementary filter after Mahony, Hamel and Pflimlin, "Nonlinear Complementary Filters on the Special
/// Orthogonal Group" (2008), eq. 32, with a gain that depends on the motion. Where the camera sees the
/// ground, a Kalman filter on the tilt takes that in as well.
class AttitudeFilter {
public:
  struct Parameters {
    double movingTimeConstant = 40;    ///< of the pull towards the accelerometer while moving [s]
    double stillTimeConstant = 0.2;    ///< the same while still [s]
    double stillGyro = 0.05;           ///< largest turn speed of a still robot [rad/s]
    double stillAcc = 0.1;             ///< largest difference from gravity, and between two cycles [m/s^2]
    int stillCycles = 10;              ///< so long must it have been still
    double averageTimeConstant = 0.5;  ///< of the mean acceleration that detects a lost orientation [s]
    double lostAngle = 0.35;  ///< tilt of the mean acceleration against the estimate that means lost [rad]
    double lostSeconds = 1;   ///< ... if it lasts so long [s]
    double tiltNoise = 1e-4;  ///< what a cycle adds to the deviation of the tilt [rad]
    double groundGate = 5;    ///< a seen ground farther off must be seen so twice [deviations]
  };

  AttitudeFilter() = default;
  explicit AttitudeFilter(const Parameters& parameters) : parameters(parameters) {}

  /// Forgets everything: heading 0 and upright, unless the next accelerometer reading has gravity's strength.
  void reset();

  /// One cycle. gyro: turn speed in the torso frame over the last dt [rad/s]; acc: specific force in the
  /// torso frame of the cycle before (SimSpark's accelerometer is one cycle late) [m/s^2]; dt [s].
  void update(const Vec3& gyro, const Vec3& acc, double dt);

  /// The ground as the camera sees it at the same time, in the torso frame. The first one that does not fit
  /// is left out; if the next tells the same, the robot was put down differently.
  void seeGround(const GroundPlane::Fit& ground);

  /// World (z up, heading counted from where the filter was reset) from torso.
  const Mat3& rotation() const { return R_world_torso; }
  /// R_world_torso = Rz(heading) * Ry(pitch) * Rx(roll) [rad].
  double roll() const;
  double pitch() const;
  double heading() const;
  /// Up in the torso frame, length 1.
  Vec3 up() const { return R_world_torso.row(2); }
  bool still() const { return stillFor >= parameters.stillCycles; }

private:
  void integrate(const Vec3& gyro, double dt);
  /// Turns the estimate about a horizontal axis so that the torso's direction `up` (world frame, any length)
  /// comes closer to vertical by the given part of the angle, 0 to 1.
  void correct(const Vec3& measuredUp, double part);

  static constexpr double unknownTilt = 0.01;  ///< [rad^2]

  Parameters parameters;
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Mat3 R_world_torso = Mat3::Identity();
  Vec3 lastAcc = Vec3::Zero();
  Vec3 meanAcc = Vec3::Zero();  ///< world frame
  bool fresh = true;  ///< before the first update, whose accelerometer is believed if it reads gravity
  int stillFor = 0;
  bool groundDiffers = false;         ///< the last seen ground did not fit
  double tiltVariance = unknownTilt;  ///< of each component of the tilt [rad^2]
  double settledFor = 0;  ///< since the estimate was started or lost, up to movingTimeConstant [s]
  double lostFor = 0;
};

}  // namespace plumbline
