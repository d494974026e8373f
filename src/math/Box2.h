#pragma once
#include <algorithm>

#include "math/Types.h"

namespace plumbline {

/// A rectangle along the axes [m]. Its border is outside, where it is inside in Eigen's AlignedBox.
struct Box2 {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();

  bool contains(const Vec2& p) const {
    return p.x() > low.x() && p.x() < high.x() && p.y() > low.y() && p.y() < high.y();
  }
  /// Whether the way from a to b leads through it; along its border does not count.
  bool meets(const Vec2& a, const Vec2& b) const {
    double from = 0, to = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double way = b[axis] - a[axis], before = low[axis] - a[axis], behind = high[axis] - a[axis];
      if (way == 0) {
        if (before >= 0 || behind <= 0) return false;
        continue;
      }
      from = std::max(from, std::min(before / way, behind / way));
      to = std::min(to, std::max(before / way, behind / way));
    }
    return from < to;
  }
};

}  // namespace plumbline
