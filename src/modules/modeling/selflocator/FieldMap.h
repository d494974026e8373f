#pragma once
#include <array>
#include <string_view>

#include "field/FieldSize.h"
#include "math/Types.h"

namespace plumbline {

/// A straight line of the field from start along the unit vector direction; normal is its left [m].
struct FieldSegment {
  Vec2 start = Vec2::Zero();
  Vec2 direction = Vec2::UnitX();
  Vec2 normal = Vec2::UnitY();
  double length = 0;
};

/// Landmarks and lines of SimSpark's field in the team's frame (opponent goal at +x). The server's names do
/// not change with the side: the map of the right team is turned by 180 degrees.
class FieldMap {
public:
  static constexpr int numLandmarks = 8;
  static constexpr int numCircleSegments = 10;
  static constexpr int numSegments = 11 + numCircleSegments;

  FieldMap(const FieldSize& size, bool leftSide);

  /// Index of F1L F2L F1R F2R G1L G2L G1R G2R (flags in the corners, goal posts), -1 for another name.
  static int landmarkIndex(std::string_view name);
  const Vec2& landmark(int index) const { return landmarks_[static_cast<std::size_t>(index)]; }
  /// Centre line, goal lines, side lines, penalty areas, ring of ten chords.
  const std::array<FieldSegment, numSegments>& segments() const { return segments_; }
  const FieldSize& size() const { return size_; }

private:
  FieldSize size_;
  std::array<Vec2, numLandmarks> landmarks_;
  std::array<FieldSegment, numSegments> segments_;
};

}  // namespace plumbline
