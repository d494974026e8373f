#pragma once
#include <array>
#include <string_view>

#include "math/Types.h"

namespace plumbline::simulation {

// What the league's robots see of the field, in the order in which the server lists it (soccer.rsg).
struct Flag {
  std::string_view name;
  Vec3 position;
};
struct FieldLine {
  Vec3 begin, end;
};

/// Goal posts (at the height of the bar) and corners.
const std::array<Flag, 8>& flags();
/// Half-way line, goal lines, side lines, penalty areas, centre circle in ten chords.
const std::array<FieldLine, 21>& fieldLines();

}  // namespace plumbline::simulation
