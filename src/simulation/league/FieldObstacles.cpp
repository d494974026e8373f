#include "simulation/league/FieldObstacles.h"

namespace plumbline::simulation {

namespace {

FieldObstacle box(const Vec3& size, const Vec3& centre) {
  Shape shape;
  shape.kind = Shape::Kind::box;
  shape.size = size;
  return {shape, translation(centre)};
}

void addGoal(const FieldSize& field, double side, std::vector<FieldObstacle>& obstacles) {
  const double bar = field.goalBarDiameter, goalDepth = field.goalDepth, goalWidth = field.goalWidth,
               goalHeight = field.goalHeight;
  const double centre = side * (field.length + goalDepth) / 2;
  const double height = goalHeight / 2;
  for (const double y : {-1.0, 1.0})
    obstacles.push_back(box({goalDepth, bar, goalHeight}, {centre, y * (goalWidth + bar) / 2, height}));
  obstacles.push_back(box({bar, goalWidth, goalHeight}, {centre + side * (goalDepth - bar) / 2, 0, height}));
  obstacles.push_back(box({goalDepth, goalWidth + 2 * bar, bar}, {centre, 0, goalHeight + bar / 2}));
}

}  // namespace

std::vector<FieldObstacle> fieldObstacles(const FieldSize& field) {
  const double borderX = field.length * 0.333, borderY = field.width * 0.75, wall = 1;
  const double lengthX = wall + field.length + 2 * borderX, lengthY = wall + field.width + 2 * borderY;
  std::vector<FieldObstacle> obstacles;
  for (const double side : {-1.0, 1.0}) {
    addGoal(field, side, obstacles);
    obstacles.push_back(box({wall, lengthY, wall}, {side * (field.length / 2 + borderX), 0, 0}));
    obstacles.push_back(box({lengthX, wall, wall}, {0, side * (field.width / 2 + borderY), 0}));
  }
  return obstacles;
}

}  // namespace plumbline::simulation
