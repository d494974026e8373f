#include "watch/FieldPicture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/FieldMarks.h"
#include "watch/DotCanvas.h"

namespace plumbline::watch {

using simspark::FieldRobot;
using simspark::FieldState;
using simspark::TeamSide;

namespace {

/// Text from elsewhere: what is no printable character becomes a question mark.
std::u32string decode(const std::string& utf8, bool unicode) {
  std::u32string text;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i++]);
    const int more = first < 0x80       ? 0
                     : first >> 5 == 6  ? 1
                     : first >> 4 == 14 ? 2
                     : first >> 3 == 30 ? 3
                                        : -1;
    char32_t glyph = more <= 0 ? first : first & (0x3f >> more);
    int taken = 0;
    for (; taken < more && i < utf8.size() && (utf8[i] & 0xc0) == 0x80; ++taken)
      glyph = glyph << 6 | (static_cast<unsigned char>(utf8[i++]) & 0x3f);
    const bool printable = more >= 0 && taken == more && glyph >= 32 && glyph != 127 &&
                           (glyph < 128 || (unicode && glyph >= 0xa0 && glyph < 0x10000));
    text += printable ? glyph : U'?';
  }
  return text;
}

void encode(char32_t glyph, std::string& out) {
  if (glyph < 0x80) {
    out += static_cast<char>(glyph);
  } else if (glyph < 0x800) {
    out += static_cast<char>(0xc0 | glyph >> 6);
    out += static_cast<char>(0x80 | (glyph & 0x3f));
  } else {
    out += static_cast<char>(0xe0 | glyph >> 12);
    out += static_cast<char>(0x80 | (glyph >> 6 & 0x3f));
    out += static_cast<char>(0x80 | (glyph & 0x3f));
  }
}

Ink inkOf(TeamSide side) {
  return side == TeamSide::left ? Ink::left : side == TeamSide::right ? Ink::right : Ink::nobody;
}

/// Where the field lies on the grid: characters are taken to be twice as high as wide.
class Layout {
public:
  Layout(const FieldSize& field, int columns, int firstRow, int rows) : firstRow_(firstRow) {
    const double length = field.length + 2 * (field.goalDepth + margin);
    const double width = field.width + 2 * margin;
    perMetre_ = std::min(columns / length, 2.0 * rows / width);
    centre_ = Vec2(columns / 2.0, rows / 2.0);
  }
  /// In dots from the upper left corner of the field's rows: two a column, four a row.
  Vec2 dots(const Vec3& place) const {
    return {2 * (centre_.x() + place.x() * perMetre_) - 0.5,
            4 * (centre_.y() - place.y() * perMetre_ / 2) - 0.5};
  }
  int column(const Vec2& place) const { return toCell(centre_.x() + place.x() * perMetre_); }
  int row(const Vec2& place) const { return firstRow_ + toCell(centre_.y() - place.y() * perMetre_ / 2); }

private:
  static constexpr double margin = 0.25;  ///< around the field [m]
  static int toCell(double place) { return static_cast<int>(std::floor(std::clamp(place, -1e4, 1e4))); }
  int firstRow_;
  double perMetre_;
  Vec2 centre_;
};

void drawLines(TextPicture& picture, const FieldSize& field, const Layout& layout, int firstRow, int rows,
               bool unicode) {
  DotCanvas canvas(picture.columns(), rows);
  for (const FieldLine& line : FieldMarks(field).lines)
    canvas.line(layout.dots(line.begin), layout.dots(line.end));
  const double goal = field.length / 2, back = goal + field.goalDepth, post = field.goalWidth / 2;
  for (const double side : {-1.0, 1.0}) {
    canvas.line(layout.dots({side * goal, post, 0}), layout.dots({side * back, post, 0}));
    canvas.line(layout.dots({side * back, post, 0}), layout.dots({side * back, -post, 0}));
    canvas.line(layout.dots({side * back, -post, 0}), layout.dots({side * goal, -post, 0}));
  }
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < picture.columns(); ++column)
      if (const char32_t glyph = unicode ? canvas.braille(column, row) : canvas.ascii(column, row))
        picture.put(column, firstRow + row, glyph, Ink::line);
}

char32_t arrow(double heading, bool unicode) {
  const int eighth = static_cast<int>(std::lround(heading / (std::numbers::pi / 4))) & 7;
  return unicode ? U"→↗↑↖←↙↓↘"[eighth] : U">/^\\</v\\"[eighth];
}

