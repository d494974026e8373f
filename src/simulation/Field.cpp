#include "simulation/Field.h"

namespace plumbline::simulation {

namespace {

FieldObstacle box(const Vec3& size, const Vec3& centre) {
  Shape shape;
  shape.kind = Shape::Kind::box;
  shape.size = size;
  return {shape, translation(centre)};
}

void addGoal(double side, std::vector<FieldObstacle>& obstacles) {
  const double bar = goalBarDiameter;
  const double centre = side * (fieldLength + goalDepth) / 2;
  const double height = goalHeight / 2;
  for (const double y : {-1.0, 1.0})
    obstacles.push_back(box({goalDepth, bar, goalHeight}, {centre, y * (goalWidth + bar) / 2, height}));
  obstacles.push_back(box({bar, goalWidth, goalHeight}, {centre + side * (goalDepth - bar) / 2, 0, height}));
  obstacles.push_back(box({goalDepth, goalWidth + 2 * bar, bar}, {centre, 0, goalHeight + bar / 2}));
}

}  // namespace

std::vector<FieldObstacle> fieldObstacles() {
  constexpr double borderX = fieldLength * 0.333, borderY = fieldWidth * 0.75, wall = 1;
  constexpr double lengthX = wall + fieldLength + 2 * borderX, lengthY = wall + fieldWidth + 2 * borderY;
  std::vector<FieldObstacle> obstacles;
  for (const double side : {-1.0, 1.0}) {
    addGoal(side, obstacles);
    obstacles.push_back(box({wall, lengthY, wall}, {side * (fieldLength / 2 + borderX), 0, 0}));
    obstacles.push_back(box({lengthX, wall, wall}, {0, side * (fieldWidth / 2 + borderY), 0}));
  }
  return obstacles;
}

}  // namespace plumbline::simulation
