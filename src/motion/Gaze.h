#pragma once
#include <optional>
#include <vector>

#include "math/Pose2.h"
#include "parameters/Parameter.h"

namespace plumbline::motion {

/// Direction of the head [rad]: yaw positive to the left, pitch positive downwards.
struct HeadAngles {
  double yaw = 0;
  double pitch = 0;
};

/// The head's joints and its camera [rad, m].
struct GazeParameters {
  PARAMETERS(GazeParameters)
  PARAMETER(double, maxYaw, 2.05, "rad", Range(0, 2.09),
            "reached by the neck, a little inside of the limit of the joint")
  PARAMETER(double, maxPitch, 0.75, "rad", Range(0, 0.78), "the same downwards")
  PARAMETER(double, minPitch, -0.3, "rad", Range(-0.78, 0), "the same upwards")
  PARAMETER(double, halfView, 1.047, "rad", Range(0.1, 1.5),
            "half the opening of the view of the camera, both axes")
  PARAMETER(double, ballMargin, 0.2, "rad", Range(0, 1), "the ball is kept this far inside of the view")
  PARAMETER(double, cameraHeight, 0.5, "m", Range(0.1, 2), "of the camera above the ground")
  PARAMETER(double, scanYaw, 2.05, "rad", Range(0.1, 2.09), "turning point of the scan for a lost ball")
  PARAMETER(double, scanSeconds, 1.4, "s", Range(0.5, 60), "of the scan from side to side and back")
};

/// Where to look for the ball to stay in view and, within that freedom, for as many landmarks as possible to
/// be in view too. ball: in the robot's ground frame; robot: T_field_robot, absent when not localised;
/// landmarks on the field [m]; current: yaw of the head now, kept when nothing is better.
HeadAngles lookAtBall(const Vec2& ball, const std::optional<Pose2>& robot, const std::vector<Vec2>& landmarks,
                      double current, const GazeParameters& parameters);

/// The scan for a lost ball, seconds after it began at the yaw `from` [rad]; first towards that side (+1
/// left, -1 right), then from side to side.
HeadAngles scan(double seconds, double from, double firstSide, const GazeParameters& parameters);

}  // namespace plumbline::motion
