#include "watch/DotCanvas.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace plumbline::watch {

namespace {
constexpr int dotsAcross = 2, dotsDown = 4;
/// Bit of Unicode's Braille block for dot 2 y + x.
constexpr std::uint8_t brailleBits[8] = {0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};
constexpr std::uint8_t leftColumn = 0x55, rightColumn = 0xaa;
}  // namespace

DotCanvas::DotCanvas(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void DotCanvas::dot(int x, int y) {
  if (x < 0 || y < 0 || x >= columns_ * dotsAcross || y >= rows_ * dotsDown) return;
  const int cell = y / dotsDown * columns_ + x / dotsAcross;
  const int bit = y % dotsDown * dotsAcross + x % dotsAcross;
  cells_[static_cast<std::size_t>(cell)] |= static_cast<std::uint8_t>(1 << bit);
}

void DotCanvas::line(const Vec2& from, const Vec2& to) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).lpNorm<Eigen::Infinity>())));
  for (int i = 0; i <= steps; ++i) {
    const Vec2 at = from + (to - from) * i / steps;
    dot(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
  }
}

std::uint8_t DotCanvas::bits(int column, int row) const {
  return cells_[static_cast<std::size_t>(row * columns_ + column)];
}

char32_t DotCanvas::braille(int column, int row) const {
  const unsigned dots = bits(column, row);
  char32_t glyph = 0;
  for (unsigned i = 0; i < 8; ++i)
    if (dots >> i & 1) glyph |= brailleBits[i];
  return glyph ? 0x2800 + glyph : 0;
}

char32_t DotCanvas::ascii(int column, int row) const {
  const std::uint8_t dots = bits(column, row);
  if (dots == 0) return 0;
  const bool upright = std::max(std::popcount(static_cast<unsigned>(dots & leftColumn)),
                                std::popcount(static_cast<unsigned>(dots & rightColumn))) >= 3;
  bool level = false;
  for (int y = 0; y < dotsDown; ++y) level = level || (dots >> (dotsAcross * y) & 3) == 3;
  return upright && level ? U'+' : upright ? U'|' : level ? U'-' : U'.';
}

}  // namespace plumbline::watch
