#pragma once
#include "math/Types.h"
#include "parameters/Parameter.h"
#include "representations/modeling/OtherRobots.h"

namespace plumbline {

/// One other robot followed over the field: a Kalman filter over position and velocity whose model lets the
/// velocity die away, because nobody walks in one direction for long.
class RobotTrack {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(double, walkSeconds, 1.0, "s", Range(0.05, 100),
              "time constant with which the velocity of an unseen robot dies away")
    PARAMETER(double, walkNoise, 0.8, "m/s/sqrt(s)", Range(1e-3, 100), "unforeseen change of its velocity")
    PARAMETER(double, startSpeed, 0.5, "m/s", Range(1e-3, 10),
              "standard deviation of its velocity at first sight")
    PARAMETER(double, maxSpeed, 1.3, "m/s", Range(0.1, 10), "no robot walks faster")
    PARAMETER(double, gate, 5, "", Range(1, 100),
              "an observation farther away, in standard deviations, restarts the track: the robot was moved")
  };

  RobotTrack(bool mate, int number) { robot_.mate = mate, robot_.number = number; }

  /// dt passes [s].
  void predict(double dt, const Parameters& parameters);
  /// Seen there on the field [m] at a time [s].
  void see(const Vec2& position, const Mat2& covariance, double time, const Parameters& parameters);
  void setFallen(bool fallen) { robot_.fallen = fallen; }
  const OtherRobot& robot() const { return robot_; }

  int missed = 0;  ///< images in a row in which it should have been and was not

private:
  void start(const Vec2& position, const Mat2& covariance, const Parameters& parameters);

  OtherRobot robot_;
  bool started_ = false;
  Mat2 cross_ = Mat2::Zero();  ///< covariance of position and velocity
  Mat2 velocityCovariance_ = Mat2::Identity();
};

}  // namespace plumbline
