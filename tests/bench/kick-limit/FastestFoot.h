#pragma once
#include <string>

#include "robot/RobotModel.h"

namespace plumbline::bench {

/// The greatest speed at which a robot can move its right foot's front forward [m/s].
struct FastestFoot {
  double wholeChain = 0;  ///< all joints of both legs at their speed limits
  double kickingLeg = 0;  ///< only those of the right leg
};

/// A bound for any kick with the right foot. The left foot is flat on the ground and does not move. The front
/// of the right foot is as high as a ball can be hit, the rest of that foot above the ground; hips keep the
/// foot beside the other one. All joints turn at their limits, whatever torque that takes: so no kick is
/// faster. Searched from `starts` random postures.
FastestFoot fastestFoot(const RobotModel& model, int starts, unsigned seed);

}  // namespace plumbline::bench
