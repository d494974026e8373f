#include "game/TrackPicture.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace plumbline::game {

namespace {

constexpr double scale = 30;    // pixels per metre
constexpr double margin = 1.2;  // metres around the field

double px(double x) { return scale * (x + 15 + margin); }
double py(double y) { return scale * (10 + margin - y); }

std::string polyline(const std::vector<TrackPoint>& track, Vec2 TrackPoint::*member, const char* style) {
  std::string points;
  for (const TrackPoint& point : track)
    fmt::format_to(std::back_inserter(points), "{:.1f},{:.1f} ", px((point.*member).x()),
                   py((point.*member).y()));
  return fmt::format("<polyline points=\"{}\" {}/>\n", points, style);
}

std::string rectangle(double x0, double y0, double x1, double y1, const char* style) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", px(x0),
                     py(y1), scale * (x1 - x0), scale * (y1 - y0), style);
}

}  // namespace

std::string trackPicture(const std::vector<TrackPoint>& track, const std::string& title) {
  const char* line = "fill=\"none\" stroke=\"white\" stroke-width=\"2\"";
  const double width = scale * (30 + 2 * margin), height = scale * (20 + 2 * margin);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"15\">\n",
      width, height + 34);
  svg += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#3a7d44\"/>\n", width, height);
  svg += rectangle(-15, -10, 15, 10, line);
  svg += rectangle(-15, -3, -13.2, 3, line) + rectangle(13.2, -3, 15, 3, line);
  svg += rectangle(-15.6, -1.05, -15, 1.05, "fill=\"#f2d94e\" fill-opacity=\"0.5\" stroke=\"#f2d94e\"");
  svg += rectangle(15, -1.05, 15.6, 1.05, "fill=\"#8ec5ff\" fill-opacity=\"0.5\" stroke=\"#8ec5ff\"");
  svg += fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" {3}/>\n", px(0),
                     py(-10), py(10), line);
  svg +=
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.0f}\" {}/>\n", px(0), py(0), 2 * scale, line);
  svg += polyline(track, &TrackPoint::robot,
                  "fill=\"none\" stroke=\"#1c3faa\" stroke-width=\"3\" stroke-linejoin=\"round\"");
  svg += polyline(track, &TrackPoint::ball,
                  "fill=\"none\" stroke=\"#ff8c1a\" stroke-width=\"2\" stroke-linejoin=\"round\"");

  bool fallen = false;
  double nextLabel = 0;
  for (const TrackPoint& point : track) {
    if (point.fallen && !fallen)
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"#c00\" font-weight=\"bold\">fall</text>\n",
                         px(point.robot.x()) + 6, py(point.robot.y()) - 6);
    fallen = point.fallen;
    if (point.time < nextLabel) continue;
    svg += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"4\" fill=\"#1c3faa\"/><text x=\"{2:.1f}\" y=\"{3:.1f}\" "
        "fill=\"white\">{4:.0f} s</text>\n",
        px(point.robot.x()), py(point.robot.y()), px(point.robot.x()) + 5, py(point.robot.y()) + 18,
        point.time);
    nextLabel += 10;
  }
  if (!track.empty())
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\" fill=\"#ff8c1a\" stroke=\"black\"/>\n",
                       px(track.back().ball.x()), py(track.back().ball.y()));
  svg += fmt::format("<text x=\"10\" y=\"{:.0f}\">{}</text>\n</svg>\n", height + 23, title);
  return svg;
}

}  // namespace plumbline::game
