#include "modules/modeling/selflocator/FieldMap.h"

#include <cmath>

#include "math/Angle.h"

namespace plumbline {
namespace {
constexpr std::array<std::string_view, FieldMap::numLandmarks> names = {"F1L", "F2L", "F1R", "F2R",
                                                                        "G1L", "G2L", "G1R", "G2R"};
}

FieldMap::FieldMap(const FieldSize& size, bool leftSide) : size_(size) {
  const double x = size.length / 2, y = size.width / 2, post = size.goalWidth / 2;
  const double side = leftSide ? 1 : -1;
  landmarks_ = {Vec2(-x, y),    Vec2(-x, -y),    Vec2(x, y),    Vec2(x, -y),
                Vec2(-x, post), Vec2(-x, -post), Vec2(x, post), Vec2(x, -post)};
  for (Vec2& landmark : landmarks_) landmark *= side;

  // The lines look the same after half a turn, only their order would change.
  std::size_t count = 0;
  const auto add = [&](const Vec2& start, const Vec2& end) {
    FieldSegment& segment = segments_[count++];
    segment.start = start;
    segment.length = (end - start).norm();
    segment.direction = (end - start) / segment.length;
    segment.normal = Vec2(-segment.direction.y(), segment.direction.x());
  };
  add({0, -y}, {0, y});
  for (const double s : {-1.0, 1.0}) {
    add({s * x, -y}, {s * x, y});
    add({-x, s * y}, {x, s * y});
    const double front = x - size.penaltyDepth, half = size.penaltyWidth / 2;
    add({s * front, -half}, {s * front, half});
    for (const double t : {-1.0, 1.0}) add({s * front, t * half}, {s * x, t * half});
  }
  const auto onCircle = [&](int i) {
    const double angle = 2 * pi * i / numCircleSegments;
    return Vec2(size.centreCircleRadius * std::cos(angle), size.centreCircleRadius * std::sin(angle));
  };
  for (int i = 0; i < numCircleSegments; ++i) add(onCircle(i), onCircle(i + 1));
}

int FieldMap::landmarkIndex(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<int>(i);
  return -1;
}

}  // namespace plumbline
