#pragma once
#include <string>
#include <vector>

#include "simspark/FieldMessage.h"

namespace plumbline::watch {

/// What a character of a picture belongs to; a terminal gives it a colour.
enum class Ink { plain, line, left, right, nobody, ball, problem };

struct Cell {
  char32_t glyph = U' ';
  Ink ink = Ink::plain;
};

/// A picture made of characters, row by row from the top.
class TextPicture {
public:
  TextPicture(int columns, int rows);
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const Cell& at(int column, int row) const { return cells_[index(column, row)]; }
  /// What lies outside is not drawn.
  void put(int column, int row, char32_t glyph, Ink ink);
  void write(int column, int row, const std::u32string& text, Ink ink);
  /// A row in UTF-8 without the blanks at its end.
  std::string row(int row) const;

private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int columns_, rows_;
  std::vector<Cell> cells_;
};

struct FieldPictureStyle {
  bool unicode = true;  ///< else ASCII alone
  bool colours = true;  ///< else the letters L and R stand before the robots' numbers
};

/// Least size in which something can be recognised.
constexpr int minPictureColumns = 40, minPictureRows = 12;

/// The field from above with robots (number, direction; a cross instead of the direction: fallen) and ball;
/// over it teams, score, play mode and time, under it `footer` (UTF-8). Metres are as long as they are high
/// if a character is twice as high as wide. `problem` is shown in the middle if it is not empty.
TextPicture fieldPicture(const simspark::FieldState& state, int columns, int rows,
                         const FieldPictureStyle& style, const std::string& footer,
                         const std::string& problem = "");

/// 83.4 s: "1:23.4".
std::string clockText(double seconds);

}  // namespace plumbline::watch
