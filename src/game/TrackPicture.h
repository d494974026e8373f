#pragma once
#include <string>
#include <vector>

#include "field/FieldSize.h"
#include "math/Types.h"

namespace plumbline::game {

/// One instant of a run, field coordinates of the server [m, s].
struct TrackPoint {
  double time = 0;
  Vec2 robot = Vec2::Zero();
  Vec2 ball = Vec2::Zero();
  bool fallen = false;
};

/// Where and when the ball was kicked: it got faster by 1 m/s within a metre of the robot.
std::vector<TrackPoint> kicksOf(const std::vector<TrackPoint>& track);

/// The run from above as an SVG picture: field, ways of robot and ball with the time, falls and kicks, and a
/// legend. If a robot or ball was moved by a beam or a trainer, its path is interrupted there.
std::string trackPicture(const std::vector<TrackPoint>& track, const std::string& title,
                         const FieldSize& field = {});

}  // namespace plumbline::game
