#pragma once

namespace plumbline {

/// What a walk carries out: any mixture of speeds within the ellipsoid of the first four, changed at most as
/// fast as the others say.
struct WalkLimits {
  double forward = 0, backward = 0, sideways = 0;                                     ///< [m/s]; 0: not known
  double turn = 0;                                                                    ///< [rad/s]
  double accelerationForward = 0, decelerationForward = 0, accelerationSideways = 0;  ///< [m/s^2]
  double accelerationTurn = 0;                                                        ///< [rad/s^2]

  bool known() const { return forward > 0 && backward > 0 && sideways > 0 && turn > 0; }
  bool operator==(const WalkLimits&) const = default;
};

}  // namespace plumbline
