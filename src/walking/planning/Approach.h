#pragma once
#include <vector>

#include "math/Pose2.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// Steps to a pose, with a stop there. Each is the motion of the centre of mass in one step, in its frame at
/// the step's beginning [m, rad].
struct ApproachPlan {
  std::vector<Pose2> steps;
  bool complete = false;  ///< the last step ends at the target; else more steps than were allowed are needed

  /// Mean speed of the first step [m/s, rad/s].
  Vec2 velocity = Vec2::Zero();
  double turn = 0;
};

/// Where the robot counts as having arrived.
struct ApproachTolerance {
  double position = 0.01;  ///< [m]
  double heading = 0.05;   ///< [rad]
};

/// Plans the steps to a pose in the robot's frame, starting from the present speed. Every step is as long as
/// the limits of speed and acceleration allow, and short enough that the next steps can stop at the target.
ApproachPlan planApproach(const Pose2& target, const Vec2& velocity, double turn,
                          const WalkParameters& limits, const ApproachTolerance& tolerance = {},
                          std::size_t maxSteps = 200);

}  // namespace plumbline::walking
