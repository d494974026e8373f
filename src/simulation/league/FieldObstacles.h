#pragma once
#include <vector>

#include "field/FieldSize.h"
#include "math/Types.h"
#include "robot/RobotModel.h"

namespace plumbline::simulation {

constexpr double ballMass = 0.026;  ///< of the league's ball [kg]

/// A shape that stands on the field and never moves.
struct FieldObstacle {
  Shape shape;
  Pose3 T_world_shape;
};

/// The sides, back and top of both goals and the walls around the field (soccer.rsg). Walls are half a metre
/// high. Their inner faces are 0.333 of its length, less half a metre, behind the goal lines: 9.49 m on the
/// league's field. Beside the side lines they are 0.75 of its width, less half a metre: 14.5 m.
std::vector<FieldObstacle> fieldObstacles(const FieldSize& field);

}  // namespace plumbline::simulation
