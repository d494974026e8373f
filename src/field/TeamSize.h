#pragma once

namespace plumbline {

/// Players of a full team; their uniform numbers begin at 1.
inline constexpr int teamSize = 11;

constexpr bool isUniformNumber(int number) { return number >= 1 && number <= teamSize; }

}  // namespace plumbline
