#pragma once
#include <string>
#include <vector>

#include "math/Types.h"

namespace plumbline::game {

/// One instant of a run, field coordinates of the server [m, s].
struct TrackPoint {
  double time = 0;
  Vec2 robot = Vec2::Zero();
  Vec2 ball = Vec2::Zero();
  bool fallen = false;
};

/// The run from above as an SVG picture: field, way of the robot (falls marked) and of the ball.
std::string trackPicture(const std::vector<TrackPoint>& track, const std::string& title);

}  // namespace plumbline::game
