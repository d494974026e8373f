#pragma once
#include "representations/modeling/OtherRobots.h"

namespace plumbline::test {

/// Puts a robot into a list of others; number 0: not known.
inline OtherRobot& addRobot(std::vector<OtherRobot>& robots, bool mate, const Vec2& place, int number = 0) {
  OtherRobot& robot = robots.emplace_back();
  robot.mate = mate;
  robot.number = number;
  robot.position = place;
  return robot;
}

}  // namespace plumbline::test
