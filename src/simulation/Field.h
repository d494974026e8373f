#pragma once
#include <vector>

#include "math/Types.h"
#include "robot/RobotModel.h"

namespace plumbline::simulation {

// The soccer field of the league's server (rcssserver3d 0.7.3: naosoccersim.rb, soccer.rsg, goal.rsg,
// ball.rsg).
constexpr double fieldLength = 30, fieldWidth = 20;                   ///< between the lines [m]
constexpr double goalWidth = 2.1, goalDepth = 0.6, goalHeight = 0.8;  ///< inside the posts [m]
constexpr double goalBarDiameter = 0.04;                              ///< of posts, back and top [m]
constexpr double ballRadius = 0.042, ballMass = 0.026;                ///< [m], [kg]
constexpr double gravity = 9.81;                                      ///< [m/s^2]

/// A shape that stands on the field and never moves.
struct FieldObstacle {
  Shape shape;
  Pose3 T_world_shape;
};

/// The sides, back and top of both goals and the walls around the field (half a metre high, their inner
/// faces 9.49 m behind the goal lines and 14.5 m beside the side lines).
std::vector<FieldObstacle> fieldObstacles();

}  // namespace plumbline::simulation
