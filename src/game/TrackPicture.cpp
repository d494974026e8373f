#include "game/TrackPicture.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "field/FieldSvg.h"

namespace plumbline::game {

namespace {

constexpr double scale = 30;    // pixels per metre
constexpr double margin = 1.2;  // metres around the field

constexpr double jump = 0.6;        // further between two points nobody goes: it was put there [m]
constexpr double kickSpeed = 1;     // what a kick adds at least [m/s]
constexpr double kickDistance = 1;  // of the robot from the ball it kicked, at most [m]
constexpr double markEvery = 5;     // [s]

/// The parts of a way without the jumps between them.
std::string ways(const FieldSvg& paper, const std::vector<TrackPoint>& track, Vec2 TrackPoint::*member,
                 double longest, const char* style) {
  std::string svg, points;
  const auto finish = [&] {
    if (!points.empty()) svg += fmt::format("<polyline points=\"{}\" {}/>\n", points, style);
    points.clear();
  };
  const TrackPoint* before = nullptr;
  for (const TrackPoint& point : track) {
    if (before && ((point.*member) - (before->*member)).norm() > longest) finish();
    fmt::format_to(std::back_inserter(points), "{:.1f},{:.1f} ", paper.x((point.*member).x()),
                   paper.y((point.*member).y()));
    before = &point;
  }
  finish();
  return svg;
}

std::string kickMark(double x, double y) {
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}l5 -9l5 9z\" fill=\"#ffe14a\" stroke=\"black\" stroke-width=\"0.8\"/>\n",
      x - 5, y + 4);
}

std::string dot(double x, double y, double radius, const char* colour) {
  return fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\" stroke=\"black\" stroke-width=\"0.8\"/>\n",
      x, y, radius, colour);
}

constexpr const char* robotColour = "#2f6fe8";
constexpr const char* ballColour = "#ff8c1a";
constexpr const char* robotStyle =
    "fill=\"none\" stroke=\"#2f6fe8\" stroke-width=\"3\" stroke-linejoin=\"round\" stroke-linecap=\"round\"";
constexpr const char* ballStyle =
    "fill=\"none\" stroke=\"#ff8c1a\" stroke-width=\"2\" stroke-linejoin=\"round\" stroke-dasharray=\"7 3\"";

/// Falls, and every five seconds where robot and ball were.
std::string marks(const FieldSvg& paper, const std::vector<TrackPoint>& track) {
  std::string svg;
  bool fallen = false;
  double next = 0;
  for (const TrackPoint& point : track) {
    if (point.fallen && !fallen)
      svg += svgText(paper.x(point.robot.x()) + 6, paper.y(point.robot.y()) - 6, "fall",
                     "fill=\"#c00\" font-weight=\"bold\"");
    fallen = point.fallen;
    if (point.time < next) continue;
    svg += dot(paper.x(point.ball.x()), paper.y(point.ball.y()), 3, ballColour);
    svg += dot(paper.x(point.robot.x()), paper.y(point.robot.y()), 4, robotColour);
    svg += svgText(paper.x(point.robot.x()) + 5, paper.y(point.robot.y()) + 18,
                   fmt::format("{:.0f} s", point.time), "fill=\"white\"");
    next += markEvery;
  }
  return svg;
}

std::string legend(double y) {
  const auto line = [&](double x, const char* style) {
    return fmt::format("<line x1=\"{0:.0f}\" y1=\"{2:.0f}\" x2=\"{1:.0f}\" y2=\"{2:.0f}\" {3}/>\n", x, x + 34,
                       y - 5, style);
  };
  return line(12, robotStyle) + svgText(54, y, "robot, a dot every 5 s", "") + line(230, ballStyle) +
         svgText(272, y, "ball", "") + kickMark(334, y - 6) + svgText(350, y, "kick", "");
}

}  // namespace

std::vector<TrackPoint> kicksOf(const std::vector<TrackPoint>& track) {
  std::vector<TrackPoint> kicks;
  double speed = 0;
  for (std::size_t i = 1; i < track.size(); ++i) {
    const TrackPoint &from = track[i - 1], &to = track[i];
    const double passed = to.time - from.time, way = (to.ball - from.ball).norm();
    if (passed <= 0) continue;
    const double now = way > 3 * jump ? 0 : way / passed;  // put elsewhere is not rolled there
    const bool near = (from.ball - from.robot).norm() < kickDistance;
    // One kick takes some points to reach its speed.
    const bool same = !kicks.empty() && from.time - kicks.back().time < 0.5;
    if (now > speed + kickSpeed && near && !same) kicks.push_back(from);
    speed = now;
  }
  return kicks;
}

std::string trackPicture(const std::vector<TrackPoint>& track, const std::string& title,
                         const FieldSize& field) {
  const FieldSvg paper(field, margin, scale);
  std::string svg = paper.head(56) + paper.grass() + paper.lines();
  svg += ways(paper, track, &TrackPoint::robot, jump, robotStyle) +
         ways(paper, track, &TrackPoint::ball, 3 * jump, ballStyle);
  svg += marks(paper, track);
  for (const TrackPoint& kick : kicksOf(track))
    svg += kickMark(paper.x(kick.ball.x()), paper.y(kick.ball.y()));
  if (!track.empty())
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\" fill=\"#ff8c1a\" stroke=\"black\"/>\n",
                       paper.x(track.back().ball.x()), paper.y(track.back().ball.y()));
  svg += svgText(10, paper.height() + 23, title, "font-weight=\"bold\"") + legend(paper.height() + 46) +
         "</svg>\n";
  return svg;
}

}  // namespace plumbline::game
