#include "modules/modeling/others/RobotDrawing.h"

#include <fmt/format.h>

#include "field/TeamSize.h"

namespace plumbline {

void drawRobots(Drawing& drawing, const std::vector<OtherRobot>& robots, const shapes::Colour& colour) {
  constexpr std::size_t most = 2 * teamSize;
  constexpr double arm = 0.2;  // of a cross [m]
  for (std::size_t i = 0; i < robots.size() && i < most; ++i) {
    const OtherRobot& robot = robots[i];
    const Vec2& at = robot.position;
    drawing.ellipse(at, robot.covariance, colour, 2, 1.5);
    drawing.point(at, robot.mate ? colour : colours::red, 6);
    const std::string number = robot.number > 0 ? std::to_string(robot.number) : "?";
    drawing.text(at, fmt::format("{} {}", robot.mate ? "mate" : "opp", number), colour);
    if (!robot.fallen) continue;
    for (const double side : {-arm, arm})
      drawing.line(Vec2(at + Vec2(-arm, side)), Vec2(at + Vec2(arm, -side)), colour, 2);
  }
}

}  // namespace plumbline
