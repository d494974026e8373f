#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "field/FieldSize.h"
#include "math/Types.h"

namespace plumbline {

/// A point of the field that robots identify by its name [m].
struct FieldFlag {
  std::string_view name;
  Vec3 position;
};

/// A straight line on the ground [m].
struct FieldLine {
  Vec3 begin, end;
};

/// What robots of the 3D league see of a field, in the order in which its server lists it (soccer.rsg).
/// Frame: origin in the middle, x to the right goal, z up.
struct FieldMarks {
  static constexpr std::size_t numStraightLines = 11, numCircleChords = 10;

  FieldMarks() : FieldMarks(FieldSize()) {}
  explicit FieldMarks(const FieldSize& size);

  /// Goal posts at the height of the bar, then corners.
  std::array<FieldFlag, 8> flags;
  /// Half-way line, goal lines, side lines, penalty areas (these are straight), centre circle in ten chords.
  std::array<FieldLine, numStraightLines + numCircleChords> lines;
};

}  // namespace plumbline
