#pragma once
#include <Eigen/Core>
#include <optional>

#include "math/Types.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// Position and speed of a ball that rolls over flat ground: a Kalman filter whose model lets the speed die
/// away exponentially (ballRollingSeconds). Coordinates are those of any frame that stands still on the
/// ground.
class BallFilter {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(double, speedNoise, 0.1, "m/s/sqrt(s)", Range(1e-4, 100),
              "random change of speed of a ball that no robot touches")
    PARAMETER(double, touchedSpeedNoise, 1.5, "m/s/sqrt(s)", Range(1e-4, 100),
              "unforeseen change of speed of a ball that the robot may touch")
    PARAMETER(double, startSpeedDeviation, 1, "m/s", Range(1e-3, 100),
              "standard deviation of the unknown speed at first sight")
    PARAMETER(double, restDeviations, 2, "", Range(0, 100),
              "a speed that differs less from zero counts as rest, in standard deviations")
    PARAMETER(double, gate, 4, "", Range(0.1, 100),
              "a percept farther off waits until the next one agrees, in standard deviations")
    PARAMETER(double, agreementSpeed, 12, "m/s", Range(0, 100),
              "two waiting percepts agree if the ball could have rolled this fast")
    PARAMETER(double, agreementSeconds, 0.5, "s", Range(0, 100),
              "two waiting percepts agree if they are no farther apart in time")
  };

  BallFilter() = default;
  explicit BallFilter(const Parameters& parameters) : parameters_(parameters) {}

  /// The state stays.
  void setParameters(const Parameters& changed) { parameters_ = changed; }
  void reset();
  bool started() const { return started_; }

  /// dt passes [s]; drift: deviation of the frame's motion against the ground in that time [m].
  void predict(double dt, bool touchable, double drift = 0);
  /// The ball is seen there. The first percept starts the filter. A percept that does not fit is not used at
  /// first. If the next one agrees with it, the ball was moved, and the filter restarts from both. Returns
  /// whether the percept was used.
  bool update(const Vec2& position, const Mat2& covariance);

  Vec2 position() const { return state_.head<2>(); }                                        ///< [m]
  Vec2 velocity() const { return atRest() ? Vec2(Vec2::Zero()) : Vec2(state_.tail<2>()); }  ///< [m/s]
  /// Whether, when it was last seen, the ball might as well have lain still.
  bool atRest() const { return atRest_; }
  double deviation() const;                                              ///< of the position, per axis [m]
  Mat2 covariance() const { return covariance_.topLeftCorner<2, 2>(); }  ///< of the position [m^2]

private:
  using Vec4 = Eigen::Vector4d;
  using Mat4 = Eigen::Matrix4d;
  void start(const Vec2& position, const Mat2& covariance, const Vec2& velocity);

  struct Unconfirmed {
    Vec2 position;
    double age;
  };

  Parameters parameters_;
  bool started_ = false, atRest_ = true;
  Vec4 state_ = Vec4::Zero();  ///< x, y, vx, vy
  Mat4 covariance_ = Mat4::Identity();
  std::optional<Unconfirmed> unconfirmed_;
};

}  // namespace plumbline
