#pragma once

namespace plumbline {

/// What a kick does to the ball; means over many tries (bin/optserver --measure, scripts/measure_kick.sh).
struct KickEffect {
  double distance = 3;    ///< that the ball comes along the wanted direction [m]
  double direction = 0;   ///< to the left of the heading that the robot is to have [rad]
  double contact = 0;     ///< time from the motion's begin to the ball [s]
  double scatter = 0.12;  ///< standard deviation of the direction in games [rad]
  double spread = 1;      ///< of the distance [m]
  double rise = 0;        ///< height that the ball reaches [m]
};

}  // namespace plumbline