void drawRobot(TextPicture& picture, const Layout& layout, const FieldRobot& robot,
               const FieldPictureStyle& style) {
  std::u32string label;
  if (!style.colours && robot.side != TeamSide::none) label += robot.side == TeamSide::left ? U'L' : U'R';
  label += robot.unum > 0 ? decode(std::to_string(robot.unum), false) : U"?";
  const int before = static_cast<int>(label.size()) / 2;
  label += robot.fallen ? (style.unicode ? U'×' : U'x') : arrow(robot.heading, style.unicode);
  // Those beyond the border stand at the border.
  const int last = picture.columns() - static_cast<int>(label.size());
  const int column = std::clamp(layout.column(robot.position) - before, 0, std::max(0, last));
  const int row = std::clamp(layout.row(robot.position), 1, picture.rows() - 2);
  picture.write(column, row, label, inkOf(robot.side));
}

void drawHead(TextPicture& picture, const FieldState& state, bool unicode) {
  const std::u32string left = decode(state.teamLeft.empty() ? "left" : state.teamLeft, unicode);
  const std::u32string right = decode(state.teamRight.empty() ? "right" : state.teamRight, unicode);
  const std::u32string score = decode(fmt::format(" {} : {} ", state.scoreLeft, state.scoreRight), unicode);
  const std::u32string rest =
      decode(fmt::format("   {}   {}   half {}", state.playMode.empty() ? "-" : state.playMode,
                         clockText(state.time), state.half),
             unicode);
  const auto length = static_cast<int>(left.size() + score.size() + right.size() + rest.size());
  int column = std::max(0, (picture.columns() - length) / 2);
  const auto add = [&](const std::u32string& text, Ink ink) {
    picture.write(column, 0, text, ink);
    column += static_cast<int>(text.size());
  };
  add(left, Ink::left);
  add(score, Ink::plain);
  add(right, Ink::right);
  add(rest, Ink::plain);
}

void writeCentred(TextPicture& picture, int row, const std::u32string& text, Ink ink) {
  picture.write(std::max(0, (picture.columns() - static_cast<int>(text.size())) / 2), row, text, ink);
}

}  // namespace

TextPicture::TextPicture(int columns, int rows)
    : columns_(std::max(0, columns)),
      rows_(std::max(0, rows)),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void TextPicture::put(int column, int row, char32_t glyph, Ink ink) {
  if (column >= 0 && row >= 0 && column < columns_ && row < rows_) cells_[index(column, row)] = {glyph, ink};
}

void TextPicture::write(int column, int row, const std::u32string& text, Ink ink) {
  for (const char32_t glyph : text) put(column++, row, glyph, ink);
}

std::string TextPicture::row(int row) const {
  std::string text;
  std::size_t end = 0;
  for (int column = 0; column < columns_; ++column) {
    encode(at(column, row).glyph, text);
    if (at(column, row).glyph != U' ') end = text.size();
  }
  text.resize(end);
  return text;
}

std::string clockText(double seconds) {
  const long tenths = std::lround(std::clamp(seconds, 0.0, 1e6) * 10);
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

TextPicture fieldPicture(const FieldState& state, int columns, int rows, const FieldPictureStyle& style,
                         const std::string& footer, const std::string& problem) {
  TextPicture picture(columns, rows);
  if (columns < minPictureColumns || rows < minPictureRows) {
    picture.write(0, 0, decode(fmt::format("{} x {}: too small", columns, rows), false), Ink::problem);
    return picture;
  }
  const int firstRow = 1, fieldRows = rows - 2;
  const Layout layout(state.field, columns, firstRow, fieldRows);
  drawLines(picture, state.field, layout, firstRow, fieldRows, style.unicode);
  // The nearer to the ball, the later drawn: where labels overlap, those count.
  std::vector<const FieldRobot*> order;
  for (const FieldRobot& robot : state.robots) order.push_back(&robot);
  const auto distance = [&](const FieldRobot* robot) {
    return (robot->position - state.ball.head<2>()).norm();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](const auto* a, const auto* b) { return distance(a) > distance(b); });
  for (const FieldRobot* robot : order) drawRobot(picture, layout, *robot, style);
  const Vec2 ball = state.ball.head<2>();
  picture.put(std::clamp(layout.column(ball), 0, columns - 1),
              std::clamp(layout.row(ball), firstRow, rows - 2), style.unicode ? U'●' : U'o', Ink::ball);
  drawHead(picture, state, style.unicode);
  picture.write(0, rows - 1, decode(footer, style.unicode), Ink::plain);
  if (!problem.empty())
    writeCentred(picture, rows / 2, decode(" " + problem + " ", style.unicode), Ink::problem);
  return picture;
}

}  // namespace plumbline::watch
