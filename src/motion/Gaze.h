#pragma once
#include <optional>
#include <vector>

#include "math/Pose2.h"

namespace plumbline::motion {

/// Direction of the head [rad]: yaw positive to the left, pitch positive downwards.
struct HeadAngles {
  double yaw = 0;
  double pitch = 0;
};

/// The head's joints and its camera [rad, m].
struct GazeParameters {
  double maxYaw = 2.05;       ///< reached by the neck, a little inside of the joint's limit
  double maxPitch = 0.75;     ///< downwards
  double minPitch = -0.3;     ///< upwards
  double halfView = 1.047;    ///< half the opening of the view cone, both axes
  double ballMargin = 0.2;    ///< the ball is kept this far inside of the cone
  double cameraHeight = 0.5;  ///< above the ground
  double scanYaw = 1.6;       ///< turning point of the scan
  double scanSeconds = 2.4;   ///< from the left to the right and back
};

/// Where to look for the ball to stay in view and, within that freedom, for as many landmarks as possible to
/// be in view too. ball: in the robot's ground frame; robot: T_field_robot, absent when not localised;
/// landmarks on the field [m]; current: yaw of the head now, kept when nothing is better.
HeadAngles lookAtBall(const Vec2& ball, const std::optional<Pose2>& robot, const std::vector<Vec2>& landmarks,
                      double current, const GazeParameters& parameters);

/// The scan for a lost ball, seconds after its begin; first towards that side (+1 left, -1 right).
HeadAngles scan(double seconds, double firstSide, const GazeParameters& parameters);

}  // namespace plumbline::motion
