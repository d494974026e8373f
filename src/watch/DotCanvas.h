#pragma once
#include <cstdint>
#include <vector>

#include "math/Types.h"

namespace plumbline::watch {

/// Dots on a grid of characters, two by four in each, as Braille has them.
class DotCanvas {
public:
  DotCanvas(int columns, int rows);
  /// From dot to dot, both included; x to the right, y down; what lies outside is not drawn.
  void line(const Vec2& from, const Vec2& to);
  /// The Braille character of a cell; 0: it is empty.
  char32_t braille(int column, int row) const;
  /// The ASCII character most like it; 0: it is empty.
  char32_t ascii(int column, int row) const;

private:
  void dot(int x, int y);
  std::uint8_t bits(int column, int row) const;

  int columns_, rows_;
  std::vector<std::uint8_t> cells_;  ///< a bit per dot, row by row: bit 2 y + x
};

}  // namespace plumbline::watch
