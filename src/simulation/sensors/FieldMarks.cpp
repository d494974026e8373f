#include "simulation/sensors/FieldMarks.h"

#include <cmath>

#include "math/Angle.h"
#include "simulation/Field.h"

namespace plumbline::simulation {

namespace {

constexpr double halfLength = fieldLength / 2, halfWidth = fieldWidth / 2;
constexpr double penaltyX = halfLength - 1.8, penaltyY = 3;
constexpr int circleChords = 10;

Vec3 ground(double x, double y) { return Vec3(x, y, 0); }

std::array<FieldLine, 21> makeLines() {
  std::array<FieldLine, 21> lines = {{
      {ground(0, -halfWidth), ground(0, halfWidth)},
      {ground(halfLength, -halfWidth), ground(halfLength, halfWidth)},
      {ground(-halfLength, -halfWidth), ground(-halfLength, halfWidth)},
      {ground(halfLength, halfWidth), ground(-halfLength, halfWidth)},
      {ground(halfLength, -halfWidth), ground(-halfLength, -halfWidth)},
      {ground(penaltyX, penaltyY), ground(penaltyX, -penaltyY)},
      {ground(penaltyX, penaltyY), ground(halfLength, penaltyY)},
      {ground(penaltyX, -penaltyY), ground(halfLength, -penaltyY)},
      {ground(-penaltyX, penaltyY), ground(-penaltyX, -penaltyY)},
      {ground(-penaltyX, penaltyY), ground(-halfLength, penaltyY)},
      {ground(-penaltyX, -penaltyY), ground(-halfLength, -penaltyY)},
  }};
  for (int i = 0; i < circleChords; ++i) {
    const double begin = 2 * pi * i / circleChords, end = 2 * pi * (i + 1) / circleChords;
    lines[numStraightLines + static_cast<std::size_t>(i)] = {
        centreCircleRadius * ground(std::cos(begin), std::sin(begin)),
        centreCircleRadius * ground(std::cos(end), std::sin(end))};
  }
  return lines;
}

}  // namespace

const std::array<Flag, 8>& flags() {
  static const std::array<Flag, 8> all = {{
      {"G1L", Vec3(-halfLength, goalWidth / 2, goalHeight)},
      {"G2L", Vec3(-halfLength, -goalWidth / 2, goalHeight)},
      {"G2R", Vec3(halfLength, -goalWidth / 2, goalHeight)},
      {"G1R", Vec3(halfLength, goalWidth / 2, goalHeight)},
      {"F1L", ground(-halfLength, halfWidth)},
      {"F2L", ground(-halfLength, -halfWidth)},
      {"F1R", ground(halfLength, halfWidth)},
      {"F2R", ground(halfLength, -halfWidth)},
  }};
  return all;
}

const std::array<FieldLine, 21>& fieldLines() {
  static const std::array<FieldLine, 21> all = makeLines();
  return all;
}

}  // namespace plumbline::simulation
