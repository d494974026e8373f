#include "watch/FieldPicture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "watch/DotCanvas.h"

namespace plumbline::watch {
namespace {

using simspark::FieldState;
using simspark::TeamSide;

const FieldPictureStyle plain{.unicode = false, .colours = false};

std::string all(const TextPicture& picture) {
  std::string text;
  for (int row = 0; row < picture.rows(); ++row) text += picture.row(row) + '\n';
  return text;
}

int count(const std::string& text, const std::string& word) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++n;
  return n;
}

TEST(DotCanvas, brailleAndAscii) {
  DotCanvas canvas(4, 2);
  canvas.line({0, 0}, {0, 7});
  canvas.line({2, 1}, {7, 1});
  EXPECT_EQ(canvas.braille(0, 0), U'⡇');
  EXPECT_EQ(canvas.ascii(0, 1), U'|');
  EXPECT_EQ(canvas.braille(1, 0), U'⠒');
  EXPECT_EQ(canvas.ascii(3, 0), U'-');
  EXPECT_EQ(canvas.braille(3, 1), 0u);
  EXPECT_EQ(canvas.ascii(3, 1), 0u);
  canvas.line({-50, 3}, {50, 3});  // outside: nothing happens
  EXPECT_EQ(canvas.ascii(0, 0), U'+');
}

TEST(FieldPicture, headTellsTheGame) {
  FieldState state;
  state.time = 83.42;
  state.half = 1;
  state.scoreRight = 2;
  state.playMode = "PlayOn";
  state.teamLeft = "Red";
  state.teamRight = "Blue";
  const auto picture = fieldPicture(state, 80, 24, plain, "server:3201");
  EXPECT_EQ(picture.row(0), "                   Red 0 : 2 Blue   PlayOn   1:23.4   half 1");
  EXPECT_EQ(picture.row(23), "server:3201");
  EXPECT_EQ(picture.at(19, 0).ink, Ink::left);
  EXPECT_EQ(picture.at(30, 0).ink, Ink::right);
}

TEST(FieldPicture, robotsStandWhereTheyAre) {
  FieldState state;
  state.ball = Vec3(0, 0, 0.042);
  state.robots = {{TeamSide::left, 1, Vec2(-15, 0), 0, false},
                  {TeamSide::right, 11, Vec2(15, 10), M_PI, false},
                  {TeamSide::left, 7, Vec2(0, -10), M_PI / 2, true},
                  {TeamSide::none, 0, Vec2(7.5, 5), -M_PI / 4, false}};
  const auto picture = fieldPicture(state, 127, 44, plain, "");  // two columns or one row a half metre
  const auto column = [&](double x) { return static_cast<int>(std::floor(63.5 + x * 127 / 31.7)); };
  const auto row = [&](double y) { return 1 + static_cast<int>(std::floor(21 - y * 127 / 31.7 / 2)); };
  EXPECT_EQ(picture.at(column(0), row(0)).glyph, U'o');
  EXPECT_EQ(picture.at(column(0), row(0)).ink, Ink::ball);
  EXPECT_EQ(picture.at(column(-15) - 1, row(0)).glyph, U'L');
  EXPECT_EQ(picture.at(column(-15), row(0)).glyph, U'1');
  EXPECT_EQ(picture.at(column(-15) + 1, row(0)).glyph, U'>');
  EXPECT_EQ(picture.at(column(-15), row(0)).ink, Ink::left);
  EXPECT_EQ(picture.row(row(10)).substr(static_cast<std::size_t>(column(15) - 1), 4), "R11<");
  EXPECT_EQ(picture.row(row(-10)).substr(static_cast<std::size_t>(column(0) - 1), 3), "L7x");
  EXPECT_EQ(picture.at(column(7.5), row(5)).glyph, U'?');
  EXPECT_EQ(picture.at(column(7.5) + 1, row(5)).glyph, U'\\');
}

TEST(FieldPicture, whoIsOutsideStandsAtTheBorder) {
  FieldState state;
  state.ball = Vec3(1e6, -1e6, 0);
  state.robots = {{TeamSide::left, 4, Vec2(-500, 500), 0, false},
                  {TeamSide::right, 5, Vec2(30, 0), 0, false}};
  const auto picture = fieldPicture(state, 80, 24, plain, "foot");
  EXPECT_EQ(picture.row(1).substr(0, 3), "L4>");
  EXPECT_EQ(picture.at(77, 12).glyph, U'R');
  EXPECT_EQ(picture.at(79, 22).glyph, U'o');
}

TEST(FieldPicture, twoAndTwentyAtTheSmallestSizeOfATerminal) {
  FieldState state;
  for (int i = 0; i < 22; ++i)
    state.robots.push_back({i < 11 ? TeamSide::left : TeamSide::right, i % 11 + 1,
                            Vec2(-13 + 2.5 * (i % 11), i < 11 ? 6 : -6), 0, false});
  const std::string text = all(fieldPicture(state, 80, 24, plain, ""));
  EXPECT_EQ(count(text, "L"), 11);
  EXPECT_EQ(count(text, "R"), 11);
  for (int unum = 1; unum <= 11; ++unum) EXPECT_EQ(count(text, "R" + std::to_string(unum) + ">"), 1) << unum;
}

TEST(FieldPicture, unicodeAndColours) {
  FieldState state;
  state.robots = {{TeamSide::left, 3, Vec2(5, 5), 3 * M_PI / 4, false}};
  state.teamLeft = "Gr\xc3\xb6\xc3\x9f\x65\xff\x01";
  const auto picture = fieldPicture(state, 80, 24, {}, "");
  const std::string text = all(picture);
  EXPECT_EQ(count(text, "3↖"), 1) << text;
  EXPECT_EQ(count(text, "●"), 1);
  EXPECT_EQ(count(picture.row(0), "Größe?? 0 : 0 right"), 1) << picture.row(0);
  EXPECT_EQ(count(all(fieldPicture(state, 80, 24, plain, "")), "\xc3"), 0) << "ASCII only";
}

TEST(FieldPicture, tooSmallAndProblems) {
  EXPECT_EQ(fieldPicture({}, 30, 5, {}, "").row(0), "30 x 5: too small");
  EXPECT_EQ(fieldPicture({}, 0, 0, {}, "").rows(), 0);
  const auto picture = fieldPicture({}, 60, 20, plain, "", "the simulator has gone");
  EXPECT_EQ(count(picture.row(10), " the simulator has gone "), 1);
}

TEST(ClockText, minutesSecondsTenths) {
  EXPECT_EQ(clockText(0), "0:00.0");
  EXPECT_EQ(clockText(59.96), "1:00.0");
  EXPECT_EQ(clockText(600), "10:00.0");
  EXPECT_EQ(clockText(-3), "0:00.0");
}

}  // namespace
}  // namespace plumbline::watch
