#include "situation/SituationCanvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace plumbline {
namespace {

constexpr double playerRadius = 10, ballRadius = 6, headingLength = 24;  // of their marks [pixels]

std::string circle(const Vec2& at, double radius, const std::string& style) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", at.x(), at.y(), radius,
                     style);
}

Vec2 along(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

void SituationCanvas::disc(const Vec2& pixels, const char* colour, int number) {
  svg_ += circle(pixels, playerRadius, fmt::format("fill=\"{}\" stroke=\"black\"", colour));
  if (number > 0)
    svg_ += svgText(pixels.x(), pixels.y() + 4, std::to_string(number),
                    "fill=\"white\" font-size=\"11\" font-weight=\"bold\" text-anchor=\"middle\"");
}

void SituationCanvas::player(bool mate, const Vec2& place, int number) {
  disc(field_.pixels(place), mate ? own : opponent, number);
}

void SituationCanvas::player(const Pose2& pose, int number, bool decides) {
  const Vec2 at = field_.pixels(pose.position);
  const Vec2 tip = at + headingLength * Vec2(std::cos(pose.heading), -std::sin(pose.heading));
  svg_ += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
      "stroke-width=\"5\" stroke-linecap=\"round\"/>\n",
      at.x(), at.y(), tip.x(), tip.y(), own);
  disc(at, own, number);
  if (decides) svg_ += circle(at, playerRadius + 3, "fill=\"none\" stroke=\"white\" stroke-width=\"3\"");
}

void SituationCanvas::ball(const Vec2& place) {
  svg_ += circle(field_.pixels(place), ballRadius, fmt::format("fill=\"{}\" stroke=\"black\"", ballColour));
}

/// With a head at its end.
void SituationCanvas::line(const Vec2& from, const Vec2& to, const std::string& style, const char* colour) {
  const Vec2 begin = field_.pixels(from), end = field_.pixels(to);
  const double length = (end - begin).norm();
  if (length < 1) return;
  const Vec2 ahead = (end - begin) / length, aside(-ahead.y(), ahead.x());
  const double head = std::min(10.0, 0.6 * length);
  const Vec2 neck = end - head * ahead, left = neck + 0.5 * head * aside, right = neck - 0.5 * head * aside;
  svg_ += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" {}/>\n"
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}z\" fill=\"{}\"/>\n",
      begin.x(), begin.y(), neck.x(), neck.y(), colour, style, end.x(), end.y(), left.x(), left.y(),
      right.x(), right.y(), colour);
}

void SituationCanvas::motion(const Vec2& from, const Vec2& to, const char* colour) {
  line(from, to, "stroke-width=\"2\" stroke-dasharray=\"6 4\"", colour);
}

void SituationCanvas::arrow(const Vec2& from, const Vec2& to) {
  line(from, to, "stroke-width=\"3\"", expected);
}

void SituationCanvas::ring(const Vec2& place, double radius) {
  svg_ +=
      circle(field_.pixels(place), std::max(4.0, field_.length(radius)),
             fmt::format("fill=\"{0}\" fill-opacity=\"0.25\" stroke=\"{0}\" stroke-width=\"2\"", expected));
}

void SituationCanvas::sector(const Vec2& from, double radius, double least, double most) {
  constexpr int parts = 24;
  const Vec2 corner = field_.pixels(from);
  std::string points = fmt::format("{:.1f},{:.1f}", corner.x(), corner.y());
  for (int i = 0; i <= parts; ++i) {
    const Vec2 at = field_.pixels(from + radius * along(least + (most - least) * i / parts));
    fmt::format_to(std::back_inserter(points), " {:.1f},{:.1f}", at.x(), at.y());
  }
  svg_ += fmt::format("<polygon points=\"{0}\" fill=\"{1}\" fill-opacity=\"0.25\" stroke=\"{1}\"/>\n", points,
                      expected);
}

void SituationCanvas::area(const Vec2& from, const Vec2& to) {
  svg_ += field_.rectangle(
      from, to,
      fmt::format("fill=\"{0}\" fill-opacity=\"0.25\" stroke=\"{0}\" stroke-width=\"2\"", expected));
}

void SituationCanvas::label(const Vec2& place, const std::string& words) {
  const Vec2 at = field_.pixels(place);
  // Away from the nearer edge.
  const bool right = at.x() > 0.6 * field_.width();
  const double y = std::clamp(at.y() - 16, 16.0, std::max(16.0, field_.height() - 6));
  svg_ += svgText(at.x() + (right ? -12 : 12), y, words,
                  fmt::format("fill=\"{}\" stroke=\"#123018\" stroke-width=\"3\" paint-order=\"stroke\" "
                              "font-weight=\"bold\" text-anchor=\"{}\"",
                              expected, right ? "end" : "start"));
}

void SituationCanvas::way(const Vec2& from, const Vec2& place, double within, const std::string& words) {
  ring(place, within);
  arrow(from, place);
  label(place, words);
}

}  // namespace plumbline
