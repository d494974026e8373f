#pragma once
#include "parameters/Parameter.h"

namespace plumbline {

/// The sizes of a soccer field [m]; the defaults are the 3D league's (rcssserver3d 0.7.3: naosoccersim.rb,
/// soccer.rsg, goal.rsg, ball.rsg). Agent, simulator and pages all measure the field by this.
struct FieldSize {
  PARAMETERS(FieldSize)
  PARAMETER(double, length, 30, "m", Range(1, 1000), "between the goal lines")
  PARAMETER(double, width, 20, "m", Range(1, 1000), "between the side lines")
  PARAMETER(double, goalWidth, 2.1, "m", Range(0.1, 100), "between the posts")
  PARAMETER(double, goalDepth, 0.6, "m", Range(0.1, 100), "from the goal line to the back of the goal")
  PARAMETER(double, goalHeight, 0.8, "m", Range(0.1, 100), "below the bar")
  PARAMETER(double, goalBarDiameter, 0.04, "m", Range(0.001, 1), "of posts, bar and back")
  PARAMETER(double, penaltyDepth, 1.8, "m", Range(0.1, 100), "of the penalty area, from the goal line")
  PARAMETER(double, penaltyWidth, 6, "m", Range(0.1, 100), "of the penalty area, along the goal line")
  PARAMETER(double, centreCircleRadius, 2, "m", Range(0.1, 100), "drawn as ten straight chords")
  PARAMETER(double, ballRadius, 0.042, "m", Range(0.001, 1), "of the ball")

  bool operator==(const FieldSize&) const = default;
};

}  // namespace plumbline
