#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// Another robot on the field, in the frame of the own team (opponent goal at +x) [m, m/s].
struct OtherRobot : public Streamable {
  bool mate = false;  ///< of the own team
  int number = 0;     ///< uniform number 1 to 11; 0: not known
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  Mat2 covariance = Mat2::Identity();  ///< of the position [m^2]
  bool fallen = false;
  double lastSeen = -1;  ///< FrameInfo time of what tells this [s]
  /// Standard deviation of the position per axis [m].
  double deviation() const { return std::sqrt(0.5 * covariance.trace()); }
  void stream(InStream* in, OutStream* out) override {
    STREAM(mate);
    STREAM(number);
    STREAM(position);
    STREAM(velocity);
    STREAM(covariance);
    STREAM(fallen);
    STREAM(lastSeen);
  }
};

/// The others that this robot has seen itself and still follows; at most one of a team and number.
REPRESENTATION(LocalOtherRobots)
class LocalOtherRobots : public LocalOtherRobotsBase {
public:
  std::vector<OtherRobot> robots;
  void stream(InStream* in, OutStream* out) override { STREAM(robots); }
};

/// The other robots: own sight and messages of mates, combined.
REPRESENTATION(OtherRobots)
class OtherRobots : public OtherRobotsBase {
public:
  std::vector<OtherRobot> robots;
  /// Distance of the nearest opponent that stands from a place, infinite without any [m].
  double nearestOpponent(const Vec2& place) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const OtherRobot& robot : robots)
      if (!robot.mate && !robot.fallen) nearest = std::min(nearest, (robot.position - place).norm());
    return nearest;
  }
  void stream(InStream* in, OutStream* out) override { STREAM(robots); }
};

}  // namespace plumbline
