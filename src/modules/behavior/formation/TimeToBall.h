#pragma once
#include "math/Pose2.h"
#include "parameters/Parameter.h"
#include "robot/ExpectedRobot.h"

namespace plumbline {

struct TimeToBallParameters {
  PARAMETERS(TimeToBallParameters)
  PARAMETER(double, walkSpeed, expectedWalkSpeed, "m/s", Range(0.05, 3), "of a player on its way to the ball")
  PARAMETER(double, turnSpeed, expectedTurnSpeed, "rad/s", Range(0.1, 10), "the same on the spot")
  PARAMETER(double, wrongSide, 2.0, "s", Range(0, 20),
            "to get round the ball, for a player straight between ball and goal")
  PARAMETER(double, getUp, expectedGetUpSeconds, "s", Range(0, 60), "of a fallen player")
};

/// How long a player needs to stand behind the ball, facing the goal [s]: walk, turn to the ball, and the way
/// round it.
double timeToBall(const Pose2& player, bool fallen, const Vec2& ball, const Vec2& goal,
                  const TimeToBallParameters& parameters);

}  // namespace plumbline
