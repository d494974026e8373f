#include "field/FieldMarks.h"

#include <cmath>

#include "math/Angle.h"

namespace plumbline {

namespace {

Vec3 ground(double x, double y) { return Vec3(x, y, 0); }

}  // namespace

FieldMarks::FieldMarks(const FieldSize& size) {
  const double x = size.length / 2, y = size.width / 2, post = size.goalWidth / 2;
  const double front = x - size.penaltyDepth, side = size.penaltyWidth / 2;
  flags = {{{"G1L", Vec3(-x, post, size.goalHeight)},
            {"G2L", Vec3(-x, -post, size.goalHeight)},
            {"G2R", Vec3(x, -post, size.goalHeight)},
            {"G1R", Vec3(x, post, size.goalHeight)},
            {"F1L", ground(-x, y)},
            {"F2L", ground(-x, -y)},
            {"F1R", ground(x, y)},
            {"F2R", ground(x, -y)}}};
  lines = {{{ground(0, -y), ground(0, y)},
            {ground(x, -y), ground(x, y)},
            {ground(-x, -y), ground(-x, y)},
            {ground(x, y), ground(-x, y)},
            {ground(x, -y), ground(-x, -y)},
            {ground(front, side), ground(front, -side)},
            {ground(front, side), ground(x, side)},
            {ground(front, -side), ground(x, -side)},
            {ground(-front, side), ground(-front, -side)},
            {ground(-front, side), ground(-x, side)},
            {ground(-front, -side), ground(-x, -side)}}};
  constexpr int chords = numCircleChords;
  for (int i = 0; i < chords; ++i) {
    const double begin = 2 * pi * i / chords, end = 2 * pi * (i + 1) / chords;
    lines[numStraightLines + static_cast<std::size_t>(i)] = {
        size.centreCircleRadius * ground(std::cos(begin), std::sin(begin)),
        size.centreCircleRadius * ground(std::cos(end), std::sin(end))};
  }
}

}  // namespace plumbline
