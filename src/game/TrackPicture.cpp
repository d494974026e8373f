#include "game/TrackPicture.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace plumbline::game {

namespace {

constexpr double scale = 30;    // pixels per metre
constexpr double margin = 1.2;  // metres around the field

/// Places on the field as places in the picture, in pixels.
struct Paper {
  FieldSize field;
  double x(double metres) const { return scale * (metres + field.length / 2 + margin); }
  double y(double metres) const { return scale * (field.width / 2 + margin - metres); }
};

constexpr double jump = 0.6;        // further between two points nobody goes: it was put there [m]
constexpr double kickSpeed = 1;     // what a kick adds at least [m/s]
constexpr double kickDistance = 1;  // of the robot from the ball it kicked, at most [m]
constexpr double markEvery = 5;     // [s]

/// The parts of a way without the jumps between them.
std::string ways(const Paper& paper, const std::vector<TrackPoint>& track, Vec2 TrackPoint::*member,
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

std::string rectangle(const Paper& paper, double x0, double y0, double x1, double y1, const char* style) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", paper.x(x0),
                     paper.y(y1), scale * (x1 - x0), scale * (y1 - y0), style);
}

std::string text(double x, double y, const std::string& words, const char* style) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, words);
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

std::string fieldLines(const Paper& paper) {
  const char* line = "fill=\"none\" stroke=\"white\" stroke-width=\"2\"";
  const FieldSize& f = paper.field;
  const double goal = f.length / 2, side = f.width / 2, front = goal - f.penaltyDepth,
               area = f.penaltyWidth / 2;
  const double back = goal + f.goalDepth, post = f.goalWidth / 2;
  std::string svg = rectangle(paper, -goal, -side, goal, side, line);
  svg +=
      rectangle(paper, -goal, -area, -front, area, line) + rectangle(paper, front, -area, goal, area, line);
  svg +=
      rectangle(paper, -back, -post, -goal, post, "fill=\"#f2d94e\" fill-opacity=\"0.5\" stroke=\"#f2d94e\"");
  svg +=
      rectangle(paper, goal, -post, back, post, "fill=\"#8ec5ff\" fill-opacity=\"0.5\" stroke=\"#8ec5ff\"");
  svg += fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" {3}/>\n", paper.x(0),
                     paper.y(-side), paper.y(side), line);
  return svg + fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.0f}\" {}/>\n", paper.x(0), paper.y(0),
                           f.centreCircleRadius * scale, line);
}

/// Falls, and every five seconds where robot and ball were.
std::string marks(const Paper& paper, const std::vector<TrackPoint>& track) {
  std::string svg;
  bool fallen = false;
  double next = 0;
  for (const TrackPoint& point : track) {
    if (point.fallen && !fallen)
      svg += text(paper.x(point.robot.x()) + 6, paper.y(point.robot.y()) - 6, "fall",
                  "fill=\"#c00\" font-weight=\"bold\"");
    fallen = point.fallen;
    if (point.time < next) continue;
    svg += dot(paper.x(point.ball.x()), paper.y(point.ball.y()), 3, ballColour);
    svg += dot(paper.x(point.robot.x()), paper.y(point.robot.y()), 4, robotColour);
    svg += text(paper.x(point.robot.x()) + 5, paper.y(point.robot.y()) + 18,
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
  return line(12, robotStyle) + text(54, y, "robot, a dot every 5 s", "") + line(230, ballStyle) +
         text(272, y, "ball", "") + kickMark(334, y - 6) + text(350, y, "kick", "");
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
  const Paper paper{field};
  const double width = scale * (field.length + 2 * margin), height = scale * (field.width + 2 * margin);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"15\">\n",
      width, height + 56);
  svg += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#3a7d44\"/>\n", width, height);
  svg += fieldLines(paper);
  svg += ways(paper, track, &TrackPoint::robot, jump, robotStyle) +
         ways(paper, track, &TrackPoint::ball, 3 * jump, ballStyle);
  svg += marks(paper, track);
  for (const TrackPoint& kick : kicksOf(track))
    svg += kickMark(paper.x(kick.ball.x()), paper.y(kick.ball.y()));
  if (!track.empty())
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\" fill=\"#ff8c1a\" stroke=\"black\"/>\n",
                       paper.x(track.back().ball.x()), paper.y(track.back().ball.y()));
  svg += text(10, height + 23, title, "font-weight=\"bold\"") + legend(height + 46) + "</svg>\n";
  return svg;
}

}  // namespace plumbline::game
