#pragma once
#include <algorithm>
#include <cmath>

#include "field/FieldSize.h"
#include "math/Types.h"
#include "simspark/TeamSide.h"

namespace plumbline::simulation {

/// A rectangle of the field, borders included [m].
struct Area {
  Vec2 low, high;

  bool contains(const Vec2& p) const {
    return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y();
  }
  bool meets(const Area& other) const {
    return low.x() <= other.high.x() && high.x() >= other.low.x() && low.y() <= other.high.y() &&
           high.y() >= other.low.y();
  }
  Area widened(double margin) const { return {low - Vec2::Constant(margin), high + Vec2::Constant(margin)}; }
};

/// -1 for the left half, 1 for the right.
constexpr double sign(simspark::TeamSide side) { return side == simspark::TeamSide::left ? -1 : 1; }

inline Area penaltyArea(const FieldSize& field, simspark::TeamSide side) {
  const double inner = sign(side) * (field.length / 2 - field.penaltyDepth),
               line = sign(side) * field.length / 2;
  return {{std::min(inner, line), -field.penaltyWidth / 2}, {std::max(inner, line), field.penaltyWidth / 2}};
}

/// With ten metres beyond the lines, so that no robot comes from behind.
inline Area halfOf(const FieldSize& field, simspark::TeamSide side) {
  const double end = sign(side) * (field.length / 2 + 10);
  return {{std::min(0.0, end), -field.width / 2 - 10}, {std::max(0.0, end), field.width / 2 + 10}};
}

/// The corner of the penalty area the place is in that is nearest to midfield on the place's side (y < 0 or
/// not); places elsewhere stay.
inline Vec3 outOfPenaltyAreas(const FieldSize& field, Vec3 place) {
  for (const auto side : {simspark::TeamSide::left, simspark::TeamSide::right}) {
    if (!penaltyArea(field, side).contains(place.head<2>())) continue;
    place.x() = sign(side) * (field.length / 2 - field.penaltyDepth);
    place.y() = place.y() < 0 ? -field.penaltyWidth / 2 : field.penaltyWidth / 2;
    break;
  }
  return place;
}

}  // namespace plumbline::simulation
