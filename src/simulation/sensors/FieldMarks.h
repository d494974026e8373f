#pragma once
#include <array>
#include <cstddef>
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
constexpr double centreCircleRadius = 2;  ///< [m]
constexpr std::size_t numStraightLines = 11;
/// Half-way line, goal lines, side lines, penalty areas (these are straight), centre circle in ten chords.
const std::array<FieldLine, 21>& fieldLines();

}  // namespace plumbline::simulation
