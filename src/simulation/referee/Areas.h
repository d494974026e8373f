#pragma once
#include <algorithm>
#include <cmath>

#include "math/Types.h"
#include "simspark/TeamSide.h"
#include "simulation/Field.h"

namespace plumbline::simulation {

constexpr double penaltyDepth = 1.8, penaltyWidth = 3.9 + goalWidth;  ///< of the penalty area [m]

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

inline Area penaltyArea(simspark::TeamSide side) {
  const double inner = sign(side) * (fieldLength / 2 - penaltyDepth), line = sign(side) * fieldLength / 2;
  return {{std::min(inner, line), -penaltyWidth / 2}, {std::max(inner, line), penaltyWidth / 2}};
}

/// With ten metres beyond the lines, so that nobody sneaks up from behind.
inline Area halfOf(simspark::TeamSide side) {
  const double end = sign(side) * (fieldLength / 2 + 10);
  return {{std::min(0.0, end), -fieldWidth / 2 - 10}, {std::max(0.0, end), fieldWidth / 2 + 10}};
}

/// The corner of the penalty area the place is in that is nearest to midfield on the place's side (y < 0 or
/// not); places elsewhere stay.
inline Vec3 outOfPenaltyAreas(Vec3 place) {
  for (const auto side : {simspark::TeamSide::left, simspark::TeamSide::right}) {
    if (!penaltyArea(side).contains(place.head<2>())) continue;
    place.x() = sign(side) * (fieldLength / 2 - penaltyDepth);
    place.y() = place.y() < 0 ? -penaltyWidth / 2 : penaltyWidth / 2;
    break;
  }
  return place;
}

}  // namespace plumbline::simulation
